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

fn tile_product_0( weights_0 : FloatWeights_0,  row_0 : u32,  inputs_0 : ptr<function, array<f32, i32(64)>>) -> vec4<f32>
{
    var sums_1 : vec4<f32> = vec4<f32>(0.0f);
    var column_0 : u32 = u32(0);
    for(;;)
    {
        if(column_0 < u32(8))
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
        var _S7 : Eight_0 = FloatWeights_eight_0(weights_0, row_0 + u32(8) + column_0);
        sums_1[i32(1)] = sums_1[i32(1)] + (dot(_S7.low_0, low_1) + dot(_S7.high_0, high_1));
        var _S8 : Eight_0 = FloatWeights_eight_0(weights_0, row_0 + u32(16) + column_0);
        sums_1[i32(2)] = sums_1[i32(2)] + (dot(_S8.low_0, low_1) + dot(_S8.high_0, high_1));
        var _S9 : Eight_0 = FloatWeights_eight_0(weights_0, row_0 + u32(24) + column_0);
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

fn dense_part_0( weights_1 : FloatWeights_0,  first_1 : u32,  adds_0 : bool,  inputs_1 : ptr<function, array<f32, i32(64)>>,  outputs_0 : ptr<function, array<f32, i32(50)>>)
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
        var _S14 : vec4<f32> = tile_product_0(weights_1, _S10 + _S12 * u32(8), &((*inputs_1)));
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

fn tile_product_1( weights_2 : HalfWeights_0,  row_1 : u32,  inputs_2 : ptr<function, array<f32, i32(64)>>) -> vec4<f32>
{
    var sums_2 : vec4<f32> = vec4<f32>(0.0f);
    var column_1 : u32 = u32(0);
    for(;;)
    {
        if(column_1 < u32(8))
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
        var _S25 : Eight_0 = HalfWeights_eight_0(weights_2, row_1 + u32(8) + column_1);
        sums_2[i32(1)] = sums_2[i32(1)] + (dot(_S25.low_0, low_2) + dot(_S25.high_0, high_2));
        var _S26 : Eight_0 = HalfWeights_eight_0(weights_2, row_1 + u32(16) + column_1);
        sums_2[i32(2)] = sums_2[i32(2)] + (dot(_S26.low_0, low_2) + dot(_S26.high_0, high_2));
        var _S27 : Eight_0 = HalfWeights_eight_0(weights_2, row_1 + u32(24) + column_1);
        sums_2[i32(3)] = sums_2[i32(3)] + (dot(_S27.low_0, low_2) + dot(_S27.high_0, high_2));
        column_1 = column_1 + u32(1);
    }
    return sums_2;
}

fn dense_part_1( weights_3 : HalfWeights_0,  first_3 : u32,  adds_1 : bool,  inputs_3 : ptr<function, array<f32, i32(64)>>,  outputs_1 : ptr<function, array<f32, i32(52)>>)
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
        var _S32 : vec4<f32> = tile_product_1(weights_3, _S28 + _S30 * u32(8), &((*inputs_3)));
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

fn dense_part_2( weights_5 : HalfWeights_0,  first_4 : u32,  adds_2 : bool,  inputs_5 : ptr<function, array<f32, i32(39)>>,  outputs_2 : ptr<function, array<f32, i32(64)>>)
{
    var _S46 : u32 = first_4 + u32(whole_parts_0(i32(8)));
    var output_2 : i32 = i32(0);
    for(;;)
    {
        var _S47 : bool = output_2 < i32(64);
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
        if(_S53 < i32(64))
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
        if(_S54 < i32(64))
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
        if(_S55 < i32(64))
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

fn tile_product_3( weights_6 : HalfWeights_0,  row_3 : u32,  inputs_6 : ptr<function, array<f32, i32(68)>>) -> vec4<f32>
{
    var sums_4 : vec4<f32> = vec4<f32>(0.0f);
    var column_3 : u32 = u32(0);
    for(;;)
    {
        if(column_3 < u32(9))
        {
        }
        else
        {
            break;
        }
        var low_4 : vec4<f32>;
        var high_4 : vec4<f32>;
        var _S56 : i32 = i32(u32(8) * column_3);
        low_4[i32(0)] = (*inputs_6)[min(_S56, i32(67))];
        high_4[i32(0)] = (*inputs_6)[min(_S56 + i32(4), i32(67))];
        var _S57 : i32 = _S56 + i32(1);
        low_4[i32(1)] = (*inputs_6)[min(_S57, i32(67))];
        high_4[i32(1)] = (*inputs_6)[min(_S57 + i32(4), i32(67))];
        var _S58 : i32 = _S56 + i32(2);
        low_4[i32(2)] = (*inputs_6)[min(_S58, i32(67))];
        high_4[i32(2)] = (*inputs_6)[min(_S58 + i32(4), i32(67))];
        var _S59 : i32 = _S56 + i32(3);
        low_4[i32(3)] = (*inputs_6)[min(_S59, i32(67))];
        high_4[i32(3)] = (*inputs_6)[min(_S59 + i32(4), i32(67))];
        var _S60 : Eight_0 = HalfWeights_eight_0(weights_6, row_3 + column_3);
        sums_4[i32(0)] = sums_4[i32(0)] + (dot(_S60.low_0, low_4) + dot(_S60.high_0, high_4));
        var _S61 : Eight_0 = HalfWeights_eight_0(weights_6, row_3 + u32(9) + column_3);
        sums_4[i32(1)] = sums_4[i32(1)] + (dot(_S61.low_0, low_4) + dot(_S61.high_0, high_4));
        var _S62 : Eight_0 = HalfWeights_eight_0(weights_6, row_3 + u32(18) + column_3);
        sums_4[i32(2)] = sums_4[i32(2)] + (dot(_S62.low_0, low_4) + dot(_S62.high_0, high_4));
        var _S63 : Eight_0 = HalfWeights_eight_0(weights_6, row_3 + u32(27) + column_3);
        sums_4[i32(3)] = sums_4[i32(3)] + (dot(_S63.low_0, low_4) + dot(_S63.high_0, high_4));
        column_3 = column_3 + u32(1);
    }
    return sums_4;
}

fn dense_part_3( weights_7 : HalfWeights_0,  first_5 : u32,  adds_3 : bool,  inputs_7 : ptr<function, array<f32, i32(68)>>,  outputs_3 : ptr<function, array<f32, i32(64)>>)
{
    var _S64 : u32 = first_5 + u32(whole_parts_0(i32(8)));
    var output_3 : i32 = i32(0);
    for(;;)
    {
        var _S65 : bool = output_3 < i32(64);
        if(_S65)
        {
        }
        else
        {
            break;
        }
        var _S66 : u32 = u32(output_3);
        var _S67 : Eight_0 = HalfWeights_eight_0(weights_7, first_5 + _S66 / u32(8));
        var _S68 : vec4<f32> = tile_product_3(weights_7, _S64 + _S66 * u32(9), &((*inputs_7)));
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
        if(_S71 < i32(64))
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
        if(_S72 < i32(64))
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
        if(_S73 < i32(64))
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

fn dense_part_5( weights_10 : HalfWeights_0,  first_7 : u32,  adds_5 : bool,  inputs_10 : ptr<function, array<f32, i32(64)>>,  outputs_5 : ptr<function, array<f32, i32(64)>>)
{
    var _S92 : u32 = first_7 + u32(whole_parts_0(i32(8)));
    var output_5 : i32 = i32(0);
    for(;;)
    {
        var _S93 : bool = output_5 < i32(64);
        if(_S93)
        {
        }
        else
        {
            break;
        }
        var _S94 : u32 = u32(output_5);
        var _S95 : Eight_0 = HalfWeights_eight_0(weights_10, first_7 + _S94 / u32(8));
        var _S96 : vec4<f32> = tile_product_1(weights_10, _S92 + _S94 * u32(8), &((*inputs_10)));
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
        if(_S99 < i32(64))
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
        if(_S100 < i32(64))
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
        if(_S101 < i32(64))
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

fn dense_part_6( weights_11 : HalfWeights_0,  first_8 : u32,  adds_6 : bool,  inputs_11 : ptr<function, array<f32, i32(68)>>,  outputs_6 : ptr<function, array<f32, i32(16)>>)
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
        var _S106 : vec4<f32> = tile_product_3(weights_11, _S102 + _S104 * u32(9), &((*inputs_11)));
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

fn dense_part_7( weights_13 : HalfWeights_0,  first_9 : u32,  adds_7 : bool,  inputs_13 : ptr<function, array<f32, i32(88)>>,  outputs_7 : ptr<function, array<f32, i32(64)>>)
{
    var _S120 : u32 = first_9 + u32(whole_parts_0(i32(8)));
    var output_7 : i32 = i32(0);
    for(;;)
    {
        var _S121 : bool = output_7 < i32(64);
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
        if(_S127 < i32(64))
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
        if(_S128 < i32(64))
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
        if(_S129 < i32(64))
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

fn dense_0( weights_14 : FloatWeights_0,  first_10 : u32,  adds_8 : bool,  inputs_14 : ptr<function, array<f32, i32(64)>>,  outputs_8 : ptr<function, array<f32, i32(50)>>)
{
    dense_part_0(weights_14, first_10, adds_8, &((*inputs_14)), &((*outputs_8)));
    return;
}

fn dense_1( weights_15 : HalfWeights_0,  first_11 : u32,  adds_9 : bool,  inputs_15 : ptr<function, array<f32, i32(64)>>,  outputs_9 : ptr<function, array<f32, i32(52)>>)
{
    dense_part_1(weights_15, first_11, adds_9, &((*inputs_15)), &((*outputs_9)));
    return;
}

fn dense_2( weights_16 : HalfWeights_0,  first_12 : u32,  adds_10 : bool,  inputs_16 : ptr<function, array<f32, i32(64)>>,  outputs_10 : ptr<function, array<f32, i32(64)>>)
{
    dense_part_5(weights_16, first_12, adds_10, &((*inputs_16)), &((*outputs_10)));
    return;
}

fn dense_3( weights_17 : HalfWeights_0,  first_13 : u32,  adds_11 : bool,  inputs_17 : ptr<function, array<f32, i32(39)>>,  outputs_11 : ptr<function, array<f32, i32(64)>>)
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

fn dense_4( weights_18 : HalfWeights_0,  first_14 : u32,  adds_12 : bool,  inputs_18 : ptr<function, array<f32, i32(68)>>,  outputs_12 : ptr<function, array<f32, i32(64)>>)
{
    dense_part_3(weights_18, first_14, adds_12, &((*inputs_18)), &((*outputs_12)));
    return;
}

fn dense_5( weights_19 : HalfWeights_0,  first_15 : u32,  adds_13 : bool,  inputs_19 : ptr<function, array<f32, i32(16)>>,  outputs_13 : ptr<function, array<f32, i32(1)>>)
{
    dense_part_4(weights_19, first_15, adds_13, &((*inputs_19)), &((*outputs_13)));
    return;
}

fn dense_6( weights_20 : HalfWeights_0,  first_16 : u32,  adds_14 : bool,  inputs_20 : ptr<function, array<f32, i32(68)>>,  outputs_14 : ptr<function, array<f32, i32(16)>>)
{
    dense_part_6(weights_20, first_16, adds_14, &((*inputs_20)), &((*outputs_14)));
    return;
}

fn dense_part_8( weights_21 : HalfWeights_0,  first_17 : u32,  adds_15 : bool,  inputs_21 : ptr<function, array<f32, i32(64)>>,  outputs_15 : ptr<function, array<f32, i32(68)>>)
{
    var _S130 : u32 = first_17 + u32(whole_parts_0(i32(8)));
    var output_8 : i32 = i32(0);
    for(;;)
    {
        var _S131 : bool = output_8 < i32(64);
        if(_S131)
        {
        }
        else
        {
            break;
        }
        var _S132 : u32 = u32(output_8);
        var _S133 : Eight_0 = HalfWeights_eight_0(weights_21, first_17 + _S132 / u32(8));
        var _S134 : vec4<f32> = tile_product_1(weights_21, _S130 + _S132 * u32(8), &((*inputs_21)));
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
        if(_S137 < i32(64))
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
        if(_S138 < i32(64))
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
        if(_S139 < i32(64))
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

fn dense_7( weights_22 : HalfWeights_0,  first_18 : u32,  adds_16 : bool,  inputs_22 : ptr<function, array<f32, i32(88)>>,  outputs_16 : ptr<function, array<f32, i32(64)>>)
{
    dense_part_7(weights_22, first_18, adds_16, &((*inputs_22)), &((*outputs_16)));
    return;
}

var<private> PYRAMID_RADII_0 : array<f32, i32(4)> = array<f32, i32(4)>( 1.0f, 2.0f, 4.0f, 8.0f );
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

struct SearchQuality_0
{
     steps_per_thread_0 : f32,
     steps_per_relief_0 : f32,
     shadow_share_0 : f32,
     refinements_0 : u32,
};

fn default_quality_0() -> SearchQuality_0
{
    var quality_0 : SearchQuality_0;
    quality_0.steps_per_thread_0 = 5.0f;
    quality_0.steps_per_relief_0 = 8.0f;
    quality_0.shadow_share_0 = 1.0f;
    quality_0.refinements_0 = u32(2);
    return quality_0;
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

fn shown_at_0( crossing_0 : Crossing_0,  back_3 : bool) -> Shown_0
{
    var _S216 : bool = (abs(crossing_0.warp_1.across_0)) < (crossing_0.warp_1.half_width_1);
    var shown_0 : Shown_0;
    var _S217 : bool = !((abs(crossing_0.weft_1.across_0)) < (crossing_0.weft_1.half_width_1));
    var _S218 : bool = (_S216 & (((_S217 | ((crossing_0.warp_above_0))))));
    shown_0.is_warp_0 = _S218;
    shown_0.hole_0 = ((!_S216) & (_S217));
    var _S219 : u32 = select(crossing_0.weft_word_0, crossing_0.warp_word_0, _S218);
    shown_0.word_0 = _S219;
    shown_0.on_top_0 = (((_S219 & (u32(1)))) == u32(1)) != back_3;
    return shown_0;
}

fn select_cell_0( is_first_0 : bool,  first_22 : Cell_0,  second_1 : Cell_0) -> Cell_0
{
    var cell_5 : Cell_0;
    cell_5.thread_1 = select(second_1.thread_1, first_22.thread_1, is_first_0);
    cell_5.across_0 = select(second_1.across_0, first_22.across_0, is_first_0);
    cell_5.half_width_1 = select(second_1.half_width_1, first_22.half_width_1, is_first_0);
    cell_5.below_0 = select(second_1.below_0, first_22.below_0, is_first_0);
    cell_5.above_0 = select(second_1.above_0, first_22.above_0, is_first_0);
    return cell_5;
}

fn boundary_0( family_9 : u32,  thread_3 : u32,  step_0 : i32) -> f32
{
    var _S220 : vec2<f32> = turns_and_remainder_0(family_9, f32(i32(thread_3) + step_0));
    return fma(_S220.x, families_0[family_9].period_0, table_number_0(families_0[family_9].place_table_0 + u32(_S220.y) * u32(4)));
}

fn span_0( family_10 : u32,  thread_4 : u32,  first_23 : i32,  last_0 : i32) -> f32
{
    if((families_0[family_10].is_alike_0) != u32(0))
    {
        return f32(last_0 - first_23) * families_0[family_10].size_0;
    }
    return boundary_0(family_10, thread_4, last_0) - boundary_0(family_10, thread_4, first_23);
}

struct Bend_0
{
     sine_0 : f32,
     half_tangent_0 : f32,
     arc_0 : f32,
};

fn bend_of_0( family_11 : u32,  thread_5 : u32) -> Bend_0
{
    var _S221 : u32 = families_0[family_11].bend_table_0 + select(thread_5 * u32(4), u32(0), (families_0[family_11].is_alike_0) != u32(0));
    var bend_0 : Bend_0;
    bend_0.sine_0 = table_number_0(_S221);
    bend_0.half_tangent_0 = table_number_0(_S221 + u32(1));
    bend_0.arc_0 = table_number_0(_S221 + u32(2));
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

fn unpack_0( own_0 : u32,  other_0 : u32,  thread_6 : u32,  crossed_0 : Cell_0,  word_1 : u32) -> Run_0
{
    var _S222 : i32 = i32((((word_1 >> (u32(1)))) & (u32(127))));
    var _S223 : i32 = i32((((word_1 >> (u32(8)))) & (u32(127))));
    var _S224 : i32 = i32((((word_1 >> (u32(15)))) & (u32(63))));
    var _S225 : i32 = i32((((word_1 >> (u32(21)))) & (u32(63))));
    var run_0 : Run_0;
    var _S226 : bool = ((((word_1 >> (u32(27)))) & (u32(1)))) == u32(1);
    run_0.straight_0 = _S226;
    var _S227 : i32 = - _S222;
    var _S228 : f32 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_1, _S227, i32(0));
    run_0.from_start_0 = _S228;
    var _S229 : i32 = _S223 + i32(1);
    var _S230 : f32 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_1, i32(1), _S229);
    run_0.to_end_0 = _S230;
    var _S231 : bool = _S228 < _S230;
    run_0.near_start_0 = _S231;
    var _S232 : i32 = select(_S229, _S227 - _S224, _S231);
    var _S233 : i32 = select(_S229 + _S225, _S227, _S231);
    run_0.bend_1 = bend_of_0(own_0, thread_6);
    run_0.distance_0 = select(min(_S228, _S230), 1.0e+06f, _S226);
    run_0.reach_0 = min(0.5f * (_S228 + _S230), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_1, _S232, _S233), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S222 == i32(0);
    run_0.last_crossing_0 = _S223 == i32(0);
    return run_0;
}

struct Section_0
{
     across_1 : f32,
     drop_0 : f32,
     slope_0 : f32,
};

fn section_at_0( cell_6 : Cell_0) -> Section_0
{
    var _S234 : f32 = cell_6.half_width_1 * 1.0154266357421875f;
    var section_0 : Section_0;
    var _S235 : f32 = clamp(cell_6.across_0, - cell_6.half_width_1, cell_6.half_width_1);
    section_0.across_1 = _S235;
    var _S236 : f32 = _S234 * _S234 - square_1(_S235);
    var _S237 : f32 = rsqrt_0(_S236);
    section_0.drop_0 = _S234 - _S236 * _S237;
    section_0.slope_0 = - _S235 * _S237;
    return section_0;
}

fn edge_drop_0( family_12 : u32,  thread_7 : u32,  step_1 : i32) -> f32
{
    return table_number_0(families_0[family_12].bend_table_0 + select(u32(turns_and_remainder_0(family_12, f32(i32(thread_7) + step_1)).y) * u32(4), u32(0), (families_0[family_12].is_alike_0) != u32(0)) + u32(3));
}

fn dive_0( other_1 : u32,  shown_1 : Shown_0,  run_1 : Run_0,  crossed_1 : Cell_0) -> vec3<f32>
{
    var _S238 : bool = (crossed_1.below_0) < (crossed_1.above_0);
    var _S239 : f32 = min(crossed_1.below_0, crossed_1.above_0);
    var _S240 : f32 = select(crossed_1.above_0 + crossed_1.across_0, crossed_1.below_0 - crossed_1.across_0, _S238) - crossed_1.half_width_1;
    var _S241 : bool = select(run_1.last_crossing_0, run_1.first_crossing_0, _S238);
    var _S242 : f32;
    if(shown_1.on_top_0)
    {
        _S242 = 0.0f;
    }
    else
    {
        _S242 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_1, i32(0));
    }
    var _S243 : f32;
    if((shown_1.on_top_0) != _S241)
    {
        _S243 = 0.0f;
    }
    else
    {
        _S243 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_1, select(i32(1), i32(-1), _S238));
    }
    var _S244 : f32 = 2.0f * _S240;
    var _S245 : f32 = 1.0f / max(_S244, 9.999999960041972e-13f);
    var _S246 : f32 = clamp((_S240 - _S239) * _S245, 0.0f, 1.0f);
    var _S247 : f32 = clamp((0.44999998807907104f - _S244 / crossed_1.half_width_1) * 4.0000004768371582f, 0.0f, 1.0f);
    return vec3<f32>(_S242 + (_S243 - _S242) * (_S246 * _S246 * (3.0f - 2.0f * _S246)), (_S242 - _S243) * (6.0f * _S246 * (1.0f - _S246) * _S245) * select(-1.0f, 1.0f, _S238), _S247 * _S247 * (3.0f - 2.0f * _S247));
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

fn step_control_0( direction_2 : vec2<f32>,  step_3 : f32) -> StepControl_0
{
    var control_0 : StepControl_0;
    control_0.step_2 = step_3;
    control_0.epsilon_0 = 0.00499999988824129f * step_3;
    var _S248 : f32 = direction_2.x;
    control_0.per_x_0 = 1.0f / max(abs(_S248), 9.99999971718068537e-10f);
    var _S249 : f32 = direction_2.y;
    control_0.per_y_0 = 1.0f / max(abs(_S249), 9.99999971718068537e-10f);
    control_0.right_0 = _S248 > 0.0f;
    control_0.up_0 = _S249 > 0.0f;
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

fn outline_distance_0( cell_7 : Cell_0,  shown_2 : Shown_0,  run_2 : Run_0,  lengthwise_0 : bool,  forwards_0 : bool) -> f32
{
    var _S250 : f32 = select(- cell_7.across_0, cell_7.across_0, forwards_0);
    var _S251 : f32 = select(cell_7.below_0, cell_7.above_0, forwards_0);
    var _S252 : f32 = - cell_7.half_width_1;
    var _S253 : bool = _S250 < _S252;
    var _S254 : bool = _S250 >= (cell_7.half_width_1);
    var _S255 : bool = (((lengthwise_0 & ((!select(run_2.first_crossing_0, run_2.last_crossing_0, forwards_0))))) & ((!shown_2.hole_0)));
    var _S256 : f32 = select(cell_7.half_width_1, _S252, _S253) - _S250;
    var _S257 : f32 = select(_S251, 2.0f * _S251 + _S250 - cell_7.half_width_1, ((shown_2.hole_0) | (((_S255 & ((!shown_2.on_top_0)))))));
    if((((_S255 & ((shown_2.on_top_0)))) & ((!((select(run_2.last_crossing_0, run_2.first_crossing_0, forwards_0) & (_S253)))))))
    {
        return select(run_2.from_start_0, run_2.to_end_0, forwards_0);
    }
    return select(_S256, _S257, _S254);
}

struct Probe_0
{
     height_2 : f32,
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
    var _S258 : f32 = previous_1.rate_0 * step_4;
    var _S259 : f32 = rate_1 * step_4;
    if(((((((((!previous_1.known_0) | ((here_0.hole_1)))) | (((previous_1.yarn_0) != (here_0.yarn_1))))) | (((previous_1.rate_0) >= 0.0f)))) | ((rate_1 <= 0.0f))))
    {
        return -1.0f;
    }
    if((((3.0f * previous_1.clearance_0 + _S258) >= 0.0f) & (((3.0f * clearance_1 - _S259) >= 0.0f))))
    {
        return -1.0f;
    }
    var _S260 : f32 = clearance_1 - previous_1.clearance_0;
    var _S261 : f32 = 6.0f * _S260 - 4.0f * _S258 - 2.0f * _S259;
    var _S262 : f32 = -2.0f * _S258 / max(_S261 + sqrt(max(_S261 * _S261 - 4.0f * (3.0f * (_S258 + _S259 - 2.0f * _S260)) * _S258, 0.0f)), 9.99999968265522539e-21f);
    var _S263 : f32 = 1.0f - _S262;
    return select(-1.0f, _S263 * step_4, ((((_S262 > 0.01999999955296516f) & ((_S263 > 0.01999999955296516f)))) & ((((previous_1.clearance_0 * (2.0f * _S262 + 1.0f) + _S258 * _S262) * _S263 * _S263 + (clearance_1 * (2.0f * _S263 + 1.0f) - _S259 * _S263) * _S262 * _S262) < 0.0f))));
}

fn after_sample_0( clearance_2 : f32,  rate_2 : f32,  here_1 : Probe_0,  is_cell_exit_0 : bool) -> PreviousSample_0
{
    var previous_2 : PreviousSample_0;
    previous_2.clearance_0 = select(clearance_2, 1.0e+09f, here_1.hole_1);
    previous_2.rate_0 = rate_2;
    previous_2.yarn_0 = here_1.yarn_1;
    previous_2.known_0 = ((!here_1.hole_1) & ((!is_cell_exit_0)));
    return previous_2;
}

fn StepControl_to_cell_exit_0( this_4 : StepControl_0,  side_x_1 : f32,  side_y_1 : f32) -> f32
{
    return max(min(side_x_1 * this_4.per_x_0, side_y_1 * this_4.per_y_0), 0.0f) + this_4.epsilon_0;
}

fn StepControl_to_next_sample_0( this_5 : StepControl_0,  here_2 : Probe_0,  clearance_3 : f32,  rate_3 : f32) -> f32
{
    var _S264 : f32 = min(here_2.edge_x_0 * this_5.per_x_0, here_2.edge_y_0 * this_5.per_y_0);
    return min(this_5.step_2, select(max(_S264, 0.0f) + this_5.epsilon_0, _S264 - this_5.epsilon_0, ((((!here_2.hole_1) & (((rate_3 * _S264 + clearance_3) < 0.0f)))) & ((_S264 > (2.0f * this_5.epsilon_0))))));
}

struct ViewRay_0
{
     origin_0 : vec2<f32>,
     slope_1 : vec2<f32>,
};

fn ViewRay_at_0( this_6 : ViewRay_0,  height_3 : f32) -> vec2<f32>
{
    return this_6.origin_0 + this_6.slope_1 * vec2<f32>(height_3);
}

fn ViewRay_rate_0( this_7 : ViewRay_0,  here_3 : Probe_0) -> f32
{
    return here_3.slope_x_0 * this_7.slope_1.x + here_3.slope_y_0 * this_7.slope_1.y - 1.0f;
}

fn cubic_root_0( start_1 : f32,  end_0 : f32,  start_rate_0 : f32,  end_rate_0 : f32) -> f32
{
    var _S265 : f32 = end_0 - start_1;
    var _S266 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S265;
    var _S267 : f32 = 3.0f * _S265 - 2.0f * start_rate_0 - end_rate_0;
    var share_1 : f32 = start_1 / max(- _S265, 9.99999968265522539e-21f);
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
        var _S268 : f32 = clamp(share_1 - (((_S266 * share_1 + _S267) * share_1 + start_rate_0) * share_1 + start_1) / min((3.0f * _S266 * share_1 + 2.0f * _S267) * share_1 + start_rate_0, 0.10000000149011612f * _S265 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S269 : i32 = i_0 + i32(1);
        share_1 = _S268;
        i_0 = _S269;
    }
    return share_1;
}

fn between_0( above_1 : f32,  under_0 : f32,  above_gap_0 : f32,  under_gap_0 : f32) -> f32
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

fn footprint_coordinates_0( taps_0 : AnisotropicTaps_0) -> vec3<f32>
{
    return vec3<f32>(taps_0.centre_1 - floor(taps_0.centre_1), clamp(natural_logarithm_0(max(AnisotropicTaps_size_0(taps_0), 9.99999997475242708e-07f) / 0.015625f) * 0.11708354949951172f, 0.0f, 1.0f));
}

fn wrapped_0( index_3 : f32,  count_1 : f32) -> f32
{
    return select(select(index_3, index_3 - count_1, index_3 >= count_1), index_3 + count_1, index_3 < 0.0f);
}

fn AnisotropicTaps_has_steps_0( this_8 : AnisotropicTaps_0) -> bool
{
    var _S270 : vec2<f32> = this_8.first_21;
    var _S271 : vec2<f32> = this_8.second_0;
    return (max(dot(_S270, _S270), dot(_S271, _S271))) > 0.0f;
}

fn AnisotropicTaps_place_0( this_9 : AnisotropicTaps_0,  number_1 : u32) -> vec2<f32>
{
    return this_9.centre_1 + vec2<f32>(select(-1.0f, 1.0f, number_1 >= u32(2))) * this_9.first_21 + vec2<f32>(select(-1.0f, 1.0f, ((number_1 & (u32(1)))) != u32(0))) * this_9.second_0;
}

fn bump_0( distance_1 : f32) -> f32
{
    var _S272 : f32 = max(1.0f - distance_1 * distance_1, 0.0f);
    return _S272 * _S272;
}

struct Yarns_0
{
     warp_2 : vec4<f32>,
     weft_2 : vec4<f32>,
     shares_0 : vec3<f32>,
};

fn Yarns_x24init_0( warp_3 : vec4<f32>,  weft_3 : vec4<f32>,  shares_1 : vec3<f32>) -> Yarns_0
{
    var _S273 : Yarns_0;
    _S273.warp_2 = warp_3;
    _S273.weft_2 = weft_3;
    _S273.shares_0 = shares_1;
    return _S273;
}

fn irregular_over_0( family_13 : u32,  key_4 : u32,  place_1 : f32,  width_2 : f32,  along_1 : f32,  length_0 : f32) -> vec4<f32>
{
    var _S274 : f32 = max(width_2, 0.0625f);
    var _S275 : f32 = min(_S274, 64.0f);
    var _S276 : f32 = max(length_0 / 2.0f, 1.0f);
    var _S277 : f32 = along_1 / 2.0f - 0.5f * _S276;
    var _S278 : f32 = 0.5f * _S275;
    var _S279 : vec2<f32> = floor(vec2<f32>(place_1 - _S278, place_1 + _S278) / vec2<f32>(64.0f));
    var _S280 : vec4<f32> = vec4<f32>(0.0f);
    var number_2 : u32 = u32(0);
    var sums_8 : vec4<f32> = _S280;
    for(;;)
    {
        if(number_2 < u32(6))
        {
        }
        else
        {
            break;
        }
        var _S281 : bool = number_2 >= u32(3);
        var _S282 : u32 = select(number_2, number_2 - u32(3), _S281);
        var _S283 : f32 = select(-1.0f, 1.0f, _S281);
        var _S284 : f32 = _S279.y;
        var _S285 : f32 = _S279.x;
        var _S286 : f32 = select(_S285, _S284, _S281);
        var _S287 : f32 = place_1 + _S283 * 0.5f * _S275 - 64.0f * _S286;
        var _S288 : f32 = clamp(floor(_S287), 0.0f, 63.0f);
        var _S289 : f32 = _S287 - _S288;
        var _S290 : f32 = select(select(64.0f, 0.0f, _S281), _S288 + f32(_S282), _S282 < u32(2));
        var _S291 : f32 = _S283 * select(select(select(0.0f, -1.0f, _S285 != _S284), _S289, _S282 == u32(1)), 1.0f - _S289, _S282 == u32(0));
        if(_S291 == 0.0f)
        {
            number_2 = number_2 + u32(1);
            continue;
        }
        var _S292 : u32 = hash_bits_0(key_4, u32(i32(_S286)));
        sums_8 = sums_8 + vec4<f32>(_S291) * irregular_integral_0(family_13, ((_S292 & (u32(127)))) + u32(_S290), _S277 + f32((_S292 >> (u32(22)))), _S276);
        number_2 = number_2 + u32(1);
    }
    return sums_8 * irregular_units_0(family_13) * vec4<f32>((sqrt(_S275 / _S274) / (_S275 * _S276)));
}

fn shown_of_covers_0( covers_0 : vec2<f32>,  warp_on_top_1 : f32) -> vec3<f32>
{
    var _S293 : f32 = covers_0.x;
    var _S294 : f32 = covers_0.y;
    return vec3<f32>(_S293 * (1.0f - _S294 * (1.0f - warp_on_top_1)), _S294 * (1.0f - _S293 * warp_on_top_1), (1.0f - _S293) * (1.0f - _S294));
}

fn correction_weight_of_0( coded_size_0 : f32) -> f32
{
    return clamp((coded_size_0 - 0.4869367778301239f) * 6.16096401214599609f, 0.0f, 1.0f);
}

struct Bound_0
{
     thread_8 : u32,
     turns_2 : f32,
     cell_8 : f32,
     visible_0 : f32,
     width_3 : f32,
     gap_0 : f32,
};

fn bound_at_0( family_14 : u32,  position_5 : f32) -> Bound_0
{
    var _S295 : Cell_0 = locate_0(family_14, position_5);
    var _S296 : f32 = table_number_0(families_0[family_14].before_0 + u32(2) * _S295.thread_1 + u32(1));
    var bound_0 : Bound_0;
    bound_0.thread_8 = _S295.thread_1;
    bound_0.turns_2 = round((position_5 - families_0[family_14].start_0 - _S296 - _S295.below_0) * families_0[family_14].inverse_period_0);
    bound_0.cell_8 = _S295.below_0;
    var _S297 : f32 = 2.0f * _S295.half_width_1;
    bound_0.width_3 = _S297;
    bound_0.visible_0 = clamp((_S295.across_0 + _S295.half_width_1) / _S297, 0.0f, 1.0f);
    bound_0.gap_0 = min(_S295.below_0, _S295.below_0 - _S295.across_0 - _S295.half_width_1) + max(_S295.across_0 - _S295.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
     low_7 : Bound_0,
     high_7 : Bound_0,
};

fn stretch_of_0( family_15 : u32,  centre_2 : f32,  size_3 : f32) -> Stretch_0
{
    var _S298 : f32 = centre_2 - floor((centre_2 - families_0[family_15].start_0) * families_0[family_15].inverse_period_0) * families_0[family_15].period_0;
    var _S299 : f32 = 0.5f * max(size_3, families_0[family_15].smallest_box_0);
    var stretch_0 : Stretch_0;
    stretch_0.low_7 = bound_at_0(family_15, _S298 - _S299);
    stretch_0.high_7 = bound_at_0(family_15, _S298 + _S299);
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

fn Stretch_turns_0( this_10 : Stretch_0) -> f32
{
    return this_10.high_7.turns_2 - this_10.low_7.turns_2;
}

fn lengths_0( family_16 : u32,  stretch_1 : Stretch_0) -> vec3<f32>
{
    var _S300 : f32 = Stretch_turns_0(stretch_1);
    var _S301 : u32 = families_0[family_16].before_0 + u32(2) * stretch_1.low_7.thread_8;
    var _S302 : u32 = families_0[family_16].before_0 + u32(2) * stretch_1.high_7.thread_8;
    var _S303 : f32 = table_number_0(_S302) - table_number_0(_S301);
    var _S304 : f32 = table_number_0(_S302 + u32(1)) - table_number_0(_S301 + u32(1));
    return vec3<f32>(_S303 + stretch_1.high_7.visible_0 * stretch_1.high_7.width_3 - stretch_1.low_7.visible_0 * stretch_1.low_7.width_3 + _S300 * families_0[family_16].visible_total_0, _S304 - _S303 + stretch_1.high_7.gap_0 - stretch_1.low_7.gap_0 + _S300 * (families_0[family_16].period_0 - families_0[family_16].visible_total_0), _S304 + stretch_1.high_7.cell_8 - stretch_1.low_7.cell_8 + _S300 * families_0[family_16].period_0);
}

fn integrals_along_0( family_17 : u32,  stretch_2 : Stretch_0,  quantity_0 : u32) -> vec2<f32>
{
    var _S305 : u32 = u32(3) * families_0[family_17].quantities_0;
    var _S306 : u32 = families_0[family_17].colour_threads_0 + _S305 * stretch_2.low_7.thread_8 + quantity_0;
    var _S307 : u32 = families_0[family_17].colour_threads_0 + _S305 * stretch_2.high_7.thread_8 + quantity_0;
    var _S308 : u32 = families_0[family_17].colour_threads_0 + _S305 * u32(families_0[family_17].count_0) + quantity_0;
    var _S309 : f32 = table_number_0(_S306);
    var _S310 : f32 = table_number_0(_S307);
    var _S311 : f32 = Stretch_turns_0(stretch_2);
    var _S312 : u32 = u32(2) * families_0[family_17].quantities_0;
    return vec2<f32>(table_number_0(_S307 + families_0[family_17].quantities_0) - table_number_0(_S306 + families_0[family_17].quantities_0) + _S310 * stretch_2.high_7.visible_0 * stretch_2.high_7.width_3 - _S309 * stretch_2.low_7.visible_0 * stretch_2.low_7.width_3 + _S311 * table_number_0(_S308 + families_0[family_17].quantities_0), table_number_0(_S307 + _S312) - table_number_0(_S306 + _S312) + _S310 * stretch_2.high_7.cell_8 - _S309 * stretch_2.low_7.cell_8 + _S311 * table_number_0(_S308 + _S312));
}

fn Stretch_wraps_0( this_11 : Stretch_0) -> bool
{
    return (this_11.high_7.thread_8) < (this_11.low_7.thread_8);
}

fn Stretch_differences_0( this_12 : Stretch_0,  entries_0 : vec4<u32>,  whole_0 : u32) -> vec4<u32>
{
    var _S313 : u32 = entries_0.z;
    var _S314 : u32 = entries_0.x;
    return vec4<u32>(_S313 - _S314 + select(u32(0), whole_0, Stretch_wraps_0(this_12)), entries_0.w - _S313, entries_0.y - _S314, whole_0);
}

fn row_differences_0( across_2 : Stretch_0,  row_8 : u32,  count_2 : u32,  quantities_1 : u32) -> vec4<u32>
{
    var _S315 : u32 = row_8 + across_2.low_7.thread_8 * quantities_1;
    var _S316 : u32 = row_8 + across_2.high_7.thread_8 * quantities_1;
    return Stretch_differences_0(across_2, vec4<u32>(words_0[_S315], words_0[_S315 + quantities_1], words_0[_S316], words_0[_S316 + quantities_1]), words_0[row_8 + count_2 * quantities_1]);
}

fn Stretch_weights_0( this_13 : Stretch_0) -> vec4<f32>
{
    return vec4<f32>(1.0f, this_13.high_7.visible_0, - this_13.low_7.visible_0, Stretch_turns_0(this_13) - select(0.0f, 1.0f, Stretch_wraps_0(this_13)));
}

fn integral_on_top_0( family_18 : u32,  across_3 : Stretch_0,  along_2 : Stretch_0,  crossing_count_0 : u32,  quantity_1 : u32) -> f32
{
    var _S317 : u32 = u32(families_0[family_18].count_0);
    var _S318 : u32 = (_S317 + u32(1)) * families_0[family_18].quantities_0;
    var _S319 : u32 = families_0[family_18].colour_areas_0 + quantity_1;
    var _S320 : vec4<u32> = row_differences_0(across_3, _S319 + along_2.low_7.thread_8 * _S318, _S317, families_0[family_18].quantities_0);
    var _S321 : vec4<u32> = row_differences_0(across_3, _S319 + along_2.high_7.thread_8 * _S318, _S317, families_0[family_18].quantities_0);
    var _S322 : vec4<u32> = row_differences_0(across_3, _S319 + crossing_count_0 * _S318, _S317, families_0[family_18].quantities_0);
    var _S323 : vec4<f32> = Stretch_weights_0(across_3);
    return dot(vec4<f32>(dot(vec4<f32>(vec4<i32>(_S321 - _S320 + select_vector_3(Stretch_wraps_0(along_2), _S322, vec4<u32>(vec4<i32>(i32(0)))))), _S323), dot(vec4<f32>(vec4<i32>(row_differences_0(across_3, _S319 + (along_2.high_7.thread_8 + u32(1)) * _S318, _S317, families_0[family_18].quantities_0) - _S321)), _S323), dot(vec4<f32>(vec4<i32>(row_differences_0(across_3, _S319 + (along_2.low_7.thread_8 + u32(1)) * _S318, _S317, families_0[family_18].quantities_0) - _S320)), _S323), dot(vec4<f32>(vec4<i32>(_S322)), _S323)), Stretch_weights_0(along_2)) * families_0[family_18].area_unit_0;
}

fn with_added_albedos_0( albedos_1 : Albedos_0,  weight_0 : f32,  row_9 : u32) -> Albedos_0
{
    var _S324 : Albedos_0 = table_albedos_0(row_9);
    var sum_0 : Albedos_0;
    var _S325 : vec3<f32> = vec3<f32>(weight_0);
    sum_0.diffuse_reflect_0 = albedos_1.diffuse_reflect_0 + _S325 * _S324.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_1.diffuse_transmit_0 + _S325 * _S324.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_1.specular_reflect_0 + _S325 * _S324.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_1.specular_transmit_0 + _S325 * _S324.specular_transmit_0;
    return sum_0;
}

fn mean_albedos_0( family_19 : u32,  crossing_1 : u32,  own_1 : Stretch_0,  other_2 : Stretch_0,  back_4 : bool) -> Albedos_0
{
    var albedos_2 : Albedos_0 = table_albedos_0(families_0[family_19].colour_mean_0);
    if((families_0[family_19].quantities_0) == u32(1))
    {
        return albedos_2;
    }
    var _S326 : vec3<f32> = lengths_0(crossing_1, other_2);
    var is_exposed_0 : bool = false;
    var weight_1 : f32 = 0.0f;
    var quantity_2 : u32 = u32(0);
    for(;;)
    {
        if(quantity_2 < (families_0[family_19].quantities_0))
        {
        }
        else
        {
            break;
        }
        var _S327 : vec2<f32> = integrals_along_0(family_19, own_1, quantity_2);
        var _S328 : f32 = integral_on_top_0(family_19, own_1, other_2, u32(families_0[crossing_1].count_0), quantity_2);
        var _S329 : f32 = _S327.x;
        var _S330 : f32 = _S329 * _S326.x;
        var _S331 : f32 = select(_S328, _S330 - _S328, back_4);
        var _S332 : bool = quantity_2 == u32(0);
        if(_S332)
        {
            is_exposed_0 = _S331 > (16.0f * families_0[family_19].area_unit_0 * min(_S330 / families_0[family_19].crossing_area_0, 1.0f) + 0.00000999999974738f * _S330);
        }
        var _S333 : f32 = _S329 * _S326.y + select(0.0f, _S331, is_exposed_0) + 0.000244140625f * _S326.z * _S327.y;
        if(_S332)
        {
            weight_1 = 1.0f / max(_S333, 9.99999968265522539e-21f);
        }
        else
        {
            albedos_2 = with_added_albedos_0(albedos_2, _S333 * weight_1, families_0[family_19].colour_axes_0 + u32(12) * (quantity_2 - u32(1)));
        }
        quantity_2 = quantity_2 + u32(1);
    }
    albedos_2.diffuse_reflect_0 = saturate(albedos_2.diffuse_reflect_0);
    albedos_2.diffuse_transmit_0 = saturate(albedos_2.diffuse_transmit_0);
    albedos_2.specular_reflect_0 = saturate(albedos_2.specular_reflect_0);
    albedos_2.specular_transmit_0 = saturate(albedos_2.specular_transmit_0);
    return albedos_2;
}

fn uniform_hash_0( thread_9 : u32,  cell_9 : u32,  stream_1 : u32) -> f32
{
    return (f32(((hash_bits_0(hash_key_0(thread_9, stream_1), cell_9)) >> (u32(9)))) + 0.5f) * 1.1920928955078125e-07f;
}

fn pixel_sequence_0( pixel_0 : vec2<u32>,  index_5 : u32,  stream_2 : u32) -> vec2<f32>
{
    var _S334 : u32 = pixel_0.x;
    var _S335 : u32 = pixel_0.y;
    return fract(vec2<f32>(uniform_hash_0(_S334, _S335, stream_2), uniform_hash_0(_S334, _S335, stream_2 + u32(1))) + vec2<f32>(f32((index_5 & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
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
        var _S336 : u32 = (low_8 + high_8) / u32(2);
        if((scene_number_0(table_0 + _S336)) <= number_3)
        {
            low_8 = _S336;
        }
        else
        {
            high_8 = _S336;
        }
    }
    var _S337 : u32 = table_0 + low_8;
    var _S338 : f32 = scene_number_0(_S337);
    var _S339 : f32 = scene_number_0(_S337 + u32(1));
    var choice_0 : Choice_0;
    choice_0.index_7 = low_8;
    choice_0.remainder_0 = saturate((number_3 - _S338) / max(_S339 - _S338, 9.999999960041972e-13f));
    return choice_0;
}

fn mean_0( colour_0 : vec3<f32>) -> f32
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

fn sine_cosine_0( x_8 : f32) -> vec2<f32>
{
    var _S340 : f32 = floor(x_8 * 0.63661974668502808f + 0.5f);
    var _S341 : f32 = x_8 - _S340 * 1.5703125f - _S340 * 0.00048375129699707f - _S340 * 7.54979012640433211e-08f;
    var _S342 : f32 = _S341 * _S341;
    var _S343 : f32 = ((-0.00019515295571182f * _S342 + 0.00833216123282909f) * _S342 - 0.16666655242443085f) * _S342 * _S341 + _S341;
    var _S344 : f32 = ((0.00002443315679557f * _S342 - 0.00138873164542019f) * _S342 + 0.04166664555668831f) * _S342 * _S342 - 0.5f * _S342 + 1.0f;
    var _S345 : u32 = (u32(i32(_S340)) & (u32(3)));
    var _S346 : vec2<f32> = select_vector_1(((_S345 & (u32(1)))) != u32(0), vec2<f32>(_S344, _S343), vec2<f32>(_S343, _S344));
    var _S347 : f32 = _S346.x;
    var _S348 : f32 = _S346.y;
    return vec2<f32>(select(_S347, - _S347, ((_S345 & (u32(2)))) != u32(0)), select(_S348, - _S348, (((_S345 + u32(1)) & (u32(2)))) != u32(0)));
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

fn scene_light_0( first_24 : u32) -> Light_0
{
    var record_1 : Light_0;
    record_1.is_point_0 = scene_words_0[first_24];
    record_1.x_9 = (bitcast<f32>((scene_words_0[first_24 + u32(1)])));
    record_1.y_1 = (bitcast<f32>((scene_words_0[first_24 + u32(2)])));
    record_1.z_1 = (bitcast<f32>((scene_words_0[first_24 + u32(3)])));
    record_1.red_0 = (bitcast<f32>((scene_words_0[first_24 + u32(4)])));
    record_1.green_0 = (bitcast<f32>((scene_words_0[first_24 + u32(5)])));
    record_1.blue_0 = (bitcast<f32>((scene_words_0[first_24 + u32(6)])));
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
    var _S349 : f32 = max(abs(light_1.z), 0.00100000004749745f);
    var _S350 : vec2<f32> = light_1.xy;
    return 3.14159274101257324f * max(diffuse_0, 0.0f) / mix(_S349, (0.59700000286102295f * _S349 + 0.16599999368190765f) * (0.21600000560283661f * (dot(_S350, view_1.xy) * rsqrt_0(max(dot(_S350, _S350), 9.99999997475242708e-07f))) + 1.0f), blend_0);
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
     warp_4 : Blocked_0,
     weft_4 : Blocked_0,
};

fn no_close_up_0() -> CloseUp_0
{
    var nothing_1 : CloseUp_0;
    nothing_1.weight_2 = 0.0f;
    var _S351 : Blocked_0 = no_blocked_0();
    nothing_1.warp_4 = _S351;
    nothing_1.weft_4 = _S351;
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
     warp_5 : vec3<f32>,
     weft_5 : vec3<f32>,
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
    var _S352 : vec3<f32> = vec3<f32>((1.0f - open_of_other_0)) * passed_0;
    var found_0 : FaceRadiance_0;
    var _S353 : vec3<f32> = sends_0.sky_warp_0 + _S352 * sends_0.crossing_warp_0;
    found_0.warp_5 = _S353;
    var _S354 : vec3<f32> = sends_0.sky_weft_0 + _S352 * sends_0.crossing_weft_0;
    found_0.weft_5 = _S354;
    found_0.mean_1 = vec3<f32>(sends_0.blocks_warp_0) * _S353 + vec3<f32>(sends_0.blocks_weft_0) * _S354;
    found_0.leaked_0 = from_other_0;
    return found_0;
}

fn view_terms_0( view_2 : vec3<f32>,  terms_0 : ptr<function, array<f32, i32(6)>>)
{
    var _S355 : f32 = 1.0f - view_2.z;
    var _S356 : f32 = _S355 * _S355;
    (*terms_0)[i32(0)] = 1.0f;
    var _S357 : f32 = view_2.x;
    var _S358 : f32 = _S357 * _S357;
    var _S359 : f32 = view_2.y;
    var _S360 : f32 = _S359 * _S359;
    (*terms_0)[i32(1)] = sqrt(max(_S358 + _S360, 9.999999960041972e-13f));
    (*terms_0)[i32(2)] = _S356;
    (*terms_0)[i32(3)] = _S356 * _S356;
    (*terms_0)[i32(4)] = _S358 - _S360;
    (*terms_0)[i32(5)] = 0.0f;
    return;
}

fn view_terms_1( view_3 : vec3<f32>,  terms_1 : ptr<function, array<f32, i32(6)>>)
{
    var _S361 : f32 = 1.0f - view_3.z;
    var _S362 : f32 = _S361 * _S361;
    (*terms_1)[i32(0)] = 1.0f;
    var _S363 : f32 = view_3.x;
    var _S364 : f32 = _S363 * _S363;
    var _S365 : f32 = view_3.y;
    var _S366 : f32 = _S365 * _S365;
    (*terms_1)[i32(1)] = sqrt(max(_S364 + _S366, 9.999999960041972e-13f));
    (*terms_1)[i32(2)] = _S362;
    (*terms_1)[i32(3)] = _S362 * _S362;
    (*terms_1)[i32(4)] = _S364 - _S366;
    (*terms_1)[i32(5)] = 0.0f;
    return;
}

fn scaled_0( blocked_0 : Blocked_0,  share_2 : f32) -> Blocked_0
{
    var result_1 : Blocked_0;
    result_1.by_warp_0 = share_2 * blocked_0.by_warp_0;
    result_1.by_weft_0 = share_2 * blocked_0.by_weft_0;
    result_1.far_0 = share_2 * blocked_0.far_0;
    return result_1;
}

struct Bounced_0
{
     reflected_0 : vec3<f32>,
     transmitted_0 : vec3<f32>,
};

struct Scattered_0
{
     back_5 : vec3<f32>,
     through_0 : vec3<f32>,
};

struct Interior_0
{
     warp_6 : vec3<f32>,
     weft_6 : vec3<f32>,
     leaked_1 : vec3<f32>,
     far_1 : vec3<f32>,
     far_leaked_0 : vec3<f32>,
};

fn bounced_by_0( blocked_1 : Blocked_0,  yarn_2 : Scattered_0,  interior_0 : Interior_0) -> Bounced_0
{
    var _S367 : vec3<f32> = vec3<f32>((blocked_1.by_warp_0 + blocked_1.by_weft_0)) * interior_0.leaked_1;
    var _S368 : vec3<f32> = vec3<f32>(blocked_1.far_0) * yarn_2.through_0;
    var bounced_0 : Bounced_0;
    bounced_0.reflected_0 = yarn_2.back_5 * (vec3<f32>(blocked_1.by_warp_0) * interior_0.warp_6 + vec3<f32>(blocked_1.by_weft_0) * interior_0.weft_6) + _S368 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S368 * interior_0.far_1 + yarn_2.back_5 * _S367;
    return bounced_0;
}

fn sum_of_0( first_25 : Bounced_0,  second_2 : Bounced_0) -> Bounced_0
{
    var sum_1 : Bounced_0;
    sum_1.reflected_0 = first_25.reflected_0 + second_2.reflected_0;
    sum_1.transmitted_0 = first_25.transmitted_0 + second_2.transmitted_0;
    return sum_1;
}

fn bounced_value_0( bounced_1 : Bounced_0,  light_2 : vec3<f32>,  view_4 : vec3<f32>) -> vec3<f32>
{
    var _S369 : f32 = light_2.z;
    return select_vector_2((_S369 * view_4.z) < 0.0f, bounced_1.transmitted_0, bounced_1.reflected_0) * vec3<f32>((abs(_S369) * 0.31830987334251404f));
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
    var _S370 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S371 : f32 = 2.0f * sqrt(_S370) - 1.0f;
    var _S372 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_1, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S371, _S372), 0.00999999977648258f, 1.0f), clamp((1.0f - _S370) * sheen_shear_0(_S371, _S372), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S371, _S372), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_3 : vec3<f32>,  view_5 : vec3<f32>,  scale_1 : f32,  shear_0 : f32) -> f32
{
    var _S373 : f32 = light_3.z;
    if(((_S373 <= 0.0f) | (((view_5.z) <= 0.0f))))
    {
        return 0.0f;
    }
    var _S374 : vec2<f32> = view_5.xy;
    var _S375 : f32 = dot(_S374, _S374);
    var _S376 : vec2<f32> = select_vector_1(_S375 > 9.99999968265522539e-21f, _S374 * vec2<f32>(rsqrt_0(max(_S375, 9.99999968265522539e-21f))), vec2<f32>(1.0f, 0.0f));
    var _S377 : f32 = scale_1 * dot(light_3.xy, _S376) + shear_0 * _S373;
    var _S378 : f32 = scale_1 * (light_3.y * _S376.x - light_3.x * _S376.y);
    var _S379 : f32 = _S377 * _S377 + _S378 * _S378 + _S373 * _S373;
    return 0.31830987334251404f * scale_1 * scale_1 * _S373 / max(_S379 * _S379, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_4 : vec3<f32>,  view_6 : vec3<f32>,  strength_0 : f32,  roughness_2 : f32) -> vec2<f32>
{
    var _S380 : vec3<f32> = sheen_lobe_0(view_6.z, roughness_2);
    var _S381 : f32 = strength_0 * _S380.z;
    return vec2<f32>(_S381 * transformed_cosine_0(light_4, view_6, _S380.x, _S380.y), 1.0f - _S381);
}

fn accumulate_0( index_8 : u32,  light_5 : vec4<f32>)
{
    var _S382 : f32 = layers_0[index_8].share_0;
    radiance_0[index_8] = radiance_0[index_8] + vec4<f32>(layers_0[index_8].share_0) * light_5;
    layers_0[index_8].share_0 = _S382 * (1.0f - light_5.w);
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

fn uneven_shift_0( _S383 : u32,  _S384 : u32,  _S385 : u32,  _S386 : vec2<f32>) -> f32
{
    var _S387 : f32 = families_0[_S385].period_0 / families_0[_S385].count_0;
    var _S388 : u32 = hash_key_0(_S384, ((fabrics_0[_S383].seed_0) ^ (u32(625341585))));
    var _S389 : vec2<f32> = vec2<f32>(_S386.x, _S386.y / 4.0f) / vec2<f32>(_S387);
    return 0.20000000298023224f * sqrt(families_0[_S385].slub_0) * _S387 * (uneven_octave_0(_S388, _S389) * 0.66666668653488159f + uneven_octave_0(_S388 + u32(1), vec2<f32>(2.0f) * _S389 + vec2<f32>(0.5f, 0.0f)) / 3.0f);
}

fn uneven_place_0( _S390 : u32,  _S391 : vec2<f32>) -> vec2<f32>
{
    return select_vector_1((fabrics_0[_S390].has_detail_0) == u32(0), _S391, _S391 + vec2<f32>(uneven_shift_0(_S390, u32(0), fabrics_0[_S390].warp_0, _S391), uneven_shift_0(_S390, u32(1), fabrics_0[_S390].weft_0, _S391.yx)));
}

fn face_point_0( _S392 : u32,  _S393 : u32,  _S394 : f32,  _S395 : f32) -> VisiblePoint_0
{
    var _S396 : u32 = u32(3) * _S393;
    var _S397 : Vertex_0 = vertex_at_0(_S396);
    var _S398 : Vertex_0 = vertex_at_0(_S396 + u32(1));
    var _S399 : Vertex_0 = vertex_at_0(_S396 + u32(2));
    var _S400 : vec3<f32> = position_of_0(_S397);
    var _S401 : vec3<f32> = position_of_0(_S398) - _S400;
    var _S402 : vec3<f32> = position_of_0(_S399) - _S400;
    var _S403 : f32 = _S398.u_0 - _S397.u_0;
    var _S404 : f32 = _S398.v_0 - _S397.v_0;
    var _S405 : vec2<f32> = vec2<f32>(_S403, _S404);
    var _S406 : f32 = _S399.u_0 - _S397.u_0;
    var _S407 : f32 = _S399.v_0 - _S397.v_0;
    var _S408 : vec2<f32> = vec2<f32>(_S406, _S407);
    var _S409 : vec3<f32> = vec3<f32>(select(1.0f, -1.0f, (_S403 * _S407 - _S404 * _S406) < 0.0f));
    var _S410 : vec3<f32> = _S409 * (vec3<f32>(_S407) * _S401 - vec3<f32>(_S404) * _S402);
    var _S411 : vec3<f32> = _S409 * (vec3<f32>(_S403) * _S402 - vec3<f32>(_S406) * _S401);
    var point_1 : VisiblePoint_0;
    var _S412 : vec3<f32> = vec3<f32>(_S394);
    var _S413 : vec3<f32> = vec3<f32>(_S395);
    var _S414 : vec3<f32> = normalize(vec3<f32>((1.0f - _S394 - _S395)) * normal_of_0(_S397) + _S412 * normal_of_0(_S398) + _S413 * normal_of_0(_S399));
    point_1.normal_0 = _S414;
    var _S415 : vec3<f32> = normalize(_S410 - _S414 * vec3<f32>(dot(_S414, _S410)));
    point_1.axis_x_0 = _S415;
    point_1.axis_y_0 = cross(_S414, _S415);
    var _S416 : vec3<f32> = normalize(cross(_S401, _S402));
    point_1.face_normal_0 = select_vector_2((dot(_S416, _S414)) < 0.0f, (vec3<f32>(0) - _S416), _S416);
    point_1.position_4 = _S400 + _S412 * _S401 + _S413 * _S402;
    point_1.view_0 = _S414;
    var _S417 : vec2<f32> = vec2<f32>(_S397.u_0, _S397.v_0) + vec2<f32>(_S394) * _S405 + vec2<f32>(_S395) * _S408;
    point_1.uv_1 = _S417;
    var _S418 : bool = (dot(cross(_S410, _S411), _S414)) < 0.0f;
    var _S419 : vec2<f32> = vec2<f32>(fabrics_0[_S392].uv_width_0, select(fabrics_0[_S392].uv_height_0, - fabrics_0[_S392].uv_height_0, _S418));
    point_1.draft_per_uv_0 = _S419;
    point_1.draft_0 = uneven_place_0(_S392, _S417 * _S419 + vec2<f32>(0.0f, select(0.0f, fabrics_0[_S392].uv_height_0, _S418)));
    var _S420 : vec2<f32> = vec2<f32>(0.0f);
    point_1.draft_dx_0 = _S420;
    point_1.draft_dy_0 = _S420;
    return point_1;
}

fn visible_point_0( _S421 : u32,  _S422 : u32,  _S423 : vec2<u32>) -> VisiblePoint_0
{
    var _S424 : u32 = u32(3) * _S422;
    var _S425 : Vertex_0 = vertex_at_0(_S424);
    var _S426 : Vertex_0 = vertex_at_0(_S424 + u32(1));
    var _S427 : Vertex_0 = vertex_at_0(_S424 + u32(2));
    var _S428 : vec3<f32> = position_of_0(_S425);
    var _S429 : vec3<f32> = position_of_0(_S426) - _S428;
    var _S430 : vec3<f32> = position_of_0(_S427) - _S428;
    var _S431 : vec3<f32> = cross(_S429, _S430);
    var _S432 : f32 = f32(frame_record_0.width_0);
    var _S433 : vec3<f32> = camera_right_0() * vec3<f32>((2.0f / _S432));
    var _S434 : f32 = f32(frame_record_0.height_0);
    var _S435 : vec3<f32> = camera_up_0() * vec3<f32>((-2.0f / _S434));
    var _S436 : vec3<f32> = camera_forward_0() + vec3<f32>((f32(_S423.x) + 0.5f - 0.5f * _S432)) * _S433 + vec3<f32>((f32(_S423.y) + 0.5f - 0.5f * _S434)) * _S435;
    var _S437 : f32 = dot(_S436, _S431);
    var _S438 : f32 = 1.0f / select(1.00000000317107685e-30f, _S437, (abs(_S437)) > 1.00000000317107685e-30f);
    var _S439 : vec3<f32> = _S428 - camera_origin_0();
    var _S440 : vec3<f32> = vec3<f32>((dot(_S439, _S431) * _S438));
    var _S441 : vec3<f32> = _S436 * _S440 - _S439;
    var _S442 : vec3<f32> = _S440 * (_S433 - _S436 * vec3<f32>((dot(_S433, _S431) * _S438)));
    var _S443 : vec3<f32> = _S440 * (_S435 - _S436 * vec3<f32>((dot(_S435, _S431) * _S438)));
    var _S444 : vec3<f32> = vec3<f32>((1.0f / max(square_0(_S431), 1.00000000317107685e-30f)));
    var _S445 : vec3<f32> = cross(_S430, _S431) * _S444;
    var _S446 : vec3<f32> = cross(_S431, _S429) * _S444;
    var _S447 : vec2<f32> = vec2<f32>(_S426.u_0 - _S425.u_0, _S426.v_0 - _S425.v_0);
    var _S448 : vec2<f32> = vec2<f32>(_S427.u_0 - _S425.u_0, _S427.v_0 - _S425.v_0);
    var point_2 : VisiblePoint_0 = face_point_0(_S421, _S422, dot(_S441, _S445), dot(_S441, _S446));
    point_2.position_4 = _S428 + _S441;
    point_2.view_0 = (vec3<f32>(0) - normalize(_S436));
    point_2.draft_dx_0 = (vec2<f32>(dot(_S442, _S445)) * _S447 + vec2<f32>(dot(_S442, _S446)) * _S448) * point_2.draft_per_uv_0;
    point_2.draft_dy_0 = (vec2<f32>(dot(_S443, _S445)) * _S447 + vec2<f32>(dot(_S443, _S446)) * _S448) * point_2.draft_per_uv_0;
    return point_2;
}

fn filtered_albedo_0( _S449 : u32,  _S450 : VisiblePoint_0) -> vec3<f32>
{
    var _S451 : u32 = fabrics_0[_S449].albedo_map_levels_0;
    if((fabrics_0[_S449].albedo_map_levels_0) == u32(0))
    {
        return vec3<f32>(1.0f);
    }
    var _S452 : vec2<f32> = vec2<f32>(fabrics_0[_S449].uv_width_0, fabrics_0[_S449].uv_height_0);
    var _S453 : vec2<f32> = _S450.draft_dx_0 / _S452;
    var _S454 : vec2<f32> = _S450.draft_dy_0 / _S452;
    var _S455 : u32 = _S451 - u32(1);
    var _S456 : u32 = (u32(1) << (_S455));
    var _S457 : f32 = clamp(0.5f * binary_logarithm_0(max(abs(_S453.x * _S454.y - _S453.y * _S454.x), 9.99999968265522539e-21f) * (square_1(f32(_S456)) / 3.0f)), 0.0f, f32(_S451) - 1.0f);
    var _S458 : u32 = min(u32(_S457), max(_S451, u32(2)) - u32(2));
    var _S459 : u32 = min(_S458 + u32(1), _S455);
    var _S460 : u32 = (u32(1) << ((u32(2) * _S451)));
    return mix(map_level_0(fabrics_0[_S449].albedo_map_0 + (_S460 - ((_S460 >> ((u32(2) * _S458))))) / u32(3), (_S456 >> (_S458)), _S450.uv_1), map_level_0(fabrics_0[_S449].albedo_map_0 + (_S460 - ((_S460 >> ((u32(2) * _S459))))) / u32(3), (_S456 >> (_S459)), _S450.uv_1), vec3<f32>(((exponential_0(1.38629436492919922f * (_S457 - f32(_S458))) - 1.0f) / 3.0f)));
}

fn irregular_key_0( _S461 : u32,  _S462 : u32) -> u32
{
    return hash_key_0(_S462, ((fabrics_0[_S461].seed_0) ^ (u32(1821285621))));
}

fn irregular_place_0( _S463 : u32,  _S464 : vec2<f32>,  _S465 : f32) -> vec2<f32>
{
    var _S466 : u32 = fabrics_0[_S463].warp_0;
    var _S467 : u32 = fabrics_0[_S463].weft_0;
    var _S468 : bool = (((fabrics_0[_S463].is_irregular_0) != u32(0)) & (((max(moved_share_0(fabrics_0[_S463].warp_0, _S465), moved_share_0(fabrics_0[_S463].weft_0, _S465))) > 0.0f)));
    var number_4 : u32 = u32(0);
    var moved_0 : vec2<f32> = _S464;
    for(;;)
    {
        if(number_4 < select(u32(0), u32(2), _S468))
        {
        }
        else
        {
            break;
        }
        var _S469 : bool = number_4 == u32(0);
        var _S470 : u32 = select(_S467, _S466, _S469);
        var _S471 : vec2<f32> = select_vector_1(_S469, _S464, _S464.yx);
        var _S472 : u32 = irregular_key_0(_S463, number_4);
        var _S473 : f32 = _S471.x;
        var _S474 : Cell_0 = locate_0(_S470, _S473);
        var _S475 : f32 = irregular_thread_0(_S470, _S473, _S474);
        var _S476 : f32 = select(1.0f, -1.0f, (_S474.across_0) < 0.0f);
        var _S477 : vec2<f32> = vec2<f32>(0.0f);
        var other_3 : vec2<f32> = _S477;
        var own_2 : vec2<f32> = _S477;
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
            var _S478 : vec2<f32> = irregular_at_0(_S470, _S472, _S475 + _S476 * f32(neighbour_0), _S471.y).xy;
            var _S479 : u32 = neighbour_0 + u32(1);
            own_2 = other_3;
            other_3 = _S478;
            neighbour_0 = _S479;
        }
        var _S480 : f32 = _S474.below_0 + _S474.above_0;
        var _S481 : f32 = min(_S474.half_width_1 / _S480, 0.5f);
        var _S482 : f32 = min(_S481 * (2.0f + own_2.y + other_3.y), 1.0f);
        var _S483 : vec2<f32> = sqrt(max(vec2<f32>(1.0f) + vec2<f32>(own_2.x, other_3.x), vec2<f32>(0.25f)));
        var _S484 : f32 = _S483.x;
        var _S485 : f32 = _S482 * _S484 / (_S484 + _S483.y);
        var _S486 : f32 = abs(_S474.across_0) / _S480;
        var _S487 : f32 = 1.0f - _S482;
        var _S488 : f32 = _S486 - _S485;
        var _S489 : f32 = moved_share_0(_S470, _S465) * _S476 * _S480 * (select(select((_S488 - _S487) / max(_S482 - _S485, 9.99999997475242708e-07f) * _S481 + (1.0f - _S481), _S488 / max(_S487, 9.99999997475242708e-07f) * (1.0f - 2.0f * _S481) + _S481, _S488 < _S487), _S486 * _S481 / _S485, _S488 < 0.0f) - _S486);
        var moved_1 : vec2<f32> = moved_0 + select_vector_1(_S469, vec2<f32>(_S489, 0.0f), vec2<f32>(0.0f, _S489));
        number_4 = number_4 + u32(1);
        moved_0 = moved_1;
    }
    return moved_0;
}

struct NeuralView_0
{
     sums_9 : array<f32, i32(64)>,
     even_hole_0 : f32,
     hole_2 : f32,
     yarns_0 : Yarns_0,
     correction_weight_0 : f32,
     view_7 : vec3<f32>,
     back_6 : bool,
};

fn anisotropic_taps_0( _S490 : u32,  _S491 : Footprint_0) -> AnisotropicTaps_0
{
    var _S492 : vec3<f32> = row_of_taps_0(_S491);
    var _S493 : vec2<f32> = _S491.dx_0;
    var _S494 : vec2<f32> = _S491.dy_0;
    var _S495 : f32 = dot(_S493, _S493) + dot(_S494, _S494);
    var _S496 : f32 = _S491.dx_0.x * _S491.dy_0.y - _S491.dx_0.y * _S491.dy_0.x;
    var _S497 : f32 = 0.5f * (_S495 + sqrt(max(_S495 * _S495 - 4.0f * _S496 * _S496, 0.0f)));
    var _S498 : bool = ((_S497 < (5.5f * (_S495 - _S497))) & ((_S495 > (8.0f * fabrics_0[_S490].neural_0.pitch_0 * fabrics_0[_S490].neural_0.pitch_0))));
    var _S499 : vec2<f32> = vec2<f32>(fabrics_0[_S490].neural_0.ends_per_mm_0, fabrics_0[_S490].neural_0.picks_per_mm_0);
    var taps_1 : AnisotropicTaps_0;
    taps_1.centre_1 = _S491.centre_0 * _S499;
    taps_1.side_2 = select(_S492.x, sqrt(0.125f * _S495), _S498) / fabrics_0[_S490].neural_0.pitch_0;
    var _S500 : vec2<f32> = vec2<f32>(0.25f);
    var _S501 : vec2<f32> = _S492.yz;
    taps_1.first_21 = select_vector_1(_S498, _S500 * _S491.dx_0, _S501) * _S499;
    taps_1.second_0 = select_vector_1(_S498, _S500 * _S491.dy_0, vec2<f32>(0.5f) * _S501) * _S499;
    return taps_1;
}

struct Hit_0
{
     x_13 : f32,
     y_5 : f32,
     hole_3 : bool,
     height_4 : f32,
};

struct Sample_0
{
     crossing_2 : Crossing_0,
     shown_3 : Shown_0,
     run_3 : Run_0,
     section_1 : Section_0,
     height_5 : f32,
     slope_across_0 : f32,
     slope_along_0 : f32,
     dive_1 : vec3<f32>,
     slope_x_1 : f32,
     slope_y_1 : f32,
};

fn crossing_at_0( _S502 : u32,  _S503 : f32,  _S504 : f32,  _S505 : bool) -> Crossing_0
{
    var crossing_3 : Crossing_0;
    crossing_3.warp_1 = locate_0(fabrics_0[_S502].warp_0, _S503);
    crossing_3.weft_1 = locate_0(fabrics_0[_S502].weft_0, _S504);
    var _S506 : u32 = fabrics_0[_S502].run_words_0 + u32(2) * (crossing_3.weft_1.thread_1 * fabrics_0[_S502].ends_1 + crossing_3.warp_1.thread_1);
    var _S507 : u32 = words_0[_S506];
    crossing_3.warp_word_0 = _S507;
    crossing_3.weft_word_0 = words_0[_S506 + u32(1)];
    crossing_3.warp_above_0 = (((_S507 & (u32(1)))) == u32(1)) != _S505;
    return crossing_3;
}

fn sample_at_0( _S508 : u32,  _S509 : f32,  _S510 : f32,  _S511 : bool) -> Sample_0
{
    var sample_0 : Sample_0;
    var _S512 : Crossing_0 = crossing_at_0(_S508, _S509, _S510, _S511);
    sample_0.crossing_2 = _S512;
    var _S513 : Shown_0 = shown_at_0(_S512, _S511);
    sample_0.shown_3 = _S513;
    var _S514 : u32 = select(fabrics_0[_S508].weft_0, fabrics_0[_S508].warp_0, _S513.is_warp_0);
    var _S515 : u32 = select(fabrics_0[_S508].warp_0, fabrics_0[_S508].weft_0, _S513.is_warp_0);
    var _S516 : Cell_0 = select_cell_0(_S513.is_warp_0, sample_0.crossing_2.warp_1, sample_0.crossing_2.weft_1);
    var _S517 : Cell_0 = select_cell_0(_S513.is_warp_0, sample_0.crossing_2.weft_1, sample_0.crossing_2.warp_1);
    var _S518 : Run_0 = unpack_0(_S514, _S515, _S516.thread_1, _S517, _S513.word_0);
    var _S519 : Section_0 = section_at_0(_S516);
    var _S520 : bool = ((_S513.on_top_0) & (((_S518.distance_0) < (_S519.drop_0 * _S518.bend_1.sine_0))));
    var _S521 : f32 = select(-1.0f, 1.0f, ((_S513.on_top_0) & ((!_S520))));
    var _S522 : f32 = select(_S518.reach_0, _S518.other_reach_0, _S520);
    var _S523 : f32 = select(max(_S522 - _S518.distance_0, 0.0f), _S522 + _S518.distance_0, _S520);
    var _S524 : f32 = _S522 / _S518.bend_1.sine_0 - _S521 * _S519.drop_0;
    var _S525 : f32 = _S523 * _S523;
    var _S526 : f32 = max(_S524 * _S524 - _S525, 9.99999968265522539e-21f);
    var _S527 : f32 = rsqrt_0(_S526);
    var _S528 : f32 = _S525 / (_S526 * _S527 + _S524);
    var _S529 : bool = _S523 > 0.0f;
    var _S530 : f32 = select(-1.0f, 1.0f, _S513.on_top_0) * select(-1.0f, 1.0f, _S518.near_start_0);
    var _S531 : f32 = _S519.slope_0 * select(1.0f, _S524 * _S527, _S529);
    sample_0.slope_across_0 = _S531;
    var _S532 : f32 = select(0.0f, _S530 * _S523 * _S527, _S529);
    sample_0.slope_along_0 = _S532;
    var _S533 : vec3<f32> = dive_0(_S515, _S513, _S518, _S517);
    sample_0.dive_1 = _S533;
    sample_0.height_5 = select(families_0[_S514].height_scale_0 * _S521, 0.0f, _S518.straight_0) * (_S522 * _S518.bend_1.half_tangent_0 - _S528) - families_0[_S514].height_scale_0 * _S519.drop_0 - _S533.x;
    var _S534 : f32 = families_0[_S514].height_scale_0 * _S531;
    var _S535 : f32 = families_0[_S514].height_scale_0 * _S532 - _S533.y;
    sample_0.slope_x_1 = select(_S535, _S534, _S513.is_warp_0);
    sample_0.slope_y_1 = select(_S534, _S535, _S513.is_warp_0);
    sample_0.run_3 = _S518;
    sample_0.section_1 = _S519;
    return sample_0;
}

fn steps_per_length_0( _S536 : u32,  _S537 : SearchQuality_0,  _S538 : vec3<f32>) -> f32
{
    return max(max(abs(_S538.x) * fabrics_0[_S536].threads_per_x_0, abs(_S538.y) * fabrics_0[_S536].threads_per_y_0) * _S537.steps_per_thread_0, abs(_S538.z) * fabrics_0[_S536].per_relief_0 * _S537.steps_per_relief_0);
}

fn cell_maximum_0( _S539 : u32,  _S540 : Crossing_0) -> f32
{
    var _S541 : u32 = select(fabrics_0[_S539].weft_0, fabrics_0[_S539].warp_0, _S540.warp_above_0);
    return f32((select(_S540.weft_word_0, _S540.warp_word_0, _S540.warp_above_0) >> (u32(28)))) * families_0[_S541].height_scale_0 * families_0[_S541].level_0;
}

fn probe_0( _S542 : u32,  _S543 : f32,  _S544 : f32,  _S545 : bool,  _S546 : bool,  _S547 : bool) -> Probe_0
{
    var _S548 : Sample_0 = sample_at_0(_S542, _S543, _S544, _S545);
    var probe_1 : Probe_0;
    probe_1.height_2 = _S548.height_5;
    probe_1.hole_1 = _S548.shown_3.hole_0;
    probe_1.slope_x_0 = _S548.slope_x_1;
    probe_1.slope_y_0 = _S548.slope_y_1;
    probe_1.yarn_1 = select(_S548.crossing_2.weft_1.thread_1 * u32(2), _S548.crossing_2.warp_1.thread_1 * u32(2) + u32(1), _S548.shown_3.is_warp_0);
    probe_1.cell_max_0 = cell_maximum_0(_S542, _S548.crossing_2);
    probe_1.side_x_0 = select(_S548.crossing_2.warp_1.below_0, _S548.crossing_2.warp_1.above_0, _S546);
    probe_1.side_y_0 = select(_S548.crossing_2.weft_1.below_0, _S548.crossing_2.weft_1.above_0, _S547);
    probe_1.edge_x_0 = outline_distance_0(_S548.crossing_2.warp_1, _S548.shown_3, _S548.run_3, !_S548.shown_3.is_warp_0, _S546);
    probe_1.edge_y_0 = outline_distance_0(_S548.crossing_2.weft_1, _S548.shown_3, _S548.run_3, _S548.shown_3.is_warp_0, _S547);
    return probe_1;
}

fn is_free_0( _S549 : u32,  _S550 : SearchQuality_0,  _S551 : vec3<f32>,  _S552 : vec3<f32>,  _S553 : bool,  _S554 : f32) -> bool
{
    var _S555 : f32 = _S552.z;
    if(_S555 <= 0.0f)
    {
        return false;
    }
    var _S556 : f32 = 1.0f / max(_S550.shadow_share_0 * steps_per_length_0(_S549, _S550, _S552), 9.99999971718068537e-10f);
    var _S557 : StepControl_0 = step_control_0(_S552.xy, _S556);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_4 : u32 = u32(0);
    var distance_2 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        if(((count_4 < u32(1024)) & (((_S551.z + _S555 * distance_2) < _S554))))
        {
        }
        else
        {
            break;
        }
        var _S558 : vec3<f32> = _S551 + _S552 * vec3<f32>(distance_2);
        var _S559 : Probe_0 = probe_0(_S549, _S558.x, _S558.y, _S553, _S557.right_0, _S557.up_0);
        var _S560 : f32 = _S558.z;
        var _S561 : f32 = _S560 - _S559.height_2;
        var _S562 : f32 = _S555 - _S559.slope_x_0 * _S552.x - _S559.slope_y_0 * _S552.y;
        if(((!_S559.hole_1) & ((_S561 < 0.0f))))
        {
            return false;
        }
        var _S563 : f32 = way_back_to_dip_0(previous_3, _S561, _S562, last_step_0, _S559);
        if(_S563 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S563;
            distance_2 = distance_2 - _S563;
            last_step_0 = last_step_1;
            count_4 = count_4 + u32(1);
            continue;
        }
        var _S564 : bool = _S560 > (_S559.cell_max_0);
        var last_step_2 : f32 = select(StepControl_to_next_sample_0(_S557, _S559, _S561, _S562), max(StepControl_to_cell_exit_0(_S557, _S559.side_x_0, _S559.side_y_0), _S556), _S564);
        var distance_3 : f32 = distance_2 + last_step_2;
        previous_3 = after_sample_0(_S561, _S562, _S559, _S564);
        distance_2 = distance_3;
        last_step_0 = last_step_2;
        count_4 = count_4 + u32(1);
    }
    return true;
}

fn passes_through_0( _S565 : u32,  _S566 : SearchQuality_0,  _S567 : f32,  _S568 : f32,  _S569 : vec3<f32>,  _S570 : bool) -> bool
{
    if(!sample_at_0(_S565, _S567, _S568, _S570).shown_3.hole_0)
    {
        return false;
    }
    var _S571 : vec3<f32> = vec3<f32>(_S567, _S568, 0.0f);
    var passes_0 : bool = true;
    var side_3 : u32 = u32(0);
    for(;;)
    {
        if(((side_3 < u32(2)) & (passes_0)))
        {
        }
        else
        {
            break;
        }
        var _S572 : bool = is_free_0(_S565, _S566, _S571, select_vector_2(side_3 == u32(0), _S569, vec3<f32>(- _S569.x, - _S569.y, _S569.z)), _S570 != (side_3 == u32(1)), fabrics_0[_S565].height_high_0);
        var _S573 : u32 = side_3 + u32(1);
        passes_0 = _S572;
        side_3 = _S573;
    }
    return passes_0;
}

struct ViewRayEnd_0
{
     height_6 : f32,
     last_step_3 : f32,
     depth_0 : f32,
     rate_4 : f32,
     smooth_0 : bool,
     previous_4 : PreviousSample_0,
};

fn max_height_along_0( _S574 : u32,  _S575 : f32,  _S576 : f32,  _S577 : f32,  _S578 : vec3<f32>,  _S579 : bool) -> f32
{
    var _S580 : f32 = _S578.x;
    var _S581 : f32 = _S578.y;
    var _S582 : u32 = (words_0[fabrics_0[_S574].max_heights_0 + u32(4) * (locate_0(fabrics_0[_S574].weft_0, _S576).thread_1 / u32(2) * fabrics_0[_S574].max_height_columns_0 + locate_0(fabrics_0[_S574].warp_0, _S575).thread_1 / u32(2)) + (select(u32(0), u32(1), _S580 > 0.0f) + select(u32(0), u32(2), _S581 > 0.0f))] >> (u32(select(i32(0), i32(4), _S579))));
    var _S583 : f32 = max(abs(_S580) * fabrics_0[_S574].threads_per_x_0, abs(_S581) * fabrics_0[_S574].threads_per_y_0) / _S578.z;
    var _S584 : f32 = fabrics_0[_S574].height_high_0;
    var max_height_0 : f32 = fabrics_0[_S574].height_high_0;
    var number_5 : i32 = i32(3);
    for(;;)
    {
        if(number_5 >= i32(0))
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S577) * _S583) <= (PYRAMID_RADII_0[number_5]))
        {
            max_height_0 = min(max_height_0, f32((((_S582 >> (u32(i32(8) * number_5)))) & (u32(15)))) * 0.06666667014360428f * _S584);
        }
        number_5 = number_5 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S585 : u32,  _S586 : f32,  _S587 : f32,  _S588 : bool,  _S589 : bool,  _S590 : bool) -> vec3<f32>
{
    var _S591 : Crossing_0 = crossing_at_0(_S585, _S586, _S587, _S588);
    return vec3<f32>(cell_maximum_0(_S585, _S591), select(_S591.warp_1.below_0, _S591.warp_1.above_0, _S589), select(_S591.weft_1.below_0, _S591.weft_1.above_0, _S590));
}

fn first_sample_height_0( _S592 : u32,  _S593 : ViewRay_0,  _S594 : StepControl_0,  _S595 : bool) -> f32
{
    var _S596 : f32 = max_height_along_0(_S592, _S593.origin_0.x, _S593.origin_0.y, 0.0f, vec3<f32>(_S593.slope_1, 1.0f), _S595);
    var count_5 : u32 = u32(0);
    var height_7 : f32 = _S596;
    for(;;)
    {
        if(count_5 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S597 : vec2<f32> = ViewRay_at_0(_S593, height_7);
        var _S598 : vec3<f32> = cell_bounds_0(_S592, _S597.x, _S597.y, _S595, _S594.right_0, _S594.up_0);
        var _S599 : f32 = height_7 - _S598.x;
        var _S600 : f32 = StepControl_to_cell_exit_0(_S594, _S598.y, _S598.z);
        var height_8 : f32 = height_7 - clamp(_S599, 0.0f, _S600);
        if(_S599 <= _S600)
        {
            height_7 = height_8;
            break;
        }
        count_5 = count_5 + u32(1);
        height_7 = height_8;
    }
    return height_7;
}

fn search_down_0( _S601 : u32,  _S602 : ViewRay_0,  _S603 : StepControl_0,  _S604 : bool) -> ViewRayEnd_0
{
    var _S605 : f32 = fabrics_0[_S601].height_low_0 - (fabrics_0[_S601].height_high_0 - fabrics_0[_S601].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_6 = first_sample_height_0(_S601, _S602, _S603, _S604);
    end_1.last_step_3 = _S603.epsilon_0;
    end_1.previous_4 = no_previous_sample_0();
    end_1.depth_0 = 0.0f;
    end_1.rate_4 = 0.0f;
    end_1.smooth_0 = false;
    var count_6 : u32 = u32(0);
    for(;;)
    {
        if(count_6 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S606 : vec2<f32> = ViewRay_at_0(_S602, end_1.height_6);
        var _S607 : Probe_0 = probe_0(_S601, _S606.x, _S606.y, _S604, _S603.right_0, _S603.up_0);
        var _S608 : f32 = end_1.height_6 - _S607.height_2;
        var _S609 : f32 = ViewRay_rate_0(_S602, _S607);
        end_1.depth_0 = - _S608;
        end_1.rate_4 = _S609;
        var _S610 : bool = !_S607.hole_1;
        end_1.smooth_0 = ((((end_1.previous_4.known_0) & (_S610))) & (((end_1.previous_4.yarn_0) == (_S607.yarn_1))));
        if((((_S610 & ((_S608 <= 0.0f)))) | (((end_1.height_6) <= _S605))))
        {
            break;
        }
        var _S611 : f32 = way_back_to_dip_0(end_1.previous_4, _S608, _S609, end_1.last_step_3, _S607);
        if(_S611 >= 0.0f)
        {
            end_1.height_6 = end_1.height_6 + _S611;
            end_1.last_step_3 = end_1.last_step_3 - _S611;
            count_6 = count_6 + u32(1);
            continue;
        }
        var _S612 : f32 = min(StepControl_to_cell_exit_0(_S603, _S607.side_x_0, _S607.side_y_0), end_1.height_6 - _S607.cell_max_0);
        var _S613 : f32 = StepControl_to_next_sample_0(_S603, _S607, _S608, _S609);
        end_1.previous_4 = after_sample_0(_S608, _S609, _S607, _S612 > _S613);
        var _S614 : f32 = max(_S612, _S613);
        end_1.last_step_3 = _S614;
        end_1.height_6 = end_1.height_6 - _S614;
        count_6 = count_6 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S615 : u32,  _S616 : ViewRay_0,  _S617 : StepControl_0,  _S618 : bool,  _S619 : ViewRayEnd_0,  _S620 : u32) -> f32
{
    var _S621 : f32 = fabrics_0[_S615].height_high_0 - fabrics_0[_S615].height_low_0;
    var above_2 : f32 = _S619.height_6 + _S619.last_step_3;
    var above_gap_1 : f32 = clamp(_S619.previous_4.clearance_0, 0.0f, _S621);
    var under_gap_1 : f32 = clamp(_S619.depth_0, 0.0f, _S621);
    var middle_0 : f32 = select(between_0(above_2, _S619.height_6, above_gap_1, under_gap_1), above_2 - cubic_root_0(above_gap_1, - under_gap_1, _S619.previous_4.rate_0 * _S619.last_step_3, _S619.rate_4 * _S619.last_step_3) * _S619.last_step_3, _S619.smooth_0);
    var side_4 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S619.height_6;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < _S620)
        {
        }
        else
        {
            break;
        }
        var _S622 : vec2<f32> = ViewRay_at_0(_S616, middle_0);
        var _S623 : Probe_0 = probe_0(_S615, _S622.x, _S622.y, _S618, _S617.right_0, _S617.up_0);
        var _S624 : f32 = clamp(middle_0 - select(_S623.height_2, -1.0e+09f, _S623.hole_1), - _S621, _S621);
        if(_S624 <= 0.0f)
        {
            var _S625 : f32 = select(above_gap_2, 0.5f * above_gap_2, side_4 > 0.0f);
            var _S626 : f32 = - _S624;
            under_1 = middle_0;
            above_gap_2 = _S625;
            under_gap_2 = _S626;
            side_4 = 1.0f;
        }
        else
        {
            var _S627 : f32 = select(under_gap_2, 0.5f * under_gap_2, side_4 < 0.0f);
            above_3 = middle_0;
            above_gap_2 = _S624;
            under_gap_2 = _S627;
            side_4 = -1.0f;
        }
        var _S628 : f32 = select(between_0(above_3, under_1, above_gap_2, under_gap_2), clamp(middle_0 + _S624 / min(ViewRay_rate_0(_S616, _S623), -9.99999997475242708e-07f), under_1, above_3), _S619.smooth_0);
        var _S629 : u32 = i_1 + u32(1);
        middle_0 = _S628;
        i_1 = _S629;
    }
    return select(under_1, middle_0, _S619.smooth_0);
}

fn first_hit_of_yarn_0( _S630 : u32,  _S631 : SearchQuality_0,  _S632 : f32,  _S633 : f32,  _S634 : vec3<f32>,  _S635 : bool) -> Hit_0
{
    var _S636 : f32 = max(_S634.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S632, _S633);
    var _S637 : vec2<f32> = _S634.xy / vec2<f32>(_S636);
    ray_0.slope_1 = _S637;
    var _S638 : StepControl_0 = step_control_0((vec2<f32>(0) - _S637), 1.0f / max(steps_per_length_0(_S630, _S631, _S634) / _S636, 9.99999971718068537e-10f));
    var _S639 : ViewRayEnd_0 = search_down_0(_S630, ray_0, _S638, _S635);
    var hit_0 : Hit_0;
    hit_0.hole_3 = false;
    var _S640 : f32 = refined_height_0(_S630, ray_0, _S638, _S635, _S639, _S631.refinements_0);
    hit_0.height_4 = _S640;
    var _S641 : vec2<f32> = ViewRay_at_0(ray_0, _S640);
    hit_0.x_13 = _S641.x;
    hit_0.y_5 = _S641.y;
    return hit_0;
}

fn first_hit_0( _S642 : u32,  _S643 : SearchQuality_0,  _S644 : f32,  _S645 : f32,  _S646 : vec3<f32>,  _S647 : bool) -> Hit_0
{
    if(!passes_through_0(_S642, _S643, _S644, _S645, _S646, _S647))
    {
        return first_hit_of_yarn_0(_S642, _S643, _S644, _S645, _S646, _S647);
    }
    var hit_1 : Hit_0;
    hit_1.x_13 = _S644;
    hit_1.y_5 = _S645;
    hit_1.height_4 = 0.0f;
    hit_1.hole_3 = true;
    return hit_1;
}

fn taps_at_yarns_0( _S648 : u32,  _S649 : Footprint_0,  _S650 : AnisotropicTaps_0,  _S651 : vec3<f32>,  _S652 : bool) -> AnisotropicTaps_0
{
    var _S653 : f32 = 1.0f - clamp(natural_logarithm_0(max(AnisotropicTaps_size_0(_S650), 9.99999997475242708e-07f) / 0.25f) * 0.48089835047721863f, 0.0f, 1.0f);
    if(_S653 <= 0.0f)
    {
        return _S650;
    }
    var _S654 : Hit_0 = first_hit_0(_S648, default_quality_0(), _S649.centre_0.x, _S649.centre_0.y, _S651, _S652);
    if(_S654.hole_3)
    {
        return _S650;
    }
    var moved_2 : AnisotropicTaps_0 = _S650;
    moved_2.centre_1 = moved_2.centre_1 + vec2<f32>(_S653) * vec2<f32>(fabrics_0[_S648].neural_0.ends_per_mm_0, fabrics_0[_S648].neural_0.picks_per_mm_0) * (vec2<f32>(_S654.x_13, _S654.y_5) - _S649.centre_0);
    return moved_2;
}

fn add_texel_0( _S655 : u32,  _S656 : u32,  _S657 : f32,  _S658 : ptr<function, array<f32, i32(88)>>)
{
    var _S659 : u32 = fabrics_0[_S655].neural_0.latents_0 + _S656 * u32(8);
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
        var _S660 : Eight_0 = eight_halves_0(packed_numbers_0[_S659 + part_0]);
        var _S661 : i32 = i32(u32(8) * part_0);
        (*_S658)[_S661] = (*_S658)[_S661] + _S657 * _S660.low_0[i32(0)];
        (*_S658)[_S661 + i32(4)] = (*_S658)[_S661 + i32(4)] + _S657 * _S660.high_0[i32(0)];
        var _S662 : i32 = _S661 + i32(1);
        (*_S658)[_S662] = (*_S658)[_S662] + _S657 * _S660.low_0[i32(1)];
        (*_S658)[_S662 + i32(4)] = (*_S658)[_S662 + i32(4)] + _S657 * _S660.high_0[i32(1)];
        var _S663 : i32 = _S661 + i32(2);
        (*_S658)[_S663] = (*_S658)[_S663] + _S657 * _S660.low_0[i32(2)];
        (*_S658)[_S663 + i32(4)] = (*_S658)[_S663 + i32(4)] + _S657 * _S660.high_0[i32(2)];
        var _S664 : i32 = _S661 + i32(3);
        (*_S658)[_S664] = (*_S658)[_S664] + _S657 * _S660.low_0[i32(3)];
        (*_S658)[_S664 + i32(4)] = (*_S658)[_S664 + i32(4)] + _S657 * _S660.high_0[i32(3)];
        part_0 = part_0 + u32(1);
    }
    return;
}

fn add_level_0( _S665 : u32,  _S666 : u32,  _S667 : bool,  _S668 : vec2<f32>,  _S669 : f32,  _S670 : ptr<function, array<f32, i32(88)>>)
{
    var _S671 : Neural_std430_0 = fabrics_0[_S665].neural_0;
    var _S672 : u32 = fabrics_0[_S665].neural_0.levels_1 + u32(4) * _S666;
    var _S673 : f32 = table_number_0(_S672);
    var _S674 : f32 = table_number_0(_S672 + u32(1));
    var _S675 : f32 = table_number_0(_S672 + u32(2));
    var _S676 : vec2<f32> = _S668 * vec2<f32>(table_number_0(_S672 + u32(3))) - vec2<f32>(select(0.5f, 1.0f, ((_S666 > u32(3)) & ((_S666 < (fabrics_0[_S665].neural_0.top_level_0))))));
    var _S677 : vec2<f32> = floor(_S676);
    var _S678 : vec2<f32> = _S676 - _S677;
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
        var _S679 : f32 = f32((corner_1 & (u32(1))));
        var _S680 : f32 = f32((corner_1 >> (u32(1))));
        var _S681 : vec2<f32> = mix(vec2<f32>(1.0f) - _S678, _S678, vec2<f32>(_S679, _S680));
        add_texel_0(_S665, u32(_S673 + wrapped_0(_S677.y + _S680, _S675) * _S674 + wrapped_0(_S677.x + _S679, _S674)) + select(u32(0), _S671.texels_0, _S667), _S669 * _S681.x * _S681.y, &((*_S670)));
        corner_1 = corner_1 + u32(1);
    }
    return;
}

fn code_footprint_0( _S682 : u32,  _S683 : AnisotropicTaps_0,  _S684 : vec3<f32>,  _S685 : bool,  _S686 : ptr<function, array<f32, i32(88)>>)
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
        (*_S686)[k_0] = 0.0f;
        k_0 = k_0 + i32(1);
    }
    var _S687 : vec2<f32> = vec2<f32>(fabrics_0[_S682].neural_0.ends_0, fabrics_0[_S682].neural_0.picks_0);
    var _S688 : f32 = f32(fabrics_0[_S682].neural_0.top_level_0);
    var _S689 : f32 = clamp(binary_logarithm_0(max(_S683.side_2, 9.99999997475242708e-07f)) + 3.0f, 0.0f, _S688);
    var _S690 : f32 = min(floor(_S689), _S688 - 1.0f);
    var _S691 : u32 = select(u32(1), u32(4), AnisotropicTaps_has_steps_0(_S683));
    var number_6 : u32 = u32(0);
    for(;;)
    {
        if(number_6 < (u32(2) * _S691))
        {
        }
        else
        {
            break;
        }
        var _S692 : vec2<f32> = AnisotropicTaps_place_0(_S683, (number_6 >> (u32(1))));
        var _S693 : bool = ((number_6 & (u32(1)))) != u32(0);
        var _S694 : f32 = _S689 - _S690;
        add_level_0(_S682, u32(_S690) + select(u32(0), u32(1), _S693), _S685, clamp(_S692 - _S687 * floor(_S692 / _S687), vec2<f32>(0.0f), _S687), select(1.0f - _S694, _S694, _S693) / f32(_S691), &((*_S686)));
        number_6 = number_6 + u32(1);
    }
    var number_7 : i32 = i32(0);
    for(;;)
    {
        if(number_7 < i32(3))
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
            var offset_1 : f32 = _S684[number_7] - (f32(bin_0) + 0.5f) / 8.0f;
            var offset_2 : f32;
            if(number_7 < i32(2))
            {
                offset_2 = offset_1 - round(offset_1);
            }
            else
            {
                offset_2 = offset_1;
            }
            (*_S686)[i32(64) + number_7 * i32(8) + bin_0] = bump_0(offset_2 * 3.20000004768371582f);
            bin_0 = bin_0 + i32(1);
        }
        number_7 = number_7 + i32(1);
    }
    return;
}

fn crown_fibres_0( _S695 : u32,  _S696 : bool,  _S697 : bool) -> vec3<f32>
{
    if(_S696)
    {
        return vec3<f32>(select(1.0f, -1.0f, _S697) * fabrics_0[_S695].neural_0.warp_x_0, fabrics_0[_S695].neural_0.warp_y_0, fabrics_0[_S695].neural_0.warp_roughness_0);
    }
    return vec3<f32>(fabrics_0[_S695].neural_0.weft_x_0, select(1.0f, -1.0f, _S697) * fabrics_0[_S695].neural_0.weft_y_0, fabrics_0[_S695].neural_0.weft_roughness_0);
}

fn yarns_over_0( _S698 : u32,  _S699 : Footprint_0,  _S700 : bool) -> Yarns_0
{
    var _S701 : vec2<f32> = _S699.dx_0;
    var _S702 : vec2<f32> = _S699.dy_0;
    var _S703 : vec2<f32> = sqrt(_S701 * _S701 + _S702 * _S702);
    var _S704 : f32 = Footprint_spread_side_0(_S699);
    var _S705 : vec4<f32> = vec4<f32>(0.0f);
    var yarns_1 : Yarns_0 = Yarns_x24init_0(_S705, _S705, vec3<f32>(0.0f));
    var _S706 : bool = (fabrics_0[_S698].is_irregular_0) != u32(0);
    var number_8 : u32 = u32(0);
    for(;;)
    {
        if(number_8 < select(u32(0), u32(2), _S706))
        {
        }
        else
        {
            break;
        }
        var _S707 : bool = number_8 == u32(0);
        var _S708 : u32 = select(fabrics_0[_S698].weft_0, fabrics_0[_S698].warp_0, _S707);
        var _S709 : vec2<f32> = select_vector_1(_S707, _S699.centre_0, _S699.centre_0.yx);
        var _S710 : vec2<f32> = select_vector_1(_S707, _S703, _S703.yx);
        var _S711 : f32 = _S709.x;
        var _S712 : Cell_0 = locate_0(_S708, _S711);
        var yarn_3 : vec4<f32> = irregular_over_0(_S708, irregular_key_0(_S698, number_8), irregular_thread_0(_S708, _S711, _S712) + _S712.below_0 / (_S712.below_0 + _S712.above_0), _S710.x * (families_0[_S708].count_0 / families_0[_S708].period_0), _S709.y, _S710.y);
        yarn_3[i32(1)] = yarn_3[i32(1)] * (1.0f - moved_share_0(_S708, _S704));
        yarns_1.warp_2 = yarns_1.weft_2;
        yarns_1.weft_2 = yarn_3;
        number_8 = number_8 + u32(1);
    }
    var _S713 : vec2<f32> = vec2<f32>(families_0[fabrics_0[_S698].warp_0].cover_0, families_0[fabrics_0[_S698].weft_0].cover_0);
    var _S714 : f32 = select(fabrics_0[_S698].warp_on_top_0, 1.0f - fabrics_0[_S698].warp_on_top_0, _S700);
    var _S715 : vec3<f32> = shown_of_covers_0(_S713, _S714);
    var _S716 : vec3<f32> = select_vector_2(_S706, shown_of_covers_0(saturate(_S713 + _S713 * vec2<f32>(yarns_1.warp_2.y, yarns_1.weft_2.y)), _S714) / max(_S715, vec3<f32>(0.00009999999747379f)), vec3<f32>(1.0f));
    yarns_1.shares_0 = _S716;
    yarns_1.shares_0[i32(2)] = select(1.0f, _S716.z, (_S715.z) > 0.00009999999747379f);
    return yarns_1;
}

fn neural_view_0( _S717 : u32,  _S718 : Footprint_0,  _S719 : vec3<f32>,  _S720 : ptr<function, NeuralView_0>)
{
    var _S721 : bool = (_S719.z) < 0.0f;
    var _S722 : vec3<f32> = to_face_frame_0(_S719, _S721);
    var _S723 : AnisotropicTaps_0 = taps_at_yarns_0(_S717, _S718, anisotropic_taps_0(_S717, _S718), _S722, _S721);
    var _S724 : vec3<f32> = footprint_coordinates_0(_S723);
    var weights_23 : HalfWeights_0;
    weights_23.first_2 = fabrics_0[_S717].neural_0.network_0;
    var inputs_23 : array<f32, i32(88)>;
    code_footprint_0(_S717, _S723, _S724, _S721, &(inputs_23));
    var hidden_1 : array<f32, i32(64)>;
    dense_7(weights_23, u32(0), false, &(inputs_23), &(hidden_1));
    var fused_0 : array<f32, i32(68)>;
    dense_part_8(weights_23, u32(712), false, &(hidden_1), &(fused_0));
    fused_0[i32(64)] = _S722.x;
    fused_0[i32(65)] = _S722.y;
    var _S725 : vec2<f32> = _S722.xy;
    fused_0[i32(66)] = dot(crown_fibres_0(_S717, true, _S721).xy, _S725);
    fused_0[i32(67)] = dot(crown_fibres_0(_S717, false, _S721).xy, _S725);
    var of_hole_0 : array<f32, i32(16)>;
    dense_6(weights_23, u32(1232), false, &(fused_0), &(of_hole_0));
    var hole_4 : array<f32, i32(1)>;
    dense_5(weights_23, u32(1380), false, &(of_hole_0), &(hole_4));
    var _S726 : array<f32, i32(64)> = (*_S720).sums_9;
    dense_4(weights_23, u32(1392), false, &(fused_0), &(_S726));
    (*_S720).sums_9 = _S726;
    var _S727 : f32 = clamp(hole_4[i32(0)], 0.0f, 1.0f);
    (*_S720).even_hole_0 = _S727;
    (*_S720).yarns_0 = yarns_over_0(_S717, _S718, _S721);
    (*_S720).hole_2 = min(_S727 * (*_S720).yarns_0.shares_0.z, 1.0f);
    (*_S720).correction_weight_0 = correction_weight_of_0(_S724.z);
    (*_S720).view_7 = _S722;
    (*_S720).back_6 = _S721;
    return;
}

struct FamilyAlbedos_0
{
     warp_7 : Albedos_0,
     weft_7 : Albedos_0,
};

fn albedos_over_0( _S728 : u32,  _S729 : Footprint_0,  _S730 : bool) -> FamilyAlbedos_0
{
    var _S731 : vec2<f32> = _S729.dx_0;
    var _S732 : vec2<f32> = _S729.dy_0;
    var _S733 : vec2<f32> = sqrt(_S731 * _S731 + _S732 * _S732);
    var _S734 : Stretch_0 = stretch_of_0(fabrics_0[_S728].warp_0, _S729.centre_0.x, _S733.x);
    var _S735 : Stretch_0 = stretch_of_0(fabrics_0[_S728].weft_0, _S729.centre_0.y, _S733.y);
    var albedos_4 : FamilyAlbedos_0;
    albedos_4.warp_7 = mean_albedos_0(fabrics_0[_S728].warp_0, fabrics_0[_S728].weft_0, _S734, _S735, _S730);
    albedos_4.weft_7 = mean_albedos_0(fabrics_0[_S728].weft_0, fabrics_0[_S728].warp_0, _S735, _S734, _S730);
    return albedos_4;
}

fn toned_0( _S736 : u32,  _S737 : u32,  _S738 : Albedos_0,  _S739 : vec4<f32>) -> Albedos_0
{
    var _S740 : vec3<f32> = _S738.diffuse_reflect_0 + _S738.diffuse_transmit_0;
    var _S741 : vec3<f32> = vec3<f32>(1.0f);
    var _S742 : vec3<f32> = _S741 - vec3<f32>(fabrics_0[_S736].layer_bound_0) * max(_S738.specular_reflect_0, _S738.specular_transmit_0);
    var _S743 : vec3<f32> = vec3<f32>(0.0f);
    var _S744 : vec3<f32> = max(_S741 - _S740, _S743) / (_S741 + _S740);
    var _S745 : vec3<f32> = vec3<f32>(9.99999997475242708e-07f);
    var _S746 : vec3<f32> = (_S742 / max(_S740, _S745) - _S741) / max(vec3<f32>(0.89999997615814209f) * _S744, _S745);
    var _S747 : vec3<f32> = _S741 - vec3<f32>((saturate(min(min(_S746.x, _S746.y), _S746.z)) * _S739.z)) * _S744;
    var _S748 : vec3<f32> = min(vec3<f32>(families_0[_S737].nep_red_0, families_0[_S737].nep_green_0, families_0[_S737].nep_blue_0), _S742);
    var found_1 : Albedos_0 = _S738;
    var _S749 : f32 = _S739.w;
    var _S750 : vec3<f32> = _S747 * _S738.diffuse_transmit_0 * vec3<f32>((1.0f - _S749));
    found_1.diffuse_transmit_0 = _S750;
    found_1.diffuse_reflect_0 = clamp(mix(_S747 * _S738.diffuse_reflect_0, _S748, vec3<f32>(_S749)), _S743, max(_S742 - _S750, _S743));
    return found_1;
}

fn with_tones_0( _S751 : u32,  _S752 : FamilyAlbedos_0,  _S753 : Yarns_0) -> FamilyAlbedos_0
{
    if((fabrics_0[_S751].is_irregular_0) == u32(0))
    {
        return _S752;
    }
    var result_2 : FamilyAlbedos_0;
    result_2.warp_7 = toned_0(_S751, fabrics_0[_S751].warp_0, _S752.warp_7, _S753.warp_2);
    result_2.weft_7 = toned_0(_S751, fabrics_0[_S751].weft_0, _S752.weft_7, _S753.weft_2);
    return result_2;
}

fn light_sample_count_0() -> u32
{
    return frame_record_0.lights_0 + frame_record_0.environment_samples_0;
}

fn visibility_at_0( _S754 : u32,  _S755 : vec2<u32>) -> f32
{
    if((frame_record_0.casts_shadows_0) == u32(0))
    {
        return 1.0f;
    }
    return visibilities_0[(_S754 * frame_record_0.height_0 + _S755.y) * frame_record_0.width_0 + _S755.x];
}

struct LightSample_0
{
     towards_0 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_4 : f32,
};

fn environment_texel_0( _S756 : u32,  _S757 : u32) -> vec3<f32>
{
    var _S758 : u32 = frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + frame_record_0.environment_rows_0 * (frame_record_0.environment_columns_0 + u32(1)) + u32(3) * (_S756 * frame_record_0.environment_columns_0 + _S757);
    return vec3<f32>(scene_number_0(_S758), scene_number_0(_S758 + u32(1)), scene_number_0(_S758 + u32(2)));
}

fn sample_environment_0( _S759 : vec2<f32>,  _S760 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S761 : u32 = frame_record_0.environment_rows_0;
    var _S762 : Choice_0 = choose_0(frame_record_0.environment_table_0, frame_record_0.environment_rows_0, _S759.y);
    var _S763 : u32 = frame_record_0.environment_columns_0;
    var _S764 : Choice_0 = choose_0(frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + _S762.index_7 * (frame_record_0.environment_columns_0 + u32(1)), frame_record_0.environment_columns_0, _S759.x);
    var _S765 : vec3<f32> = environment_texel_0(_S762.index_7, _S764.index_7);
    (*_S760) = _S765 * vec3<f32>((frame_record_0.environment_total_0 / max(mean_0(_S765), 9.99999968265522539e-21f)));
    var _S766 : f32 = 3.14159274101257324f / f32(_S761);
    var _S767 : f32 = mix(sine_cosine_0(f32(_S762.index_7) * _S766).y, sine_cosine_0(f32(_S762.index_7 + u32(1)) * _S766).y, _S762.remainder_0);
    var _S768 : f32 = sqrt(max(1.0f - _S767 * _S767, 0.0f));
    var _S769 : vec2<f32> = sine_cosine_0((f32(_S764.index_7) + _S764.remainder_0) * (6.28318548202514648f / f32(_S763)));
    var _S770 : f32 = _S768 * _S769.x;
    var _S771 : f32 = - _S768 * _S769.y;
    return vec3<f32>(frame_record_0.environment_cosine_0 * _S770 + frame_record_0.environment_sine_0 * _S771, _S767, frame_record_0.environment_cosine_0 * _S771 - frame_record_0.environment_sine_0 * _S770);
}

fn light_sample_0( _S772 : u32,  _S773 : vec2<u32>,  _S774 : vec3<f32>) -> LightSample_0
{
    var sample_1 : LightSample_0;
    sample_1.distance_4 = 1.00000001504746622e+30f;
    var _S775 : u32 = frame_record_0.lights_0;
    if(_S772 >= (frame_record_0.lights_0))
    {
        var weight_3 : vec3<f32>;
        var _S776 : vec3<f32> = sample_environment_0(pixel_sequence_0(_S773, frame_record_0.pass_number_0 * frame_record_0.environment_samples_0 + (_S772 - _S775), u32(3)), &(weight_3));
        sample_1.towards_0 = _S776;
        sample_1.irradiance_1 = weight_3 / vec3<f32>(f32(frame_record_0.environment_samples_0));
        return sample_1;
    }
    var _S777 : Light_0 = scene_light_0(frame_record_0.light_records_0 + u32(7) * _S772);
    sample_1.irradiance_1 = vec3<f32>(_S777.red_0, _S777.green_0, _S777.blue_0);
    sample_1.towards_0 = vec3<f32>(_S777.x_9, _S777.y_1, _S777.z_1);
    if((_S777.is_point_0) != u32(0))
    {
        var _S778 : vec3<f32> = sample_1.towards_0 - _S774;
        var _S779 : f32 = max(square_0(_S778), 9.999999960041972e-13f);
        sample_1.distance_4 = sqrt(_S779);
        sample_1.irradiance_1 = sample_1.irradiance_1 / vec3<f32>(_S779);
        sample_1.towards_0 = normalize(_S778);
    }
    return sample_1;
}

struct Components_0
{
     diffuse_warp_0 : f32,
     diffuse_weft_0 : f32,
     specular_warp_0 : f32,
     specular_weft_0 : f32,
     light_visibility_1 : f32,
     hole_5 : f32,
};

fn code_light_0( _S780 : u32,  _S781 : vec3<f32>,  _S782 : vec3<f32>,  _S783 : bool,  _S784 : ptr<function, array<f32, i32(39)>>)
{
    (*_S784)[i32(0)] = _S781.x;
    (*_S784)[i32(1)] = _S781.y;
    (*_S784)[i32(2)] = _S781.z;
    var _S785 : vec3<f32> = _S781 + _S782;
    var _S786 : f32 = _S785.z;
    var _S787 : f32 = _S786 * _S786 + 0.00009999999747379f;
    var _S788 : vec2<f32> = _S785.xy;
    var _S789 : f32 = 1.0f / (dot(_S788, _S788) + _S787);
    var family_20 : i32 = i32(0);
    for(;;)
    {
        if(family_20 < i32(2))
        {
        }
        else
        {
            break;
        }
        var _S790 : vec3<f32> = crown_fibres_0(_S780, family_20 == i32(0), _S783);
        var _S791 : vec2<f32> = _S790.xy;
        (*_S784)[i32(3) + family_20] = dot(_S791, _S781.xy);
        var _S792 : f32 = dot(_S791, _S788);
        var _S793 : f32 = _S792 * _S792;
        var _S794 : f32 = (0.75f * _S792 / (0.5f * sqrt(_S793 + _S787) + abs(_S792)) + 0.5f) * 8.0f;
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
            (*_S784)[i32(5) + family_20 * i32(16) + bin_1] = bump_0(_S794 - (f32(bin_1) + 0.5f) / 2.0f);
            bin_1 = bin_1 + i32(1);
        }
        var _S795 : f32 = _S790.z;
        var _S796 : f32 = _S795 * _S795;
        var _S797 : f32 = _S793 * _S789 * (1.0f - _S796) + _S796;
        (*_S784)[i32(37) + family_20] = 0.25f * natural_logarithm_0(1.0f + 9.54929637908935547f * _S796 * _S795 / (_S797 * _S797));
        family_20 = family_20 + i32(1);
    }
    return;
}

fn mixed_bundles_0( _S798 : u32,  _S799 : u32,  _S800 : u32,  _S801 : vec3<f32>,  _S802 : vec3<f32>,  _S803 : bool,  _S804 : ptr<function, array<f32, i32(52)>>) -> f32
{
    var _S805 : vec3<f32> = _S801 + _S802;
    var _S806 : f32 = 1.0f / (square_0(_S805) + 0.00009999999747379f);
    var _S807 : f32 = _S805.x;
    var _S808 : f32 = select(_S807, - _S807, ((_S799 == u32(0)) & (_S803)));
    var _S809 : f32 = _S805.y;
    var _S810 : f32 = select(_S809, - _S809, ((_S799 == u32(1)) & (_S803)));
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
        var _S811 : u32 = _S799 * u32(25);
        var _S812 : u32 = fabrics_0[_S798].neural_0.bundles_0 + u32(4) * (_S811 + bundle_1);
        var _S813 : f32 = dot(vec3<f32>(table_number_0(_S812), table_number_0(_S812 + u32(1)), table_number_0(_S812 + u32(2))), vec3<f32>(_S808, _S810, _S805.z));
        var _S814 : f32 = _S813 * _S813 * _S806 + table_number_0(_S812 + u32(3));
        var sum_3 : f32 = sum_2 + max((*_S804)[_S800 + _S811 + select(bundle_1, mirrored_bundle_0(bundle_1), _S803)], (*_S804)[_S800 + _S811 + select(bundle_1, mirrored_bundle_0(bundle_1), _S803)] * 0.00999999977648258f) / (_S814 * _S814);
        bundle_1 = bundle_1 + u32(1);
        sum_2 = sum_3;
    }
    return 0.01999999955296516f * sum_2;
}

fn with_shares_0( _S815 : u32,  _S816 : Components_0,  _S817 : Yarns_0) -> Components_0
{
    var result_3 : Components_0;
    var _S818 : f32 = min(_S816.hole_5 * _S817.shares_0.z, 1.0f);
    result_3.hole_5 = _S818;
    var _S819 : f32 = _S817.shares_0.x;
    result_3.diffuse_warp_0 = _S816.diffuse_warp_0 * _S819;
    var _S820 : f32 = _S817.shares_0.y;
    result_3.diffuse_weft_0 = _S816.diffuse_weft_0 * _S820;
    result_3.specular_warp_0 = _S816.specular_warp_0 * _S819;
    result_3.specular_weft_0 = _S816.specular_weft_0 * _S820;
    result_3.light_visibility_1 = _S816.light_visibility_1 * select(1.0f, (1.0f - _S818) / max(1.0f - _S816.hole_5, 9.99999997475242708e-07f), (fabrics_0[_S815].is_irregular_0) != u32(0));
    return result_3;
}

fn neural_components_0( _S821 : u32,  _S822 : ptr<function, NeuralView_0>,  _S823 : vec3<f32>) -> Components_0
{
    var _S824 : bool = (*_S822).back_6;
    var _S825 : vec3<f32> = to_face_frame_0(_S823, (*_S822).back_6);
    var _S826 : vec3<f32> = (*_S822).view_7;
    var weights_24 : HalfWeights_0;
    var _S827 : Neural_std430_0 = fabrics_0[_S821].neural_0;
    weights_24.first_2 = fabrics_0[_S821].neural_0.network_0;
    var directions_0 : array<f32, i32(39)>;
    code_light_0(_S821, _S825, (*_S822).view_7, (*_S822).back_6, &(directions_0));
    var skip_0 : array<f32, i32(64)>;
    var k_1 : i32 = i32(0);
    for(;;)
    {
        if(k_1 < i32(64))
        {
        }
        else
        {
            break;
        }
        skip_0[k_1] = (*_S822).sums_9[k_1];
        k_1 = k_1 + i32(1);
    }
    dense_3(weights_24, u32(1976), true, &(directions_0), &(skip_0));
    var hidden_2 : array<f32, i32(64)>;
    var next_0 : array<f32, i32(64)>;
    k_1 = i32(0);
    for(;;)
    {
        if(k_1 < i32(64))
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
            if(k_1 < i32(64))
            {
            }
            else
            {
                break;
            }
            next_0[k_1] = select(0.0f, skip_0[k_1], layer_0 == u32(1));
            k_1 = k_1 + i32(1);
        }
        dense_2(weights_24, u32(2304) + layer_0 * u32(520), true, &(hidden_2), &(next_0));
        var k_2 : i32 = i32(0);
        for(;;)
        {
            if(k_2 < i32(64))
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
    dense_1(weights_24, u32(3864), false, &(hidden_2), &(outputs_17));
    var _S828 : bool;
    if((_S827.is_corrected_0) != u32(0))
    {
        _S828 = (_S825.z) > 0.0f;
    }
    else
    {
        _S828 = false;
    }
    if(_S828)
    {
        _S828 = ((*_S822).correction_weight_0) > 0.0f;
    }
    else
    {
        _S828 = false;
    }
    if(_S828)
    {
        var fitted_0 : FloatWeights_0;
        fitted_0.first_0 = _S827.correction_0;
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
            outputs_17[k_1 + i32(2)] = outputs_17[k_1 + i32(2)] + (*_S822).correction_weight_0 * change_0[k_1];
            k_1 = k_1 + i32(1);
        }
    }
    var _S829 : f32 = select(0.00100000004749745f, 0.00999999977648258f, (_S825.z) > 0.0f);
    var result_4 : Components_0;
    var _S830 : f32 = unmapped_0(outputs_17[i32(0)], _S829);
    result_4.diffuse_warp_0 = _S830;
    var _S831 : f32 = unmapped_0(outputs_17[i32(1)], _S829);
    result_4.diffuse_weft_0 = _S831;
    var _S832 : f32 = 2979.9580078125f * _S829;
    var _S833 : f32 = mixed_bundles_0(_S821, u32(0), u32(2), _S825, _S826, _S824, &(outputs_17));
    result_4.specular_warp_0 = clamp(_S833, 0.0f, _S832);
    var _S834 : f32 = mixed_bundles_0(_S821, u32(1), u32(2), _S825, _S826, _S824, &(outputs_17));
    result_4.specular_weft_0 = clamp(_S834, 0.0f, _S832);
    result_4.hole_5 = (*_S822).even_hole_0;
    result_4.light_visibility_1 = min(light_visibility_of_0(_S830 + _S831, _S825, _S826, fabrics_0[_S821].diffuse_blend_0), 1.0f - (*_S822).even_hole_0);
    return with_shares_0(_S821, result_4, (*_S822).yarns_0);
}

fn openness_number_0( _S835 : u32,  _S836 : u32) -> f32
{
    return table_number_0(fabrics_0[_S835].openness_0 + _S836);
}

fn scattered_by_0( _S837 : u32,  _S838 : Albedos_0,  _S839 : u32,  _S840 : vec3<f32>) -> Scattered_0
{
    var _S841 : u32 = u32(159) + u32(2) * _S839;
    var yarn_4 : Scattered_0;
    yarn_4.back_5 = _S840 * _S838.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S837, _S841)) * _S838.specular_reflect_0;
    yarn_4.through_0 = _S840 * _S838.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S837, _S841 + u32(1))) * _S838.specular_transmit_0;
    return yarn_4;
}

fn sent_0( _S842 : u32,  _S843 : u32,  _S844 : vec3<f32>,  _S845 : vec3<f32>,  _S846 : vec3<f32>,  _S847 : vec3<f32>,  _S848 : ptr<function, vec3<f32>>,  _S849 : ptr<function, vec3<f32>>)
{
    var _S850 : u32 = u32(146) + u32(4) * _S843;
    var _S851 : f32 = openness_number_0(_S842, _S850 + u32(1));
    var _S852 : f32 = openness_number_0(_S842, _S850 + u32(2));
    var _S853 : vec3<f32> = vec3<f32>(1.0f);
    var _S854 : vec3<f32> = _S853 - _S846 * vec3<f32>(openness_number_0(_S842, _S850));
    var _S855 : vec3<f32> = _S853 - _S847 * vec3<f32>(openness_number_0(_S842, _S850 + u32(3)));
    var _S856 : vec3<f32> = _S853 / (_S854 * _S855 - _S846 * _S847 * vec3<f32>((_S851 * _S852)));
    (*_S848) = (_S844 * _S855 + _S846 * vec3<f32>(_S851) * _S845) * _S856;
    (*_S849) = (_S845 * _S854 + _S847 * vec3<f32>(_S852) * _S844) * _S856;
    return;
}

fn face_sends_0( _S857 : u32,  _S858 : u32,  _S859 : Scattered_0,  _S860 : Scattered_0) -> FaceSends_0
{
    var _S861 : u32 = u32(2) * _S858;
    var _S862 : u32 = u32(142) + _S861;
    var _S863 : f32 = openness_number_0(_S857, _S862);
    var _S864 : f32 = openness_number_0(_S857, _S862 + u32(1));
    var _S865 : vec3<f32> = vec3<f32>((1.0f - _S863)) * _S859.back_5;
    var _S866 : vec3<f32> = vec3<f32>((1.0f - _S864)) * _S860.back_5;
    var sends_1 : FaceSends_0;
    var _S867 : u32 = u32(154) + _S861;
    var _S868 : f32 = openness_number_0(_S857, _S867);
    sends_1.blocks_warp_0 = _S868;
    var _S869 : f32 = openness_number_0(_S857, _S867 + u32(1));
    sends_1.blocks_weft_0 = _S869;
    sends_1.open_0 = _S868 * _S863 + _S869 * _S864;
    var _S870 : vec3<f32> = vec3<f32>(_S863) * _S859.back_5;
    var _S871 : vec3<f32> = vec3<f32>(_S864) * _S860.back_5;
    var _S872 : vec3<f32> = sends_1.sky_warp_0;
    var _S873 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S857, _S858, _S870, _S871, _S865, _S866, &(_S872), &(_S873));
    sends_1.sky_warp_0 = _S872;
    sends_1.sky_weft_0 = _S873;
    var _S874 : vec3<f32> = sends_1.crossing_warp_0;
    var _S875 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S857, _S858, _S859.through_0, _S860.through_0, _S865, _S866, &(_S874), &(_S875));
    sends_1.crossing_warp_0 = _S874;
    sends_1.crossing_weft_0 = _S875;
    return sends_1;
}

fn interior_of_0( _S876 : u32,  _S877 : vec3<f32>,  _S878 : bool) -> Interior_0
{
    var _S879 : Scattered_0 = scattered_by_0(_S876, table_albedos_0(families_0[fabrics_0[_S876].warp_0].colour_mean_0), u32(0), _S877);
    var _S880 : Scattered_0 = scattered_by_0(_S876, table_albedos_0(families_0[fabrics_0[_S876].weft_0].colour_mean_0), u32(1), _S877);
    var _S881 : FaceSends_0 = face_sends_0(_S876, select(u32(0), u32(1), _S878), _S879, _S880);
    var _S882 : FaceSends_0 = face_sends_0(_S876, select(u32(1), u32(0), _S878), _S879, _S880);
    var _S883 : vec3<f32> = vec3<f32>(_S881.blocks_warp_0);
    var _S884 : vec3<f32> = vec3<f32>(_S881.blocks_weft_0);
    var _S885 : vec3<f32> = _S883 * _S881.crossing_warp_0 + _S884 * _S881.crossing_weft_0;
    var _S886 : vec3<f32> = vec3<f32>(_S882.blocks_warp_0);
    var _S887 : vec3<f32> = vec3<f32>(_S882.blocks_weft_0);
    var _S888 : vec3<f32> = _S886 * _S882.crossing_warp_0 + _S887 * _S882.crossing_weft_0;
    var _S889 : f32 = 1.0f - _S881.open_0;
    var _S890 : f32 = 1.0f - _S882.open_0;
    var _S891 : vec3<f32> = vec3<f32>(1.0f);
    var _S892 : vec3<f32> = _S891 / (_S891 - _S885 * _S888 * vec3<f32>((_S889 * _S890)));
    var _S893 : vec3<f32> = _S888 * (vec3<f32>(_S881.open_0) + vec3<f32>(_S889) * (_S883 * _S881.sky_warp_0 + _S884 * _S881.sky_weft_0)) * _S892;
    var _S894 : vec3<f32> = _S885 * (vec3<f32>(_S882.open_0) + vec3<f32>(_S890) * (_S886 * _S882.sky_warp_0 + _S887 * _S882.sky_weft_0)) * _S892;
    var _S895 : FaceRadiance_0 = face_radiance_0(_S881, _S882.open_0, _S893, _S894);
    var _S896 : FaceRadiance_0 = face_radiance_0(_S882, _S881.open_0, _S894, _S893);
    var interior_1 : Interior_0;
    interior_1.warp_6 = _S895.warp_5;
    interior_1.weft_6 = _S895.weft_5;
    interior_1.leaked_1 = _S895.leaked_0;
    interior_1.far_1 = _S896.mean_1;
    interior_1.far_leaked_0 = _S896.leaked_0;
    return interior_1;
}

fn blocked_of_terms_0( _S897 : u32,  _S898 : u32,  _S899 : array<f32, i32(6)>,  _S900 : u32) -> Blocked_0
{
    var shares_2 : array<f32, i32(3)>;
    var share_3 : u32 = u32(0);
    for(;;)
    {
        if(share_3 < u32(3))
        {
        }
        else
        {
            break;
        }
        shares_2[share_3] = 0.0f;
        var term_0 : u32 = u32(0);
        for(;;)
        {
            if(term_0 < _S900)
            {
            }
            else
            {
                break;
            }
            shares_2[share_3] = shares_2[share_3] + openness_number_0(_S897, _S898 + share_3 * _S900 + term_0) * _S899[term_0];
            term_0 = term_0 + u32(1);
        }
        shares_2[share_3] = saturate(shares_2[share_3]);
        share_3 = share_3 + u32(1);
    }
    var blocked_2 : Blocked_0;
    blocked_2.by_warp_0 = shares_2[i32(0)] * shares_2[i32(2)];
    blocked_2.by_weft_0 = shares_2[i32(0)] * (1.0f - shares_2[i32(2)]);
    blocked_2.far_0 = shares_2[i32(1)];
    return blocked_2;
}

fn blocked_from_0( _S901 : u32,  _S902 : vec3<f32>,  _S903 : bool,  _S904 : bool) -> Blocked_0
{
    var terms_2 : array<f32, i32(6)>;
    view_terms_0(_S902, &(terms_2));
    return blocked_of_terms_0(_S901, (select(u32(0), u32(2), _S904) + select(u32(1), u32(0), _S903)) * u32(15), terms_2, u32(5));
}

fn warp_seen_from_0( _S905 : u32,  _S906 : vec3<f32>,  _S907 : bool) -> f32
{
    var terms_3 : array<f32, i32(6)>;
    view_terms_1(_S906, &(terms_3));
    var term_1 : u32 = u32(0);
    var share_4 : f32 = 0.0f;
    for(;;)
    {
        if(term_1 < u32(5))
        {
        }
        else
        {
            break;
        }
        var share_5 : f32 = share_4 + openness_number_0(_S905, u32(132) + select(u32(0), u32(5), _S907) + term_1) * terms_3[term_1];
        term_1 = term_1 + u32(1);
        share_4 = share_5;
    }
    return saturate(share_4);
}

fn bounced_of_families_0( _S908 : u32,  _S909 : FamilyAlbedos_0,  _S910 : vec3<f32>,  _S911 : Interior_0,  _S912 : Blocked_0,  _S913 : Blocked_0) -> Bounced_0
{
    return sum_of_0(bounced_by_0(_S912, scattered_by_0(_S908, _S909.warp_7, u32(0), _S910), _S911), bounced_by_0(_S913, scattered_by_0(_S908, _S909.weft_7, u32(1), _S910), _S911));
}

fn bounced_far_0( _S914 : u32,  _S915 : FamilyAlbedos_0,  _S916 : vec3<f32>,  _S917 : Interior_0,  _S918 : vec3<f32>,  _S919 : bool,  _S920 : f32,  _S921 : f32,  _S922 : f32) -> Bounced_0
{
    var _S923 : Blocked_0 = blocked_from_0(_S914, _S918, true, _S919);
    var _S924 : Blocked_0 = blocked_from_0(_S914, _S918, false, _S919);
    var _S925 : f32 = _S920 / max(1.0f - _S923.by_warp_0 - _S923.by_weft_0, 0.10000000149011612f);
    var _S926 : f32 = (0.0020000000949949f * warp_seen_from_0(_S914, _S918, _S919) + _S925) / (_S925 + _S921 / max(1.0f - _S924.by_warp_0 - _S924.by_weft_0, 0.10000000149011612f) + 0.0020000000949949f);
    var _S927 : f32 = 1.0f - _S922;
    return bounced_of_families_0(_S914, _S915, _S916, _S917, scaled_0(_S923, _S926 * _S927), scaled_0(_S924, (1.0f - _S926) * _S927));
}

fn bounced_over_0( _S928 : u32,  _S929 : Components_0,  _S930 : CloseUp_0,  _S931 : FamilyAlbedos_0,  _S932 : vec3<f32>,  _S933 : vec3<f32>) -> Bounced_0
{
    var _S934 : bool = (_S933.z) < 0.0f;
    var _S935 : Interior_0 = interior_of_0(_S928, _S932, _S934);
    var bounced_2 : Bounced_0 = bounced_far_0(_S928, _S931, _S932, _S935, to_face_frame_0(_S933, _S934), _S934, _S929.diffuse_warp_0, _S929.diffuse_weft_0, _S929.hole_5);
    if((_S930.weight_2) > 0.0f)
    {
        var _S936 : Bounced_0 = bounced_of_families_0(_S928, _S931, _S932, _S935, _S930.warp_4, _S930.weft_4);
        var _S937 : vec3<f32> = vec3<f32>(_S930.weight_2);
        bounced_2.reflected_0 = mix(bounced_2.reflected_0, _S936.reflected_0, _S937);
        bounced_2.transmitted_0 = mix(bounced_2.transmitted_0, _S936.transmitted_0, _S937);
    }
    return bounced_2;
}

fn composed_0( _S938 : u32,  _S939 : Components_0,  _S940 : CloseUp_0,  _S941 : FamilyAlbedos_0,  _S942 : vec3<f32>,  _S943 : vec3<f32>,  _S944 : vec3<f32>) -> vec3<f32>
{
    var _S945 : Albedos_0 = tinted_0(_S941.warp_7, _S942);
    var _S946 : Albedos_0 = tinted_0(_S941.weft_7, _S942);
    var _S947 : vec3<f32> = vec3<f32>(_S939.diffuse_warp_0);
    var _S948 : vec3<f32> = vec3<f32>(_S939.diffuse_weft_0);
    var _S949 : vec3<f32> = vec3<f32>(_S939.specular_warp_0);
    var _S950 : vec3<f32> = vec3<f32>(_S939.specular_weft_0);
    var _S951 : vec3<f32> = _S945.diffuse_reflect_0 * _S947 + _S946.diffuse_reflect_0 * _S948 + _S945.specular_reflect_0 * _S949 + _S946.specular_reflect_0 * _S950;
    var _S952 : f32 = _S944.z;
    var body_0 : vec3<f32>;
    if((_S943.z * _S952) < 0.0f)
    {
        body_0 = _S945.diffuse_transmit_0 * _S947 + _S946.diffuse_transmit_0 * _S948 + _S945.specular_transmit_0 * _S949 + _S946.specular_transmit_0 * _S950;
    }
    else
    {
        body_0 = _S951;
    }
    if((fabrics_0[_S938].openness_0) != u32(4294967295))
    {
        body_0 = body_0 + bounced_value_0(bounced_over_0(_S938, _S939, _S940, _S941, _S942, _S944), _S943, _S944);
    }
    var _S953 : f32 = fabrics_0[_S938].sheen_strength_0;
    if((fabrics_0[_S938].sheen_strength_0) <= 0.0f)
    {
        return body_0;
    }
    var _S954 : bool = _S952 < 0.0f;
    var _S955 : vec2<f32> = sheen_with_transmittance_0(to_face_frame_0(_S943, _S954), to_face_frame_0(_S944, _S954), _S953, fabrics_0[_S938].sheen_roughness_0);
    return vec3<f32>(_S955.y) * body_0 + vec3<f32>(((_S939.light_visibility_1 + _S939.hole_5) * _S955.x));
}

fn light_of_neural_0( _S956 : u32,  _S957 : VisiblePoint_0,  _S958 : vec2<u32>,  _S959 : vec3<f32>) -> vec4<f32>
{
    var footprint_1 : Footprint_0;
    footprint_1.dx_0 = _S957.draft_dx_0;
    footprint_1.dy_0 = _S957.draft_dy_0;
    footprint_1.centre_0 = irregular_place_0(_S956, _S957.draft_0, Footprint_spread_side_0(footprint_1));
    var _S960 : vec3<f32> = to_local_0(_S957, _S957.view_0);
    var activations_0 : NeuralView_0;
    neural_view_0(_S956, footprint_1, _S960, &(activations_0));
    var _S961 : f32 = _S960.z;
    var _S962 : FamilyAlbedos_0 = with_tones_0(_S956, albedos_over_0(_S956, footprint_1, _S961 < 0.0f), activations_0.yarns_0);
    var _S963 : vec3<f32> = vec3<f32>(0.0f);
    var number_9 : u32 = u32(0);
    var radiance_1 : vec3<f32> = _S963;
    for(;;)
    {
        if(number_9 < (light_sample_count_0()))
        {
        }
        else
        {
            break;
        }
        var _S964 : f32 = visibility_at_0(number_9, _S958);
        if(_S964 <= 0.0f)
        {
            number_9 = number_9 + u32(1);
            continue;
        }
        var _S965 : LightSample_0 = light_sample_0(number_9, _S958, _S957.position_4);
        var _S966 : vec3<f32> = to_local_0(_S957, _S965.towards_0);
        var _S967 : Components_0 = neural_components_0(_S956, &(activations_0), _S966);
        radiance_1 = radiance_1 + vec3<f32>(_S964) * _S965.irradiance_1 * composed_0(_S956, _S967, no_close_up_0(), _S962, _S959, _S966, _S960);
        number_9 = number_9 + u32(1);
    }
    var hole_6 : f32 = activations_0.hole_2;
    var _S968 : f32 = fabrics_0[_S956].sheen_strength_0;
    var hole_7 : f32;
    if((fabrics_0[_S956].sheen_strength_0) > 0.0f)
    {
        hole_7 = hole_6 * (1.0f - _S968 * sheen_lobe_0(abs(_S961), fabrics_0[_S956].sheen_roughness_0).z);
    }
    else
    {
        hole_7 = hole_6;
    }
    return vec4<f32>(radiance_1, 1.0f - hole_7);
}

@compute
@workgroup_size(8, 8, 1)
fn shade_neural(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S969 : u32 = id_0.x;
    var _S970 : bool;
    if(_S969 >= (frame_record_0.width_0))
    {
        _S970 = true;
    }
    else
    {
        _S970 = (id_0.y) >= (frame_record_0.height_0);
    }
    if(_S970)
    {
        return;
    }
    var _S971 : u32 = id_0.y * frame_record_0.width_0 + _S969;
    var _S972 : u32 = layers_0[_S971].face_0;
    if((layers_0[_S971].face_0) == u32(0))
    {
        return;
    }
    var _S973 : u32 = _S972 - u32(1);
    var _S974 : u32 = fabric_of_0(_S973);
    var _S975 : vec2<u32> = id_0.xy;
    var _S976 : VisiblePoint_0 = visible_point_0(_S974, _S973, _S975);
    accumulate_0(_S971, light_of_neural_0(_S974, _S976, _S975, filtered_albedo_0(_S974, _S976)));
    return;
}

