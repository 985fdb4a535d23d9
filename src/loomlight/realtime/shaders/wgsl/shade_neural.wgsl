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

@id(0) override HAS_LAYERS_0 : bool = true;

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

fn plane_at_0( first_22 : u32) -> Plane_0
{
    var record_1 : Plane_0;
    record_1.warp_1 = words_0[first_22];
    record_1.weft_1 = words_0[first_22 + u32(1)];
    record_1.run_words_1 = words_0[first_22 + u32(2)];
    record_1.ends_2 = words_0[first_22 + u32(3)];
    record_1.end_numbers_0 = words_0[first_22 + u32(4)];
    record_1.pick_numbers_0 = words_0[first_22 + u32(5)];
    record_1.max_heights_1 = words_0[first_22 + u32(6)];
    record_1.max_height_columns_1 = words_0[first_22 + u32(7)];
    record_1.height_low_1 = (bitcast<f32>((words_0[first_22 + u32(8)])));
    record_1.height_high_1 = (bitcast<f32>((words_0[first_22 + u32(9)])));
    record_1.front_level_0 = (bitcast<f32>((words_0[first_22 + u32(10)])));
    record_1.back_level_0 = (bitcast<f32>((words_0[first_22 + u32(11)])));
    record_1.start_x_0 = (bitcast<f32>((words_0[first_22 + u32(12)])));
    record_1.start_y_0 = (bitcast<f32>((words_0[first_22 + u32(13)])));
    record_1.fine_x_0 = (bitcast<f32>((words_0[first_22 + u32(14)])));
    record_1.fine_y_0 = (bitcast<f32>((words_0[first_22 + u32(15)])));
    return record_1;
}

struct Crossing_0
{
     warp_2 : Cell_0,
     weft_2 : Cell_0,
     warp_word_0 : u32,
     weft_word_0 : u32,
     warp_above_0 : bool,
};

fn crossing_at_0( plane_0 : Plane_0,  x_8 : f32,  y_1 : f32,  back_3 : bool) -> Crossing_0
{
    var crossing_0 : Crossing_0;
    crossing_0.warp_2 = locate_0(plane_0.warp_1, x_8 - plane_0.start_x_0);
    crossing_0.weft_2 = locate_0(plane_0.weft_1, y_1 - plane_0.start_y_0);
    var _S216 : u32 = plane_0.run_words_1 + u32(2) * (crossing_0.weft_2.thread_1 * plane_0.ends_2 + crossing_0.warp_2.thread_1);
    var _S217 : u32 = words_0[_S216];
    crossing_0.warp_word_0 = _S217;
    crossing_0.weft_word_0 = words_0[_S216 + u32(1)];
    crossing_0.warp_above_0 = (((_S217 & (u32(1)))) == u32(1)) != back_3;
    return crossing_0;
}

fn cell_maximum_0( plane_1 : Plane_0,  crossing_1 : Crossing_0) -> f32
{
    var _S218 : u32 = select(plane_1.weft_1, plane_1.warp_1, crossing_1.warp_above_0);
    return f32((select(crossing_1.weft_word_0, crossing_1.warp_word_0, crossing_1.warp_above_0) >> (u32(28)))) * families_0[_S218].height_scale_0 * families_0[_S218].level_0;
}

fn bounds_in_0( plane_2 : Plane_0,  x_9 : f32,  y_2 : f32,  back_4 : bool,  right_0 : bool,  up_0 : bool) -> vec3<f32>
{
    var _S219 : Crossing_0 = crossing_at_0(plane_2, x_9, y_2, back_4);
    return vec3<f32>(cell_maximum_0(plane_2, _S219), select(_S219.warp_2.below_0, _S219.warp_2.above_0, right_0), select(_S219.weft_2.below_0, _S219.weft_2.above_0, up_0));
}

fn hole_edge_0( cell_5 : Cell_0,  forwards_0 : bool) -> f32
{
    var _S220 : f32 = select(- cell_5.across_0, cell_5.across_0, forwards_0);
    var _S221 : f32 = - cell_5.half_width_1;
    return select(select(cell_5.half_width_1, _S221, _S220 < _S221) - _S220, 2.0f * select(cell_5.below_0, cell_5.above_0, forwards_0) + _S220 - cell_5.half_width_1, _S220 >= (cell_5.half_width_1));
}

struct Shown_0
{
     is_warp_0 : bool,
     hole_0 : bool,
     on_top_0 : bool,
     word_0 : u32,
};

fn shown_at_0( crossing_2 : Crossing_0,  back_5 : bool) -> Shown_0
{
    var _S222 : bool = (abs(crossing_2.warp_2.across_0)) < (crossing_2.warp_2.half_width_1);
    var shown_0 : Shown_0;
    var _S223 : bool = !((abs(crossing_2.weft_2.across_0)) < (crossing_2.weft_2.half_width_1));
    var _S224 : bool = (_S222 & (((_S223 | ((crossing_2.warp_above_0))))));
    shown_0.is_warp_0 = _S224;
    shown_0.hole_0 = ((!_S222) & (_S223));
    var _S225 : u32 = select(crossing_2.weft_word_0, crossing_2.warp_word_0, _S224);
    shown_0.word_0 = _S225;
    shown_0.on_top_0 = (((_S225 & (u32(1)))) == u32(1)) != back_5;
    return shown_0;
}

fn select_cell_0( is_first_0 : bool,  first_23 : Cell_0,  second_1 : Cell_0) -> Cell_0
{
    var cell_6 : Cell_0;
    cell_6.thread_1 = select(second_1.thread_1, first_23.thread_1, is_first_0);
    cell_6.across_0 = select(second_1.across_0, first_23.across_0, is_first_0);
    cell_6.half_width_1 = select(second_1.half_width_1, first_23.half_width_1, is_first_0);
    cell_6.below_0 = select(second_1.below_0, first_23.below_0, is_first_0);
    cell_6.above_0 = select(second_1.above_0, first_23.above_0, is_first_0);
    return cell_6;
}

fn boundary_0( family_9 : u32,  thread_3 : u32,  step_0 : i32) -> f32
{
    var _S226 : vec2<f32> = turns_and_remainder_0(family_9, f32(i32(thread_3) + step_0));
    return fma(_S226.x, families_0[family_9].period_0, table_number_0(families_0[family_9].place_table_0 + u32(_S226.y) * u32(4)));
}

fn span_0( family_10 : u32,  thread_4 : u32,  first_24 : i32,  last_0 : i32) -> f32
{
    if((families_0[family_10].is_alike_0) != u32(0))
    {
        return f32(last_0 - first_24) * families_0[family_10].size_0;
    }
    return boundary_0(family_10, thread_4, last_0) - boundary_0(family_10, thread_4, first_24);
}

struct Bend_0
{
     sine_0 : f32,
     half_tangent_0 : f32,
     arc_0 : f32,
};

fn bend_of_0( family_11 : u32,  thread_5 : u32) -> Bend_0
{
    var _S227 : u32 = families_0[family_11].bend_table_0 + select(thread_5 * u32(4), u32(0), (families_0[family_11].is_alike_0) != u32(0));
    var bend_0 : Bend_0;
    bend_0.sine_0 = table_number_0(_S227);
    bend_0.half_tangent_0 = table_number_0(_S227 + u32(1));
    bend_0.arc_0 = table_number_0(_S227 + u32(2));
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
    var _S228 : i32 = i32((((word_1 >> (u32(1)))) & (u32(127))));
    var _S229 : i32 = i32((((word_1 >> (u32(8)))) & (u32(127))));
    var _S230 : i32 = i32((((word_1 >> (u32(15)))) & (u32(63))));
    var _S231 : i32 = i32((((word_1 >> (u32(21)))) & (u32(63))));
    var run_0 : Run_0;
    var _S232 : bool = ((((word_1 >> (u32(27)))) & (u32(1)))) == u32(1);
    run_0.straight_0 = _S232;
    var _S233 : i32 = - _S228;
    var _S234 : f32 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_1, _S233, i32(0));
    run_0.from_start_0 = _S234;
    var _S235 : i32 = _S229 + i32(1);
    var _S236 : f32 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_1, i32(1), _S235);
    run_0.to_end_0 = _S236;
    var _S237 : bool = _S234 < _S236;
    run_0.near_start_0 = _S237;
    var _S238 : i32 = select(_S235, _S233 - _S230, _S237);
    var _S239 : i32 = select(_S235 + _S231, _S233, _S237);
    run_0.bend_1 = bend_of_0(own_0, thread_6);
    run_0.distance_0 = select(min(_S234, _S236), 1.0e+06f, _S232);
    run_0.reach_0 = min(0.5f * (_S234 + _S236), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_1, _S238, _S239), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S228 == i32(0);
    run_0.last_crossing_0 = _S229 == i32(0);
    return run_0;
}

struct Section_0
{
     across_1 : f32,
     drop_0 : f32,
     slope_0 : f32,
};

fn section_at_0( cell_7 : Cell_0) -> Section_0
{
    var _S240 : f32 = cell_7.half_width_1 * 1.0154266357421875f;
    var section_0 : Section_0;
    var _S241 : f32 = clamp(cell_7.across_0, - cell_7.half_width_1, cell_7.half_width_1);
    section_0.across_1 = _S241;
    var _S242 : f32 = _S240 * _S240 - square_1(_S241);
    var _S243 : f32 = rsqrt_0(_S242);
    section_0.drop_0 = _S240 - _S242 * _S243;
    section_0.slope_0 = - _S241 * _S243;
    return section_0;
}

fn edge_drop_0( family_12 : u32,  thread_7 : u32,  step_1 : i32) -> f32
{
    return table_number_0(families_0[family_12].bend_table_0 + select(u32(turns_and_remainder_0(family_12, f32(i32(thread_7) + step_1)).y) * u32(4), u32(0), (families_0[family_12].is_alike_0) != u32(0)) + u32(3));
}

fn dive_0( other_1 : u32,  shown_1 : Shown_0,  run_1 : Run_0,  crossed_1 : Cell_0) -> vec3<f32>
{
    var _S244 : bool = (crossed_1.below_0) < (crossed_1.above_0);
    var _S245 : f32 = min(crossed_1.below_0, crossed_1.above_0);
    var _S246 : f32 = select(crossed_1.above_0 + crossed_1.across_0, crossed_1.below_0 - crossed_1.across_0, _S244) - crossed_1.half_width_1;
    var _S247 : bool = select(run_1.last_crossing_0, run_1.first_crossing_0, _S244);
    var _S248 : f32;
    if(shown_1.on_top_0)
    {
        _S248 = 0.0f;
    }
    else
    {
        _S248 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_1, i32(0));
    }
    var _S249 : f32;
    if((shown_1.on_top_0) != _S247)
    {
        _S249 = 0.0f;
    }
    else
    {
        _S249 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_1, select(i32(1), i32(-1), _S244));
    }
    var _S250 : f32 = 2.0f * _S246;
    var _S251 : f32 = 1.0f / max(_S250, 9.999999960041972e-13f);
    var _S252 : f32 = clamp((_S246 - _S245) * _S251, 0.0f, 1.0f);
    var _S253 : f32 = clamp((0.44999998807907104f - _S250 / crossed_1.half_width_1) * 4.0000004768371582f, 0.0f, 1.0f);
    return vec3<f32>(_S248 + (_S249 - _S248) * (_S252 * _S252 * (3.0f - 2.0f * _S252)), (_S248 - _S249) * (6.0f * _S252 * (1.0f - _S252) * _S251) * select(-1.0f, 1.0f, _S244), _S253 * _S253 * (3.0f - 2.0f * _S253));
}

struct PlaneHere_0
{
     plane_3 : Plane_0,
     number_1 : u32,
     level_1 : f32,
     edge_x_0 : f32,
     edge_y_0 : f32,
     bounds_0 : vec3<f32>,
};

struct Sample_0
{
     here_0 : PlaneHere_0,
     crossing_3 : Crossing_0,
     shown_2 : Shown_0,
     run_2 : Run_0,
     section_1 : Section_0,
     height_2 : f32,
     slope_across_0 : f32,
     slope_along_0 : f32,
     dive_1 : vec3<f32>,
     slope_x_0 : f32,
     slope_y_0 : f32,
};

fn sample_in_0( here_1 : PlaneHere_0,  x_10 : f32,  y_3 : f32,  back_6 : bool) -> Sample_0
{
    var sample_0 : Sample_0;
    sample_0.here_0 = here_1;
    var _S254 : Crossing_0 = crossing_at_0(here_1.plane_3, x_10, y_3, back_6);
    sample_0.crossing_3 = _S254;
    var _S255 : Shown_0 = shown_at_0(_S254, back_6);
    sample_0.shown_2 = _S255;
    var _S256 : u32 = select(here_1.plane_3.weft_1, here_1.plane_3.warp_1, _S255.is_warp_0);
    var _S257 : u32 = select(here_1.plane_3.warp_1, here_1.plane_3.weft_1, _S255.is_warp_0);
    var _S258 : Cell_0 = select_cell_0(_S255.is_warp_0, sample_0.crossing_3.warp_2, sample_0.crossing_3.weft_2);
    var _S259 : Cell_0 = select_cell_0(_S255.is_warp_0, sample_0.crossing_3.weft_2, sample_0.crossing_3.warp_2);
    var _S260 : Run_0 = unpack_0(_S256, _S257, _S258.thread_1, _S259, _S255.word_0);
    var _S261 : Section_0 = section_at_0(_S258);
    var _S262 : bool = ((_S255.on_top_0) & (((_S260.distance_0) < (_S261.drop_0 * _S260.bend_1.sine_0))));
    var _S263 : f32 = select(-1.0f, 1.0f, ((_S255.on_top_0) & ((!_S262))));
    var _S264 : f32 = select(_S260.reach_0, _S260.other_reach_0, _S262);
    var _S265 : f32 = select(max(_S264 - _S260.distance_0, 0.0f), _S264 + _S260.distance_0, _S262);
    var _S266 : f32 = _S264 / _S260.bend_1.sine_0 - _S263 * _S261.drop_0;
    var _S267 : f32 = _S265 * _S265;
    var _S268 : f32 = max(_S266 * _S266 - _S267, 9.99999968265522539e-21f);
    var _S269 : f32 = rsqrt_0(_S268);
    var _S270 : f32 = _S267 / (_S268 * _S269 + _S266);
    var _S271 : bool = _S265 > 0.0f;
    var _S272 : f32 = select(-1.0f, 1.0f, _S255.on_top_0) * select(-1.0f, 1.0f, _S260.near_start_0);
    var _S273 : f32 = _S261.slope_0 * select(1.0f, _S266 * _S269, _S271);
    sample_0.slope_across_0 = _S273;
    var _S274 : f32 = select(0.0f, _S272 * _S265 * _S269, _S271);
    sample_0.slope_along_0 = _S274;
    var _S275 : vec3<f32> = dive_0(_S257, _S255, _S260, _S259);
    sample_0.dive_1 = _S275;
    sample_0.height_2 = select(families_0[_S256].height_scale_0 * _S263, 0.0f, _S260.straight_0) * (_S264 * _S260.bend_1.half_tangent_0 - _S270) - families_0[_S256].height_scale_0 * _S261.drop_0 - _S275.x + here_1.level_1;
    var _S276 : f32 = families_0[_S256].height_scale_0 * _S273;
    var _S277 : f32 = families_0[_S256].height_scale_0 * _S274 - _S275.y;
    sample_0.slope_x_0 = select(_S277, _S276, _S255.is_warp_0);
    sample_0.slope_y_0 = select(_S276, _S277, _S255.is_warp_0);
    sample_0.run_2 = _S260;
    sample_0.section_1 = _S261;
    return sample_0;
}

struct StepControl_0
{
     step_2 : f32,
     epsilon_0 : f32,
     per_x_0 : f32,
     per_y_0 : f32,
     right_1 : bool,
     up_1 : bool,
};

fn step_control_0( direction_2 : vec2<f32>,  step_3 : f32) -> StepControl_0
{
    var control_0 : StepControl_0;
    control_0.step_2 = step_3;
    control_0.epsilon_0 = 0.00499999988824129f * step_3;
    var _S278 : f32 = direction_2.x;
    control_0.per_x_0 = 1.0f / max(abs(_S278), 9.99999971718068537e-10f);
    var _S279 : f32 = direction_2.y;
    control_0.per_y_0 = 1.0f / max(abs(_S279), 9.99999971718068537e-10f);
    control_0.right_1 = _S278 > 0.0f;
    control_0.up_1 = _S279 > 0.0f;
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

fn outline_distance_0( cell_8 : Cell_0,  shown_3 : Shown_0,  run_3 : Run_0,  lengthwise_0 : bool,  forwards_1 : bool) -> f32
{
    var _S280 : f32 = select(- cell_8.across_0, cell_8.across_0, forwards_1);
    var _S281 : f32 = select(cell_8.below_0, cell_8.above_0, forwards_1);
    var _S282 : f32 = - cell_8.half_width_1;
    var _S283 : bool = _S280 < _S282;
    var _S284 : bool = _S280 >= (cell_8.half_width_1);
    var _S285 : bool = (((lengthwise_0 & ((!select(run_3.first_crossing_0, run_3.last_crossing_0, forwards_1))))) & ((!shown_3.hole_0)));
    var _S286 : f32 = select(cell_8.half_width_1, _S282, _S283) - _S280;
    var _S287 : f32 = select(_S281, 2.0f * _S281 + _S280 - cell_8.half_width_1, ((shown_3.hole_0) | (((_S285 & ((!shown_3.on_top_0)))))));
    if((((_S285 & ((shown_3.on_top_0)))) & ((!((select(run_3.last_crossing_0, run_3.first_crossing_0, forwards_1) & (_S283)))))))
    {
        return select(run_3.from_start_0, run_3.to_end_0, forwards_1);
    }
    return select(_S286, _S287, _S284);
}

struct Probe_0
{
     height_3 : f32,
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

fn way_back_to_dip_0( previous_1 : PreviousSample_0,  clearance_1 : f32,  rate_1 : f32,  step_4 : f32,  here_2 : Probe_0) -> f32
{
    var _S288 : f32 = previous_1.rate_0 * step_4;
    var _S289 : f32 = rate_1 * step_4;
    if(((((((((!previous_1.known_0) | ((here_2.hole_1)))) | (((previous_1.yarn_0) != (here_2.yarn_1))))) | (((previous_1.rate_0) >= 0.0f)))) | ((rate_1 <= 0.0f))))
    {
        return -1.0f;
    }
    if((((3.0f * previous_1.clearance_0 + _S288) >= 0.0f) & (((3.0f * clearance_1 - _S289) >= 0.0f))))
    {
        return -1.0f;
    }
    var _S290 : f32 = clearance_1 - previous_1.clearance_0;
    var _S291 : f32 = 6.0f * _S290 - 4.0f * _S288 - 2.0f * _S289;
    var _S292 : f32 = -2.0f * _S288 / max(_S291 + sqrt(max(_S291 * _S291 - 4.0f * (3.0f * (_S288 + _S289 - 2.0f * _S290)) * _S288, 0.0f)), 9.99999968265522539e-21f);
    var _S293 : f32 = 1.0f - _S292;
    return select(-1.0f, _S293 * step_4, ((((_S292 > 0.01999999955296516f) & ((_S293 > 0.01999999955296516f)))) & ((((previous_1.clearance_0 * (2.0f * _S292 + 1.0f) + _S288 * _S292) * _S293 * _S293 + (clearance_1 * (2.0f * _S293 + 1.0f) - _S289 * _S293) * _S292 * _S292) < 0.0f))));
}

fn after_sample_0( clearance_2 : f32,  rate_2 : f32,  here_3 : Probe_0,  is_cell_exit_0 : bool) -> PreviousSample_0
{
    var previous_2 : PreviousSample_0;
    previous_2.clearance_0 = select(clearance_2, 1.0e+09f, here_3.hole_1);
    previous_2.rate_0 = rate_2;
    previous_2.yarn_0 = here_3.yarn_1;
    previous_2.known_0 = ((!here_3.hole_1) & ((!is_cell_exit_0)));
    return previous_2;
}

fn StepControl_to_cell_exit_0( this_4 : StepControl_0,  side_x_1 : f32,  side_y_1 : f32) -> f32
{
    return max(min(side_x_1 * this_4.per_x_0, side_y_1 * this_4.per_y_0), 0.0f) + this_4.epsilon_0;
}

fn StepControl_to_next_sample_0( this_5 : StepControl_0,  here_4 : Probe_0,  clearance_3 : f32,  rate_3 : f32) -> f32
{
    var _S294 : f32 = min(here_4.edge_x_1 * this_5.per_x_0, here_4.edge_y_1 * this_5.per_y_0);
    return min(this_5.step_2, select(max(_S294, 0.0f) + this_5.epsilon_0, _S294 - this_5.epsilon_0, ((((!here_4.hole_1) & (((rate_3 * _S294 + clearance_3) < 0.0f)))) & ((_S294 > (2.0f * this_5.epsilon_0))))));
}

struct ViewRay_0
{
     origin_0 : vec2<f32>,
     slope_1 : vec2<f32>,
};

fn ViewRay_at_0( this_6 : ViewRay_0,  height_4 : f32) -> vec2<f32>
{
    return this_6.origin_0 + this_6.slope_1 * vec2<f32>(height_4);
}

fn ViewRay_rate_0( this_7 : ViewRay_0,  here_5 : Probe_0) -> f32
{
    return here_5.slope_x_1 * this_7.slope_1.x + here_5.slope_y_1 * this_7.slope_1.y - 1.0f;
}

fn cubic_root_0( start_1 : f32,  end_0 : f32,  start_rate_0 : f32,  end_rate_0 : f32) -> f32
{
    var _S295 : f32 = end_0 - start_1;
    var _S296 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S295;
    var _S297 : f32 = 3.0f * _S295 - 2.0f * start_rate_0 - end_rate_0;
    var share_1 : f32 = start_1 / max(- _S295, 9.99999968265522539e-21f);
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
        var _S298 : f32 = clamp(share_1 - (((_S296 * share_1 + _S297) * share_1 + start_rate_0) * share_1 + start_1) / min((3.0f * _S296 * share_1 + 2.0f * _S297) * share_1 + start_rate_0, 0.10000000149011612f * _S295 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S299 : i32 = i_0 + i32(1);
        share_1 = _S298;
        i_0 = _S299;
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
    var _S300 : vec2<f32> = this_8.first_21;
    var _S301 : vec2<f32> = this_8.second_0;
    return (max(dot(_S300, _S300), dot(_S301, _S301))) > 0.0f;
}

fn AnisotropicTaps_place_0( this_9 : AnisotropicTaps_0,  number_2 : u32) -> vec2<f32>
{
    return this_9.centre_1 + vec2<f32>(select(-1.0f, 1.0f, number_2 >= u32(2))) * this_9.first_21 + vec2<f32>(select(-1.0f, 1.0f, ((number_2 & (u32(1)))) != u32(0))) * this_9.second_0;
}

fn bump_0( distance_1 : f32) -> f32
{
    var _S302 : f32 = max(1.0f - distance_1 * distance_1, 0.0f);
    return _S302 * _S302;
}

struct Yarns_0
{
     warp_3 : vec4<f32>,
     weft_3 : vec4<f32>,
     shares_0 : vec3<f32>,
};

fn Yarns_x24init_0( warp_4 : vec4<f32>,  weft_4 : vec4<f32>,  shares_1 : vec3<f32>) -> Yarns_0
{
    var _S303 : Yarns_0;
    _S303.warp_3 = warp_4;
    _S303.weft_3 = weft_4;
    _S303.shares_0 = shares_1;
    return _S303;
}

fn irregular_over_0( family_13 : u32,  key_4 : u32,  place_1 : f32,  width_2 : f32,  along_1 : f32,  length_0 : f32) -> vec4<f32>
{
    var _S304 : f32 = max(width_2, 0.0625f);
    var _S305 : f32 = min(_S304, 64.0f);
    var _S306 : f32 = max(length_0 / 2.0f, 1.0f);
    var _S307 : f32 = along_1 / 2.0f - 0.5f * _S306;
    var _S308 : f32 = 0.5f * _S305;
    var _S309 : vec2<f32> = floor(vec2<f32>(place_1 - _S308, place_1 + _S308) / vec2<f32>(64.0f));
    var _S310 : vec4<f32> = vec4<f32>(0.0f);
    var number_3 : u32 = u32(0);
    var sums_8 : vec4<f32> = _S310;
    for(;;)
    {
        if(number_3 < u32(6))
        {
        }
        else
        {
            break;
        }
        var _S311 : bool = number_3 >= u32(3);
        var _S312 : u32 = select(number_3, number_3 - u32(3), _S311);
        var _S313 : f32 = select(-1.0f, 1.0f, _S311);
        var _S314 : f32 = _S309.y;
        var _S315 : f32 = _S309.x;
        var _S316 : f32 = select(_S315, _S314, _S311);
        var _S317 : f32 = place_1 + _S313 * 0.5f * _S305 - 64.0f * _S316;
        var _S318 : f32 = clamp(floor(_S317), 0.0f, 63.0f);
        var _S319 : f32 = _S317 - _S318;
        var _S320 : f32 = select(select(64.0f, 0.0f, _S311), _S318 + f32(_S312), _S312 < u32(2));
        var _S321 : f32 = _S313 * select(select(select(0.0f, -1.0f, _S315 != _S314), _S319, _S312 == u32(1)), 1.0f - _S319, _S312 == u32(0));
        if(_S321 == 0.0f)
        {
            number_3 = number_3 + u32(1);
            continue;
        }
        var _S322 : u32 = hash_bits_0(key_4, u32(i32(_S316)));
        sums_8 = sums_8 + vec4<f32>(_S321) * irregular_integral_0(family_13, ((_S322 & (u32(127)))) + u32(_S320), _S307 + f32((_S322 >> (u32(22)))), _S306);
        number_3 = number_3 + u32(1);
    }
    return sums_8 * irregular_units_0(family_13) * vec4<f32>((sqrt(_S305 / _S304) / (_S305 * _S306)));
}

fn shown_of_covers_0( covers_0 : vec2<f32>,  warp_on_top_1 : f32) -> vec3<f32>
{
    var _S323 : f32 = covers_0.x;
    var _S324 : f32 = covers_0.y;
    return vec3<f32>(_S323 * (1.0f - _S324 * (1.0f - warp_on_top_1)), _S324 * (1.0f - _S323 * warp_on_top_1), (1.0f - _S323) * (1.0f - _S324));
}

fn correction_weight_of_0( coded_size_0 : f32) -> f32
{
    return clamp((coded_size_0 - 0.4869367778301239f) * 6.16096401214599609f, 0.0f, 1.0f);
}

struct NearestLayer_0
{
     number_4 : u32,
     weight_0 : f32,
};

fn NearestLayer_x24init_0( number_5 : u32,  weight_1 : f32) -> NearestLayer_0
{
    var _S325 : NearestLayer_0;
    _S325.number_4 = number_5;
    _S325.weight_0 = weight_1;
    return _S325;
}

struct Albedos_0
{
     diffuse_reflect_0 : vec3<f32>,
     diffuse_transmit_0 : vec3<f32>,
     specular_reflect_0 : vec3<f32>,
     specular_transmit_0 : vec3<f32>,
};

fn Albedos_x24init_0( diffuse_reflect_1 : vec3<f32>,  diffuse_transmit_1 : vec3<f32>,  specular_reflect_1 : vec3<f32>,  specular_transmit_1 : vec3<f32>) -> Albedos_0
{
    var _S326 : Albedos_0;
    _S326.diffuse_reflect_0 = diffuse_reflect_1;
    _S326.diffuse_transmit_0 = diffuse_transmit_1;
    _S326.specular_reflect_0 = specular_reflect_1;
    _S326.specular_transmit_0 = specular_transmit_1;
    return _S326;
}

struct FamilyAlbedos_0
{
     warp_5 : Albedos_0,
     weft_5 : Albedos_0,
};

fn FamilyAlbedos_x24init_0( warp_6 : Albedos_0,  weft_6 : Albedos_0) -> FamilyAlbedos_0
{
    var _S327 : FamilyAlbedos_0;
    _S327.warp_5 = warp_6;
    _S327.weft_5 = weft_6;
    return _S327;
}

struct LayersBehind_0
{
     reflected_0 : vec3<f32>,
     transmitted_0 : vec3<f32>,
};

fn LayersBehind_x24init_0( reflected_1 : vec3<f32>,  transmitted_1 : vec3<f32>) -> LayersBehind_0
{
    var _S328 : LayersBehind_0;
    _S328.reflected_0 = reflected_1;
    _S328.transmitted_0 = transmitted_1;
    return _S328;
}

struct LayeredAlbedos_0
{
     albedos_0 : FamilyAlbedos_0,
     behind_0 : LayersBehind_0,
};

fn LayeredAlbedos_x24init_0( albedos_1 : FamilyAlbedos_0,  behind_1 : LayersBehind_0) -> LayeredAlbedos_0
{
    var _S329 : LayeredAlbedos_0;
    _S329.albedos_0 = albedos_1;
    _S329.behind_0 = behind_1;
    return _S329;
}

struct LayerSums_0
{
     albedos_2 : Albedos_0,
     weight_2 : f32,
     behind_2 : LayersBehind_0,
};

fn LayerSums_x24init_0( albedos_3 : Albedos_0,  weight_3 : f32,  behind_3 : LayersBehind_0) -> LayerSums_0
{
    var _S330 : LayerSums_0;
    _S330.albedos_2 = albedos_3;
    _S330.weight_2 = weight_3;
    _S330.behind_2 = behind_3;
    return _S330;
}

struct Bound_0
{
     thread_8 : u32,
     turns_2 : f32,
     cell_9 : f32,
     visible_0 : f32,
     width_3 : f32,
     gap_0 : f32,
};

fn bound_at_0( family_14 : u32,  position_5 : f32) -> Bound_0
{
    var _S331 : Cell_0 = locate_0(family_14, position_5);
    var _S332 : f32 = table_number_0(families_0[family_14].before_0 + u32(2) * _S331.thread_1 + u32(1));
    var bound_0 : Bound_0;
    bound_0.thread_8 = _S331.thread_1;
    bound_0.turns_2 = round((position_5 - families_0[family_14].start_0 - _S332 - _S331.below_0) * families_0[family_14].inverse_period_0);
    bound_0.cell_9 = _S331.below_0;
    var _S333 : f32 = 2.0f * _S331.half_width_1;
    bound_0.width_3 = _S333;
    bound_0.visible_0 = clamp((_S331.across_0 + _S331.half_width_1) / _S333, 0.0f, 1.0f);
    bound_0.gap_0 = min(_S331.below_0, _S331.below_0 - _S331.across_0 - _S331.half_width_1) + max(_S331.across_0 - _S331.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
     low_7 : Bound_0,
     high_7 : Bound_0,
};

fn stretch_of_0( family_15 : u32,  centre_2 : f32,  size_3 : f32) -> Stretch_0
{
    var _S334 : f32 = centre_2 - floor((centre_2 - families_0[family_15].start_0) * families_0[family_15].inverse_period_0) * families_0[family_15].period_0;
    var _S335 : f32 = 0.5f * max(size_3, families_0[family_15].smallest_box_0);
    var stretch_0 : Stretch_0;
    stretch_0.low_7 = bound_at_0(family_15, _S334 - _S335);
    stretch_0.high_7 = bound_at_0(family_15, _S334 + _S335);
    return stretch_0;
}

fn table_colour_0( index_4 : u32) -> vec3<f32>
{
    return vec3<f32>(table_number_0(index_4), table_number_0(index_4 + u32(1)), table_number_0(index_4 + u32(2)));
}

fn table_albedos_0( row_7 : u32) -> Albedos_0
{
    var albedos_4 : Albedos_0;
    albedos_4.diffuse_reflect_0 = table_colour_0(row_7);
    albedos_4.diffuse_transmit_0 = table_colour_0(row_7 + u32(3));
    albedos_4.specular_reflect_0 = table_colour_0(row_7 + u32(6));
    albedos_4.specular_transmit_0 = table_colour_0(row_7 + u32(9));
    return albedos_4;
}

fn Stretch_turns_0( this_10 : Stretch_0) -> f32
{
    return this_10.high_7.turns_2 - this_10.low_7.turns_2;
}

fn lengths_0( family_16 : u32,  stretch_1 : Stretch_0) -> vec3<f32>
{
    var _S336 : f32 = Stretch_turns_0(stretch_1);
    var _S337 : u32 = families_0[family_16].before_0 + u32(2) * stretch_1.low_7.thread_8;
    var _S338 : u32 = families_0[family_16].before_0 + u32(2) * stretch_1.high_7.thread_8;
    var _S339 : f32 = table_number_0(_S338) - table_number_0(_S337);
    var _S340 : f32 = table_number_0(_S338 + u32(1)) - table_number_0(_S337 + u32(1));
    return vec3<f32>(_S339 + stretch_1.high_7.visible_0 * stretch_1.high_7.width_3 - stretch_1.low_7.visible_0 * stretch_1.low_7.width_3 + _S336 * families_0[family_16].visible_total_0, _S340 - _S339 + stretch_1.high_7.gap_0 - stretch_1.low_7.gap_0 + _S336 * (families_0[family_16].period_0 - families_0[family_16].visible_total_0), _S340 + stretch_1.high_7.cell_9 - stretch_1.low_7.cell_9 + _S336 * families_0[family_16].period_0);
}

fn integrals_along_0( family_17 : u32,  stretch_2 : Stretch_0,  quantity_0 : u32) -> vec2<f32>
{
    var _S341 : u32 = u32(3) * families_0[family_17].quantities_0;
    var _S342 : u32 = families_0[family_17].colour_threads_0 + _S341 * stretch_2.low_7.thread_8 + quantity_0;
    var _S343 : u32 = families_0[family_17].colour_threads_0 + _S341 * stretch_2.high_7.thread_8 + quantity_0;
    var _S344 : u32 = families_0[family_17].colour_threads_0 + _S341 * u32(families_0[family_17].count_0) + quantity_0;
    var _S345 : f32 = table_number_0(_S342);
    var _S346 : f32 = table_number_0(_S343);
    var _S347 : f32 = Stretch_turns_0(stretch_2);
    var _S348 : u32 = u32(2) * families_0[family_17].quantities_0;
    return vec2<f32>(table_number_0(_S343 + families_0[family_17].quantities_0) - table_number_0(_S342 + families_0[family_17].quantities_0) + _S346 * stretch_2.high_7.visible_0 * stretch_2.high_7.width_3 - _S345 * stretch_2.low_7.visible_0 * stretch_2.low_7.width_3 + _S347 * table_number_0(_S344 + families_0[family_17].quantities_0), table_number_0(_S343 + _S348) - table_number_0(_S342 + _S348) + _S346 * stretch_2.high_7.cell_9 - _S345 * stretch_2.low_7.cell_9 + _S347 * table_number_0(_S344 + _S348));
}

fn Stretch_wraps_0( this_11 : Stretch_0) -> bool
{
    return (this_11.high_7.thread_8) < (this_11.low_7.thread_8);
}

fn Stretch_differences_0( this_12 : Stretch_0,  entries_0 : vec4<u32>,  whole_0 : u32) -> vec4<u32>
{
    var _S349 : u32 = entries_0.z;
    var _S350 : u32 = entries_0.x;
    return vec4<u32>(_S349 - _S350 + select(u32(0), whole_0, Stretch_wraps_0(this_12)), entries_0.w - _S349, entries_0.y - _S350, whole_0);
}

fn row_differences_0( across_2 : Stretch_0,  row_8 : u32,  count_2 : u32,  quantities_1 : u32) -> vec4<u32>
{
    var _S351 : u32 = row_8 + across_2.low_7.thread_8 * quantities_1;
    var _S352 : u32 = row_8 + across_2.high_7.thread_8 * quantities_1;
    return Stretch_differences_0(across_2, vec4<u32>(words_0[_S351], words_0[_S351 + quantities_1], words_0[_S352], words_0[_S352 + quantities_1]), words_0[row_8 + count_2 * quantities_1]);
}

fn Stretch_weights_0( this_13 : Stretch_0) -> vec4<f32>
{
    return vec4<f32>(1.0f, this_13.high_7.visible_0, - this_13.low_7.visible_0, Stretch_turns_0(this_13) - select(0.0f, 1.0f, Stretch_wraps_0(this_13)));
}

fn integral_on_top_0( family_18 : u32,  across_3 : Stretch_0,  along_2 : Stretch_0,  crossing_count_0 : u32,  quantity_1 : u32) -> f32
{
    var _S353 : u32 = u32(families_0[family_18].count_0);
    var _S354 : u32 = (_S353 + u32(1)) * families_0[family_18].quantities_0;
    var _S355 : u32 = families_0[family_18].colour_areas_0 + quantity_1;
    var _S356 : vec4<u32> = row_differences_0(across_3, _S355 + along_2.low_7.thread_8 * _S354, _S353, families_0[family_18].quantities_0);
    var _S357 : vec4<u32> = row_differences_0(across_3, _S355 + along_2.high_7.thread_8 * _S354, _S353, families_0[family_18].quantities_0);
    var _S358 : vec4<u32> = row_differences_0(across_3, _S355 + crossing_count_0 * _S354, _S353, families_0[family_18].quantities_0);
    var _S359 : vec4<f32> = Stretch_weights_0(across_3);
    return dot(vec4<f32>(dot(vec4<f32>(vec4<i32>(_S357 - _S356 + select_vector_3(Stretch_wraps_0(along_2), _S358, vec4<u32>(vec4<i32>(i32(0)))))), _S359), dot(vec4<f32>(vec4<i32>(row_differences_0(across_3, _S355 + (along_2.high_7.thread_8 + u32(1)) * _S354, _S353, families_0[family_18].quantities_0) - _S357)), _S359), dot(vec4<f32>(vec4<i32>(row_differences_0(across_3, _S355 + (along_2.low_7.thread_8 + u32(1)) * _S354, _S353, families_0[family_18].quantities_0) - _S356)), _S359), dot(vec4<f32>(vec4<i32>(_S358)), _S359)), Stretch_weights_0(along_2)) * families_0[family_18].area_unit_0;
}

fn with_added_albedos_0( albedos_5 : Albedos_0,  weight_4 : f32,  row_9 : u32) -> Albedos_0
{
    var _S360 : Albedos_0 = table_albedos_0(row_9);
    var sum_0 : Albedos_0;
    var _S361 : vec3<f32> = vec3<f32>(weight_4);
    sum_0.diffuse_reflect_0 = albedos_5.diffuse_reflect_0 + _S361 * _S360.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_5.diffuse_transmit_0 + _S361 * _S360.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_5.specular_reflect_0 + _S361 * _S360.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_5.specular_transmit_0 + _S361 * _S360.specular_transmit_0;
    return sum_0;
}

fn mean_albedos_0( family_19 : u32,  crossing_4 : u32,  own_1 : Stretch_0,  other_2 : Stretch_0,  back_7 : bool) -> Albedos_0
{
    var albedos_6 : Albedos_0 = table_albedos_0(families_0[family_19].colour_mean_0);
    if((families_0[family_19].quantities_0) == u32(1))
    {
        return albedos_6;
    }
    var _S362 : vec3<f32> = lengths_0(crossing_4, other_2);
    var is_exposed_0 : bool = false;
    var weight_5 : f32 = 0.0f;
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
        var _S363 : vec2<f32> = integrals_along_0(family_19, own_1, quantity_2);
        var _S364 : f32 = integral_on_top_0(family_19, own_1, other_2, u32(families_0[crossing_4].count_0), quantity_2);
        var _S365 : f32 = _S363.x;
        var _S366 : f32 = _S365 * _S362.x;
        var _S367 : f32 = select(_S364, _S366 - _S364, back_7);
        var _S368 : bool = quantity_2 == u32(0);
        if(_S368)
        {
            is_exposed_0 = _S367 > (16.0f * families_0[family_19].area_unit_0 * min(_S366 / families_0[family_19].crossing_area_0, 1.0f) + 0.00000999999974738f * _S366);
        }
        var _S369 : f32 = _S365 * _S362.y + select(0.0f, _S367, is_exposed_0) + 0.000244140625f * _S362.z * _S363.y;
        if(_S368)
        {
            weight_5 = 1.0f / max(_S369, 9.99999968265522539e-21f);
        }
        else
        {
            albedos_6 = with_added_albedos_0(albedos_6, _S369 * weight_5, families_0[family_19].colour_axes_0 + u32(12) * (quantity_2 - u32(1)));
        }
        quantity_2 = quantity_2 + u32(1);
    }
    albedos_6.diffuse_reflect_0 = saturate(albedos_6.diffuse_reflect_0);
    albedos_6.diffuse_transmit_0 = saturate(albedos_6.diffuse_transmit_0);
    albedos_6.specular_reflect_0 = saturate(albedos_6.specular_reflect_0);
    albedos_6.specular_transmit_0 = saturate(albedos_6.specular_transmit_0);
    return albedos_6;
}

fn albedos_in_0( plane_4 : Plane_0,  centre_3 : vec2<f32>,  size_4 : vec2<f32>,  back_8 : bool) -> FamilyAlbedos_0
{
    var _S370 : Stretch_0 = stretch_of_0(plane_4.warp_1, centre_3.x - plane_4.start_x_0, size_4.x);
    var _S371 : Stretch_0 = stretch_of_0(plane_4.weft_1, centre_3.y - plane_4.start_y_0, size_4.y);
    var albedos_7 : FamilyAlbedos_0;
    albedos_7.warp_5 = mean_albedos_0(plane_4.warp_1, plane_4.weft_1, _S370, _S371, back_8);
    albedos_7.weft_5 = mean_albedos_0(plane_4.weft_1, plane_4.warp_1, _S371, _S370, back_8);
    return albedos_7;
}

fn rate_terms_0( direction_3 : vec3<f32>,  terms_0 : ptr<function, array<f32, i32(6)>>)
{
    var _S372 : f32 = 1.0f - direction_3.z;
    var _S373 : f32 = _S372 * _S372;
    var _S374 : f32 = direction_3.x;
    var _S375 : f32 = _S374 * _S374;
    var _S376 : f32 = direction_3.y;
    var _S377 : f32 = _S376 * _S376;
    var _S378 : f32 = _S375 - _S377;
    (*terms_0)[i32(0)] = sqrt(_S375 + _S377);
    (*terms_0)[i32(1)] = _S373;
    (*terms_0)[i32(2)] = _S373 * _S373;
    (*terms_0)[i32(3)] = _S378;
    (*terms_0)[i32(4)] = _S374 * _S376;
    (*terms_0)[i32(5)] = _S378 * _S378;
    return;
}

fn rate_of_view_0( first_25 : u32,  terms_1 : array<f32, i32(6)>) -> f32
{
    var _S379 : f32 = table_number_0(first_25);
    var term_0 : u32 = u32(0);
    var total_0 : f32 = _S379;
    for(;;)
    {
        if(term_0 < u32(6))
        {
        }
        else
        {
            break;
        }
        var total_1 : f32 = total_0 + table_number_0(first_25 + u32(1) + term_0) * terms_1[term_0];
        term_0 = term_0 + u32(1);
        total_0 = total_1;
    }
    return total_0;
}

fn rate_of_light_0( first_26 : u32,  terms_2 : array<f32, i32(6)>,  both_0 : vec2<f32>) -> f32
{
    var _S380 : u32 = first_26 + u32(8);
    var _S381 : u32 = _S380 + u32(6);
    var _S382 : f32 = table_number_0(_S381) * both_0.x + table_number_0(_S381 + u32(1)) * both_0.y;
    var term_1 : u32 = u32(0);
    var total_2 : f32 = _S382;
    for(;;)
    {
        if(term_1 < u32(6))
        {
        }
        else
        {
            break;
        }
        var total_3 : f32 = total_2 + table_number_0(_S380 + term_1) * terms_2[term_1];
        term_1 = term_1 + u32(1);
        total_2 = total_3;
    }
    return total_2;
}

fn rate_of_0( logarithm_0 : f32) -> f32
{
    return exponential_0(clamp(logarithm_0, -30.0f, 3.0f));
}

fn with_layer_0( sums_9 : Albedos_0,  albedos_8 : Albedos_0,  lit_0 : f32,  passed_0 : f32) -> Albedos_0
{
    var result_0 : Albedos_0;
    var _S383 : vec3<f32> = vec3<f32>(lit_0);
    result_0.diffuse_reflect_0 = sums_9.diffuse_reflect_0 + _S383 * albedos_8.diffuse_reflect_0;
    var _S384 : vec3<f32> = vec3<f32>(passed_0);
    result_0.diffuse_transmit_0 = sums_9.diffuse_transmit_0 + _S384 * albedos_8.diffuse_transmit_0;
    result_0.specular_reflect_0 = sums_9.specular_reflect_0 + _S383 * albedos_8.specular_reflect_0;
    result_0.specular_transmit_0 = sums_9.specular_transmit_0 + _S384 * albedos_8.specular_transmit_0;
    return result_0;
}

fn with_seen_0( sums_10 : LayerSums_0,  albedos_9 : Albedos_0,  through_0 : f32,  first_27 : u32,  share_2 : f32,  alone_0 : f32,  light_1 : vec3<f32>,  view_1 : vec3<f32>) -> LayerSums_0
{
    var of_view_0 : array<f32, i32(6)>;
    rate_terms_0(view_1, &(of_view_0));
    var _S385 : f32 = light_1.x;
    var _S386 : f32 = light_1.y;
    var _S387 : f32 = light_1.z;
    var of_light_0 : array<f32, i32(6)>;
    rate_terms_0(vec3<f32>(_S385, _S386, abs(_S387)), &(of_light_0));
    var _S388 : vec2<f32> = vec2<f32>(_S385 * view_1.x, _S386 * view_1.y);
    var _S389 : bool = _S387 < 0.0f;
    var _S390 : u32 = first_27 + u32(16) * select(u32(0), u32(1), _S389);
    var _S391 : u32 = first_27 + u32(32);
    var _S392 : f32 = share_2 * alone_0;
    var _S393 : f32 = _S392 * rate_of_0(rate_of_view_0(_S390, of_view_0) + rate_of_light_0(_S390, of_light_0, _S388));
    var _S394 : f32 = _S392 * rate_of_0(rate_of_view_0(_S391, of_view_0) + rate_of_light_0(_S391, of_light_0, _S388));
    var _S395 : f32 = share_2 * rate_of_0(rate_of_view_0(first_27 + u32(48), of_view_0));
    var _S396 : u32 = first_27 + u32(64);
    var _S397 : vec3<f32> = vec3<f32>(table_number_0(_S396), table_number_0(_S396 + u32(1)), table_number_0(_S396 + u32(2)));
    var _S398 : vec3<f32> = vec3<f32>(table_number_0(_S396 + u32(3)), table_number_0(_S396 + u32(4)), table_number_0(_S396 + u32(5)));
    var result_1 : LayerSums_0;
    result_1.albedos_2 = with_layer_0(sums_10.albedos_2, albedos_9, _S393, _S393);
    result_1.weight_2 = sums_10.weight_2 + _S393 + select(0.0f, _S394, _S389);
    var _S399 : vec3<f32> = vec3<f32>(_S395);
    result_1.behind_2.reflected_0 = sums_10.behind_2.reflected_0 + _S399 * _S398;
    result_1.behind_2.transmitted_0 = sums_10.behind_2.transmitted_0 + _S399 * _S397 * (albedos_9.diffuse_transmit_0 + vec3<f32>(through_0) * albedos_9.specular_transmit_0);
    return result_1;
}

fn divided_0( sums_11 : Albedos_0,  weight_6 : f32) -> Albedos_0
{
    var result_2 : Albedos_0;
    var _S400 : vec3<f32> = vec3<f32>((1.0f / max(weight_6, 9.99999971718068537e-10f)));
    result_2.diffuse_reflect_0 = sums_11.diffuse_reflect_0 * _S400;
    result_2.diffuse_transmit_0 = sums_11.diffuse_transmit_0 * _S400;
    result_2.specular_reflect_0 = sums_11.specular_reflect_0 * _S400;
    result_2.specular_transmit_0 = sums_11.specular_transmit_0 * _S400;
    return result_2;
}

fn uniform_hash_0( thread_9 : u32,  cell_10 : u32,  stream_1 : u32) -> f32
{
    return (f32(((hash_bits_0(hash_key_0(thread_9, stream_1), cell_10)) >> (u32(9)))) + 0.5f) * 1.1920928955078125e-07f;
}

fn pixel_sequence_0( pixel_0 : vec2<u32>,  index_5 : u32,  stream_2 : u32) -> vec2<f32>
{
    var _S401 : u32 = pixel_0.x;
    var _S402 : u32 = pixel_0.y;
    return fract(vec2<f32>(uniform_hash_0(_S401, _S402, stream_2), uniform_hash_0(_S401, _S402, stream_2 + u32(1))) + vec2<f32>(f32((index_5 & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
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

fn choose_0( table_0 : u32,  count_3 : u32,  number_6 : f32) -> Choice_0
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
        var _S403 : u32 = (low_8 + high_8) / u32(2);
        if((scene_number_0(table_0 + _S403)) <= number_6)
        {
            low_8 = _S403;
        }
        else
        {
            high_8 = _S403;
        }
    }
    var _S404 : u32 = table_0 + low_8;
    var _S405 : f32 = scene_number_0(_S404);
    var _S406 : f32 = scene_number_0(_S404 + u32(1));
    var choice_0 : Choice_0;
    choice_0.index_7 = low_8;
    choice_0.remainder_0 = saturate((number_6 - _S405) / max(_S406 - _S405, 9.999999960041972e-13f));
    return choice_0;
}

fn mean_0( colour_0 : vec3<f32>) -> f32
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

fn sine_cosine_0( x_11 : f32) -> vec2<f32>
{
    var _S407 : f32 = floor(x_11 * 0.63661974668502808f + 0.5f);
    var _S408 : f32 = x_11 - _S407 * 1.5703125f - _S407 * 0.00048375129699707f - _S407 * 7.54979012640433211e-08f;
    var _S409 : f32 = _S408 * _S408;
    var _S410 : f32 = ((-0.00019515295571182f * _S409 + 0.00833216123282909f) * _S409 - 0.16666655242443085f) * _S409 * _S408 + _S408;
    var _S411 : f32 = ((0.00002443315679557f * _S409 - 0.00138873164542019f) * _S409 + 0.04166664555668831f) * _S409 * _S409 - 0.5f * _S409 + 1.0f;
    var _S412 : u32 = (u32(i32(_S407)) & (u32(3)));
    var _S413 : vec2<f32> = select_vector_1(((_S412 & (u32(1)))) != u32(0), vec2<f32>(_S411, _S410), vec2<f32>(_S410, _S411));
    var _S414 : f32 = _S413.x;
    var _S415 : f32 = _S413.y;
    return vec2<f32>(select(_S414, - _S414, ((_S412 & (u32(2)))) != u32(0)), select(_S415, - _S415, (((_S412 + u32(1)) & (u32(2)))) != u32(0)));
}

struct Light_0
{
     is_point_0 : u32,
     x_12 : f32,
     y_4 : f32,
     z_1 : f32,
     red_0 : f32,
     green_0 : f32,
     blue_0 : f32,
};

fn scene_light_0( first_28 : u32) -> Light_0
{
    var record_2 : Light_0;
    record_2.is_point_0 = scene_words_0[first_28];
    record_2.x_12 = (bitcast<f32>((scene_words_0[first_28 + u32(1)])));
    record_2.y_4 = (bitcast<f32>((scene_words_0[first_28 + u32(2)])));
    record_2.z_1 = (bitcast<f32>((scene_words_0[first_28 + u32(3)])));
    record_2.red_0 = (bitcast<f32>((scene_words_0[first_28 + u32(4)])));
    record_2.green_0 = (bitcast<f32>((scene_words_0[first_28 + u32(5)])));
    record_2.blue_0 = (bitcast<f32>((scene_words_0[first_28 + u32(6)])));
    return record_2;
}

fn unmapped_0( output_9 : f32,  scale_0 : f32) -> f32
{
    return (exponential_0(clamp(output_9, 0.0f, 8.0f)) - 1.0f) * scale_0;
}

fn mirrored_bundle_0( bundle_0 : u32) -> u32
{
    return select(bundle_0 / u32(3) * u32(3) + u32(3) - u32(1) - bundle_0 % u32(3), bundle_0, bundle_0 == u32(24));
}

fn light_visibility_of_0( diffuse_0 : f32,  light_2 : vec3<f32>,  view_2 : vec3<f32>,  blend_0 : f32) -> f32
{
    var _S416 : f32 = max(abs(light_2.z), 0.00100000004749745f);
    var _S417 : vec2<f32> = light_2.xy;
    return 3.14159274101257324f * max(diffuse_0, 0.0f) / mix(_S416, (0.59700000286102295f * _S416 + 0.16599999368190765f) * (0.21600000560283661f * (dot(_S417, view_2.xy) * rsqrt_0(max(dot(_S417, _S417), 9.99999997475242708e-07f))) + 1.0f), blend_0);
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
     weight_7 : f32,
     warp_7 : Blocked_0,
     weft_7 : Blocked_0,
};

fn no_close_up_0() -> CloseUp_0
{
    var nothing_1 : CloseUp_0;
    nothing_1.weight_7 = 0.0f;
    var _S418 : Blocked_0 = no_blocked_0();
    nothing_1.warp_7 = _S418;
    nothing_1.weft_7 = _S418;
    return nothing_1;
}

fn tinted_0( albedos_10 : Albedos_0,  tint_0 : vec3<f32>) -> Albedos_0
{
    var result_3 : Albedos_0 = albedos_10;
    result_3.diffuse_reflect_0 = result_3.diffuse_reflect_0 * tint_0;
    result_3.diffuse_transmit_0 = result_3.diffuse_transmit_0 * tint_0;
    return result_3;
}

fn fourth_power_0( value_1 : f32) -> f32
{
    var _S419 : f32 = value_1 * value_1;
    return _S419 * _S419;
}

struct FaceRadiance_0
{
     warp_8 : vec3<f32>,
     weft_8 : vec3<f32>,
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

fn face_radiance_0( sends_0 : FaceSends_0,  open_of_other_0 : f32,  passed_1 : vec3<f32>,  from_other_0 : vec3<f32>) -> FaceRadiance_0
{
    var _S420 : vec3<f32> = vec3<f32>((1.0f - open_of_other_0)) * passed_1;
    var found_0 : FaceRadiance_0;
    var _S421 : vec3<f32> = sends_0.sky_warp_0 + _S420 * sends_0.crossing_warp_0;
    found_0.warp_8 = _S421;
    var _S422 : vec3<f32> = sends_0.sky_weft_0 + _S420 * sends_0.crossing_weft_0;
    found_0.weft_8 = _S422;
    found_0.mean_1 = vec3<f32>(sends_0.blocks_warp_0) * _S421 + vec3<f32>(sends_0.blocks_weft_0) * _S422;
    found_0.leaked_0 = from_other_0;
    return found_0;
}

fn view_terms_0( view_3 : vec3<f32>,  terms_3 : ptr<function, array<f32, i32(6)>>)
{
    var _S423 : f32 = 1.0f - view_3.z;
    var _S424 : f32 = _S423 * _S423;
    (*terms_3)[i32(0)] = 1.0f;
    var _S425 : f32 = view_3.x;
    var _S426 : f32 = _S425 * _S425;
    var _S427 : f32 = view_3.y;
    var _S428 : f32 = _S427 * _S427;
    (*terms_3)[i32(1)] = sqrt(max(_S426 + _S428, 9.999999960041972e-13f));
    (*terms_3)[i32(2)] = _S424;
    (*terms_3)[i32(3)] = _S424 * _S424;
    (*terms_3)[i32(4)] = _S426 - _S428;
    (*terms_3)[i32(5)] = 0.0f;
    return;
}

fn view_terms_1( view_4 : vec3<f32>,  terms_4 : ptr<function, array<f32, i32(6)>>)
{
    var _S429 : f32 = 1.0f - view_4.z;
    var _S430 : f32 = _S429 * _S429;
    (*terms_4)[i32(0)] = 1.0f;
    var _S431 : f32 = view_4.x;
    var _S432 : f32 = _S431 * _S431;
    var _S433 : f32 = view_4.y;
    var _S434 : f32 = _S433 * _S433;
    (*terms_4)[i32(1)] = sqrt(max(_S432 + _S434, 9.999999960041972e-13f));
    (*terms_4)[i32(2)] = _S430;
    (*terms_4)[i32(3)] = _S430 * _S430;
    (*terms_4)[i32(4)] = _S432 - _S434;
    (*terms_4)[i32(5)] = 0.0f;
    return;
}

fn scaled_0( blocked_0 : Blocked_0,  share_3 : f32) -> Blocked_0
{
    var result_4 : Blocked_0;
    result_4.by_warp_0 = share_3 * blocked_0.by_warp_0;
    result_4.by_weft_0 = share_3 * blocked_0.by_weft_0;
    result_4.far_0 = share_3 * blocked_0.far_0;
    return result_4;
}

struct Bounced_0
{
     reflected_2 : vec3<f32>,
     transmitted_2 : vec3<f32>,
     is_covered_0 : bool,
};

struct Scattered_0
{
     back_9 : vec3<f32>,
     through_1 : vec3<f32>,
};

struct Interior_0
{
     warp_9 : vec3<f32>,
     weft_9 : vec3<f32>,
     leaked_1 : vec3<f32>,
     far_1 : vec3<f32>,
     far_leaked_0 : vec3<f32>,
};

fn bounced_by_0( blocked_1 : Blocked_0,  yarn_2 : Scattered_0,  interior_0 : Interior_0) -> Bounced_0
{
    var _S435 : vec3<f32> = vec3<f32>((blocked_1.by_warp_0 + blocked_1.by_weft_0)) * interior_0.leaked_1;
    var _S436 : vec3<f32> = vec3<f32>(blocked_1.far_0) * yarn_2.through_1;
    var bounced_0 : Bounced_0;
    bounced_0.reflected_2 = yarn_2.back_9 * (vec3<f32>(blocked_1.by_warp_0) * interior_0.warp_9 + vec3<f32>(blocked_1.by_weft_0) * interior_0.weft_9) + _S436 * interior_0.far_leaked_0;
    bounced_0.transmitted_2 = _S436 * interior_0.far_1 + yarn_2.back_9 * _S435;
    bounced_0.is_covered_0 = false;
    return bounced_0;
}

fn sum_of_0( first_29 : Bounced_0,  second_2 : Bounced_0) -> Bounced_0
{
    var sum_1 : Bounced_0;
    sum_1.reflected_2 = first_29.reflected_2 + second_2.reflected_2;
    sum_1.transmitted_2 = first_29.transmitted_2 + second_2.transmitted_2;
    sum_1.is_covered_0 = false;
    return sum_1;
}

fn bounced_value_0( bounced_1 : Bounced_0,  light_3 : vec3<f32>,  view_5 : vec3<f32>) -> vec3<f32>
{
    var _S437 : f32 = light_3.z;
    return select_vector_2((_S437 * view_5.z) < 0.0f, bounced_1.transmitted_2, bounced_1.reflected_2) * vec3<f32>((abs(_S437) * 0.31830987334251404f));
}

fn sheen_scale_0( x_13 : f32,  y_5 : f32) -> f32
{
    return (((((0.0f * x_13 + (((((-1.1402510404586792f * y_5 + 0.40672621130943298f) * y_5 + 1.65398800373077393f) * y_5 + -1.29730904102325439f) * y_5 + 0.30570998787879944f) * y_5 + -0.0220868494361639f)) * x_13 + (((((-0.21142719686031342f * y_5 + 1.05947399139404297f) * y_5 + -0.41116121411323547f) * y_5 + -0.93859231472015381f) * y_5 + 0.51606941223144531f) * y_5 + 0.05409301072359085f)) * x_13 + (((((1.22944498062133789f * y_5 + -0.45962560176849365f) * y_5 + -1.63861405849456787f) * y_5 + 1.33565104007720947f) * y_5 + -0.45725581049919128f) * y_5 + 0.08243165910243988f)) * x_13 + (((((0.39779931306838989f * y_5 + -1.18879103660583496f) * y_5 + 0.28251591324806213f) * y_5 + 1.168984055519104f) * y_5 + -0.76864629983901978f) * y_5 + 0.0091691892594099f)) * x_13 + (((((-0.26563560962677002f * y_5 + -0.19379159808158875f) * y_5 + 0.2677634060382843f) * y_5 + 0.00270519289188087f) * y_5 + 0.14349560439586639f) * y_5 + 0.10290180146694183f)) * x_13 + (((((-0.20701569318771362f * y_5 + 0.24526430666446686f) * y_5 + 0.19551840424537659f) * y_5 + 0.07586126774549484f) * y_5 + 0.38894739747047424f) * y_5 + 0.15043120086193085f);
}

fn sheen_shear_0( x_14 : f32,  y_6 : f32) -> f32
{
    return ((((0.0f * x_14 + (((((-0.10608240216970444f * y_6 + 1.99214303493499756f) * y_6 + -1.42255294322967529f) * y_6 + -1.09495604038238525f) * y_6 + 0.59180057048797607f) * y_6 + 0.06902855634689331f)) * x_14 + (((((-0.46220690011978149f * y_6 + -0.29113379120826721f) * y_6 + 1.39025199413299561f) * y_6 + 0.35589990019798279f) * y_6 + -1.17120099067687988f) * y_6 + 0.15940259397029877f)) * x_14 + (((((2.26068711280822754f * y_6 + -3.64728999137878418f) * y_6 + -0.72173482179641724f) * y_6 + 3.07659196853637695f) * y_6 + -0.6827620267868042f) * y_6 + -0.3039557933807373f)) * x_14 + (((((0.81201767921447754f * y_6 + 0.36014080047607422f) * y_6 + -1.72646903991699219f) * y_6 + -0.22630110383033752f) * y_6 + 0.89514690637588501f) * y_6 + -0.10397960245609283f)) * x_14 + (((((-0.37648698687553406f * y_6 + 1.10974001884460449f) * y_6 + 0.17824520170688629f) * y_6 + -1.04968702793121338f) * y_6 + 0.1461234986782074f) * y_6 + -0.00475129019469023f);
}

fn sheen_reflectance_0( x_15 : f32,  y_7 : f32) -> f32
{
    return ((((0.0f * x_15 + (((((12.95646953582763672f * y_7 + -21.38032913208007812f) * y_7 + -7.37853097915649414f) * y_7 + 34.55607986450195312f) * y_7 + -23.61347007751464844f) * y_7 + 5.00126314163208008f)) * x_15 + (((((10.91487026214599609f * y_7 + -6.08202791213989258f) * y_7 + -38.2036285400390625f) * y_7 + 53.3440399169921875f) * y_7 + -21.91996002197265625f) * y_7 + 2.01606011390686035f)) * x_15 + (((((-14.52206039428710938f * y_7 + 36.803619384765625f) * y_7 + -22.94047927856445312f) * y_7 + -10.07973003387451172f) * y_7 + 15.77003955841064453f) * y_7 + -4.92722177505493164f)) * x_15 + (((((-7.62505722045898438f * y_7 + 1.27310299873352051f) * y_7 + 31.19523048400878906f) * y_7 + -44.39989852905273438f) * y_7 + 26.44947052001953125f) * y_7 + -8.73507976531982422f)) * x_15 + (((((5.65633487701416016f * y_7 + -17.66820907592773438f) * y_7 + 24.65356063842773438f) * y_7 + -19.38941001892089844f) * y_7 + 11.06159019470214844f) * y_7 + -3.06573700904846191f);
}

fn sheen_lobe_0( cos_view_0 : f32,  roughness_1 : f32) -> vec3<f32>
{
    var _S438 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S439 : f32 = 2.0f * sqrt(_S438) - 1.0f;
    var _S440 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_1, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S439, _S440), 0.00999999977648258f, 1.0f), clamp((1.0f - _S438) * sheen_shear_0(_S439, _S440), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S439, _S440), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_4 : vec3<f32>,  view_6 : vec3<f32>,  scale_1 : f32,  shear_0 : f32) -> f32
{
    var _S441 : f32 = light_4.z;
    if(((_S441 <= 0.0f) | (((view_6.z) <= 0.0f))))
    {
        return 0.0f;
    }
    var _S442 : vec2<f32> = view_6.xy;
    var _S443 : f32 = dot(_S442, _S442);
    var _S444 : vec2<f32> = select_vector_1(_S443 > 9.99999968265522539e-21f, _S442 * vec2<f32>(rsqrt_0(max(_S443, 9.99999968265522539e-21f))), vec2<f32>(1.0f, 0.0f));
    var _S445 : f32 = scale_1 * dot(light_4.xy, _S444) + shear_0 * _S441;
    var _S446 : f32 = scale_1 * (light_4.y * _S444.x - light_4.x * _S444.y);
    var _S447 : f32 = _S445 * _S445 + _S446 * _S446 + _S441 * _S441;
    return 0.31830987334251404f * scale_1 * scale_1 * _S441 / max(_S447 * _S447, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_5 : vec3<f32>,  view_7 : vec3<f32>,  strength_0 : f32,  roughness_2 : f32) -> vec2<f32>
{
    var _S448 : vec3<f32> = sheen_lobe_0(view_7.z, roughness_2);
    var _S449 : f32 = strength_0 * _S448.z;
    return vec2<f32>(_S449 * transformed_cosine_0(light_5, view_7, _S448.x, _S448.y), 1.0f - _S449);
}

fn accumulate_0( index_8 : u32,  light_6 : vec4<f32>)
{
    var _S450 : f32 = layers_0[index_8].share_0;
    radiance_0[index_8] = radiance_0[index_8] + vec4<f32>(layers_0[index_8].share_0) * light_6;
    layers_0[index_8].share_0 = _S450 * (1.0f - light_6.w);
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

fn uneven_shift_0( _S451 : u32,  _S452 : u32,  _S453 : u32,  _S454 : vec2<f32>) -> f32
{
    var _S455 : f32 = families_0[_S453].period_0 / families_0[_S453].count_0;
    var _S456 : u32 = hash_key_0(_S452, ((fabrics_0[_S451].seed_0) ^ (u32(625341585))));
    var _S457 : vec2<f32> = vec2<f32>(_S454.x, _S454.y / 4.0f) / vec2<f32>(_S455);
    return 0.20000000298023224f * sqrt(families_0[_S453].slub_0) * _S455 * (uneven_octave_0(_S456, _S457) * 0.66666668653488159f + uneven_octave_0(_S456 + u32(1), vec2<f32>(2.0f) * _S457 + vec2<f32>(0.5f, 0.0f)) / 3.0f);
}

fn uneven_place_0( _S458 : u32,  _S459 : vec2<f32>) -> vec2<f32>
{
    return select_vector_1((fabrics_0[_S458].has_detail_0) == u32(0), _S459, _S459 + vec2<f32>(uneven_shift_0(_S458, u32(0), fabrics_0[_S458].warp_0, _S459), uneven_shift_0(_S458, u32(1), fabrics_0[_S458].weft_0, _S459.yx)));
}

fn face_point_0( _S460 : u32,  _S461 : u32,  _S462 : f32,  _S463 : f32) -> VisiblePoint_0
{
    var _S464 : u32 = u32(3) * _S461;
    var _S465 : Vertex_0 = vertex_at_0(_S464);
    var _S466 : Vertex_0 = vertex_at_0(_S464 + u32(1));
    var _S467 : Vertex_0 = vertex_at_0(_S464 + u32(2));
    var _S468 : vec3<f32> = position_of_0(_S465);
    var _S469 : vec3<f32> = position_of_0(_S466) - _S468;
    var _S470 : vec3<f32> = position_of_0(_S467) - _S468;
    var _S471 : f32 = _S466.u_0 - _S465.u_0;
    var _S472 : f32 = _S466.v_0 - _S465.v_0;
    var _S473 : vec2<f32> = vec2<f32>(_S471, _S472);
    var _S474 : f32 = _S467.u_0 - _S465.u_0;
    var _S475 : f32 = _S467.v_0 - _S465.v_0;
    var _S476 : vec2<f32> = vec2<f32>(_S474, _S475);
    var _S477 : vec3<f32> = vec3<f32>(select(1.0f, -1.0f, (_S471 * _S475 - _S472 * _S474) < 0.0f));
    var _S478 : vec3<f32> = _S477 * (vec3<f32>(_S475) * _S469 - vec3<f32>(_S472) * _S470);
    var _S479 : vec3<f32> = _S477 * (vec3<f32>(_S471) * _S470 - vec3<f32>(_S474) * _S469);
    var point_1 : VisiblePoint_0;
    var _S480 : vec3<f32> = vec3<f32>(_S462);
    var _S481 : vec3<f32> = vec3<f32>(_S463);
    var _S482 : vec3<f32> = normalize(vec3<f32>((1.0f - _S462 - _S463)) * normal_of_0(_S465) + _S480 * normal_of_0(_S466) + _S481 * normal_of_0(_S467));
    point_1.normal_0 = _S482;
    var _S483 : vec3<f32> = normalize(_S478 - _S482 * vec3<f32>(dot(_S482, _S478)));
    point_1.axis_x_0 = _S483;
    point_1.axis_y_0 = cross(_S482, _S483);
    var _S484 : vec3<f32> = normalize(cross(_S469, _S470));
    point_1.face_normal_0 = select_vector_2((dot(_S484, _S482)) < 0.0f, (vec3<f32>(0) - _S484), _S484);
    point_1.position_4 = _S468 + _S480 * _S469 + _S481 * _S470;
    point_1.view_0 = _S482;
    var _S485 : vec2<f32> = vec2<f32>(_S465.u_0, _S465.v_0) + vec2<f32>(_S462) * _S473 + vec2<f32>(_S463) * _S476;
    point_1.uv_1 = _S485;
    var _S486 : bool = (dot(cross(_S478, _S479), _S482)) < 0.0f;
    var _S487 : vec2<f32> = vec2<f32>(fabrics_0[_S460].uv_width_0, select(fabrics_0[_S460].uv_height_0, - fabrics_0[_S460].uv_height_0, _S486));
    point_1.draft_per_uv_0 = _S487;
    point_1.draft_0 = uneven_place_0(_S460, _S485 * _S487 + vec2<f32>(0.0f, select(0.0f, fabrics_0[_S460].uv_height_0, _S486)));
    var _S488 : vec2<f32> = vec2<f32>(0.0f);
    point_1.draft_dx_0 = _S488;
    point_1.draft_dy_0 = _S488;
    return point_1;
}

fn visible_point_0( _S489 : u32,  _S490 : u32,  _S491 : vec2<u32>) -> VisiblePoint_0
{
    var _S492 : u32 = u32(3) * _S490;
    var _S493 : Vertex_0 = vertex_at_0(_S492);
    var _S494 : Vertex_0 = vertex_at_0(_S492 + u32(1));
    var _S495 : Vertex_0 = vertex_at_0(_S492 + u32(2));
    var _S496 : vec3<f32> = position_of_0(_S493);
    var _S497 : vec3<f32> = position_of_0(_S494) - _S496;
    var _S498 : vec3<f32> = position_of_0(_S495) - _S496;
    var _S499 : vec3<f32> = cross(_S497, _S498);
    var _S500 : f32 = f32(frame_record_0.width_0);
    var _S501 : vec3<f32> = camera_right_0() * vec3<f32>((2.0f / _S500));
    var _S502 : f32 = f32(frame_record_0.height_0);
    var _S503 : vec3<f32> = camera_up_0() * vec3<f32>((-2.0f / _S502));
    var _S504 : vec3<f32> = camera_forward_0() + vec3<f32>((f32(_S491.x) + 0.5f - 0.5f * _S500)) * _S501 + vec3<f32>((f32(_S491.y) + 0.5f - 0.5f * _S502)) * _S503;
    var _S505 : f32 = dot(_S504, _S499);
    var _S506 : f32 = 1.0f / select(1.00000000317107685e-30f, _S505, (abs(_S505)) > 1.00000000317107685e-30f);
    var _S507 : vec3<f32> = _S496 - camera_origin_0();
    var _S508 : vec3<f32> = vec3<f32>((dot(_S507, _S499) * _S506));
    var _S509 : vec3<f32> = _S504 * _S508 - _S507;
    var _S510 : vec3<f32> = _S508 * (_S501 - _S504 * vec3<f32>((dot(_S501, _S499) * _S506)));
    var _S511 : vec3<f32> = _S508 * (_S503 - _S504 * vec3<f32>((dot(_S503, _S499) * _S506)));
    var _S512 : vec3<f32> = vec3<f32>((1.0f / max(square_0(_S499), 1.00000000317107685e-30f)));
    var _S513 : vec3<f32> = cross(_S498, _S499) * _S512;
    var _S514 : vec3<f32> = cross(_S499, _S497) * _S512;
    var _S515 : vec2<f32> = vec2<f32>(_S494.u_0 - _S493.u_0, _S494.v_0 - _S493.v_0);
    var _S516 : vec2<f32> = vec2<f32>(_S495.u_0 - _S493.u_0, _S495.v_0 - _S493.v_0);
    var point_2 : VisiblePoint_0 = face_point_0(_S489, _S490, dot(_S509, _S513), dot(_S509, _S514));
    point_2.position_4 = _S496 + _S509;
    point_2.view_0 = (vec3<f32>(0) - normalize(_S504));
    point_2.draft_dx_0 = (vec2<f32>(dot(_S510, _S513)) * _S515 + vec2<f32>(dot(_S510, _S514)) * _S516) * point_2.draft_per_uv_0;
    point_2.draft_dy_0 = (vec2<f32>(dot(_S511, _S513)) * _S515 + vec2<f32>(dot(_S511, _S514)) * _S516) * point_2.draft_per_uv_0;
    return point_2;
}

fn filtered_albedo_0( _S517 : u32,  _S518 : VisiblePoint_0) -> vec3<f32>
{
    var _S519 : u32 = fabrics_0[_S517].albedo_map_levels_0;
    if((fabrics_0[_S517].albedo_map_levels_0) == u32(0))
    {
        return vec3<f32>(1.0f);
    }
    var _S520 : vec2<f32> = vec2<f32>(fabrics_0[_S517].uv_width_0, fabrics_0[_S517].uv_height_0);
    var _S521 : vec2<f32> = _S518.draft_dx_0 / _S520;
    var _S522 : vec2<f32> = _S518.draft_dy_0 / _S520;
    var _S523 : u32 = _S519 - u32(1);
    var _S524 : u32 = (u32(1) << (_S523));
    var _S525 : f32 = clamp(0.5f * binary_logarithm_0(max(abs(_S521.x * _S522.y - _S521.y * _S522.x), 9.99999968265522539e-21f) * (square_1(f32(_S524)) / 3.0f)), 0.0f, f32(_S519) - 1.0f);
    var _S526 : u32 = min(u32(_S525), max(_S519, u32(2)) - u32(2));
    var _S527 : u32 = min(_S526 + u32(1), _S523);
    var _S528 : u32 = (u32(1) << ((u32(2) * _S519)));
    return mix(map_level_0(fabrics_0[_S517].albedo_map_0 + (_S528 - ((_S528 >> ((u32(2) * _S526))))) / u32(3), (_S524 >> (_S526)), _S518.uv_1), map_level_0(fabrics_0[_S517].albedo_map_0 + (_S528 - ((_S528 >> ((u32(2) * _S527))))) / u32(3), (_S524 >> (_S527)), _S518.uv_1), vec3<f32>(((exponential_0(1.38629436492919922f * (_S525 - f32(_S526))) - 1.0f) / 3.0f)));
}

fn is_layered_0( _S529 : u32) -> bool
{
    return (HAS_LAYERS_0 & (((fabrics_0[_S529].planes_0) != u32(0))));
}

fn irregular_key_0( _S530 : u32,  _S531 : u32) -> u32
{
    return hash_key_0(_S531, ((fabrics_0[_S530].seed_0) ^ (u32(1821285621))));
}

fn irregular_place_0( _S532 : u32,  _S533 : vec2<f32>,  _S534 : f32) -> vec2<f32>
{
    var _S535 : u32 = fabrics_0[_S532].warp_0;
    var _S536 : u32 = fabrics_0[_S532].weft_0;
    var _S537 : bool = (((((fabrics_0[_S532].is_irregular_0) != u32(0)) & ((!is_layered_0(_S532))))) & (((max(moved_share_0(fabrics_0[_S532].warp_0, _S534), moved_share_0(fabrics_0[_S532].weft_0, _S534))) > 0.0f)));
    var number_7 : u32 = u32(0);
    var moved_0 : vec2<f32> = _S533;
    for(;;)
    {
        if(number_7 < select(u32(0), u32(2), _S537))
        {
        }
        else
        {
            break;
        }
        var _S538 : bool = number_7 == u32(0);
        var _S539 : u32 = select(_S536, _S535, _S538);
        var _S540 : vec2<f32> = select_vector_1(_S538, _S533, _S533.yx);
        var _S541 : u32 = irregular_key_0(_S532, number_7);
        var _S542 : f32 = _S540.x;
        var _S543 : Cell_0 = locate_0(_S539, _S542);
        var _S544 : f32 = irregular_thread_0(_S539, _S542, _S543);
        var _S545 : f32 = select(1.0f, -1.0f, (_S543.across_0) < 0.0f);
        var _S546 : vec2<f32> = vec2<f32>(0.0f);
        var other_3 : vec2<f32> = _S546;
        var own_2 : vec2<f32> = _S546;
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
            var _S547 : vec2<f32> = irregular_at_0(_S539, _S541, _S544 + _S545 * f32(neighbour_0), _S540.y).xy;
            var _S548 : u32 = neighbour_0 + u32(1);
            own_2 = other_3;
            other_3 = _S547;
            neighbour_0 = _S548;
        }
        var _S549 : f32 = _S543.below_0 + _S543.above_0;
        var _S550 : f32 = min(_S543.half_width_1 / _S549, 0.5f);
        var _S551 : f32 = min(_S550 * (2.0f + own_2.y + other_3.y), 1.0f);
        var _S552 : vec2<f32> = sqrt(max(vec2<f32>(1.0f) + vec2<f32>(own_2.x, other_3.x), vec2<f32>(0.25f)));
        var _S553 : f32 = _S552.x;
        var _S554 : f32 = _S551 * _S553 / (_S553 + _S552.y);
        var _S555 : f32 = abs(_S543.across_0) / _S549;
        var _S556 : f32 = 1.0f - _S551;
        var _S557 : f32 = _S555 - _S554;
        var _S558 : f32 = moved_share_0(_S539, _S534) * _S545 * _S549 * (select(select((_S557 - _S556) / max(_S551 - _S554, 9.99999997475242708e-07f) * _S550 + (1.0f - _S550), _S557 / max(_S556, 9.99999997475242708e-07f) * (1.0f - 2.0f * _S550) + _S550, _S557 < _S556), _S555 * _S550 / _S554, _S557 < 0.0f) - _S555);
        var moved_1 : vec2<f32> = moved_0 + select_vector_1(_S538, vec2<f32>(_S558, 0.0f), vec2<f32>(0.0f, _S558));
        number_7 = number_7 + u32(1);
        moved_0 = moved_1;
    }
    return moved_0;
}

struct NeuralView_0
{
     sums_12 : array<f32, i32(64)>,
     even_hole_0 : f32,
     hole_2 : f32,
     yarns_0 : Yarns_0,
     correction_weight_0 : f32,
     view_8 : vec3<f32>,
     back_10 : bool,
};

fn anisotropic_taps_0( _S559 : u32,  _S560 : Footprint_0) -> AnisotropicTaps_0
{
    var _S561 : vec3<f32> = row_of_taps_0(_S560);
    var _S562 : vec2<f32> = _S560.dx_0;
    var _S563 : vec2<f32> = _S560.dy_0;
    var _S564 : f32 = dot(_S562, _S562) + dot(_S563, _S563);
    var _S565 : f32 = _S560.dx_0.x * _S560.dy_0.y - _S560.dx_0.y * _S560.dy_0.x;
    var _S566 : f32 = 0.5f * (_S564 + sqrt(max(_S564 * _S564 - 4.0f * _S565 * _S565, 0.0f)));
    var _S567 : bool = ((_S566 < (5.5f * (_S564 - _S566))) & ((_S564 > (8.0f * fabrics_0[_S559].neural_0.pitch_0 * fabrics_0[_S559].neural_0.pitch_0))));
    var _S568 : vec2<f32> = vec2<f32>(fabrics_0[_S559].neural_0.ends_per_mm_0, fabrics_0[_S559].neural_0.picks_per_mm_0);
    var taps_1 : AnisotropicTaps_0;
    taps_1.centre_1 = _S560.centre_0 * _S568;
    taps_1.side_2 = select(_S561.x, sqrt(0.125f * _S564), _S567) / fabrics_0[_S559].neural_0.pitch_0;
    var _S569 : vec2<f32> = vec2<f32>(0.25f);
    var _S570 : vec2<f32> = _S561.yz;
    taps_1.first_21 = select_vector_1(_S567, _S569 * _S560.dx_0, _S570) * _S568;
    taps_1.second_0 = select_vector_1(_S567, _S569 * _S560.dy_0, vec2<f32>(0.5f) * _S570) * _S568;
    return taps_1;
}

struct Hit_0
{
     x_16 : f32,
     y_8 : f32,
     hole_3 : bool,
     height_5 : f32,
};

fn whole_plane_0( _S571 : u32) -> Plane_0
{
    var plane_5 : Plane_0;
    plane_5.warp_1 = fabrics_0[_S571].warp_0;
    plane_5.weft_1 = fabrics_0[_S571].weft_0;
    plane_5.run_words_1 = fabrics_0[_S571].run_words_0;
    plane_5.ends_2 = fabrics_0[_S571].ends_1;
    plane_5.end_numbers_0 = u32(0);
    plane_5.pick_numbers_0 = u32(0);
    plane_5.max_heights_1 = fabrics_0[_S571].max_heights_0;
    plane_5.max_height_columns_1 = fabrics_0[_S571].max_height_columns_0;
    plane_5.height_low_1 = fabrics_0[_S571].height_low_0;
    plane_5.height_high_1 = fabrics_0[_S571].height_high_0;
    plane_5.front_level_0 = 0.0f;
    plane_5.back_level_0 = 0.0f;
    plane_5.start_x_0 = 0.0f;
    plane_5.start_y_0 = 0.0f;
    plane_5.fine_x_0 = 0.0f;
    plane_5.fine_y_0 = 0.0f;
    return plane_5;
}

fn plane_order_0( _S572 : u32,  _S573 : f32,  _S574 : f32,  _S575 : bool) -> u32
{
    var _S576 : u32 = select(u32(0), locate_varied_0(fabrics_0[_S572].plane_axes_0 + u32(1), _S574).thread_1 * fabrics_0[_S572].ends_1 + locate_varied_0(fabrics_0[_S572].plane_axes_0, _S573).thread_1, (fabrics_0[_S572].stacks_0) > u32(1));
    return fabrics_0[_S572].plane_orders_0 + u32(2) * fabrics_0[_S572].planes_0 * (u32(2) * ((((words_0[fabrics_0[_S572].regions_0 + _S576 / u32(4)] >> ((u32(8) * (_S576 % u32(4)))))) & (u32(255)))) + select(u32(0), u32(1), _S575));
}

fn first_bounds_0( _S577 : u32,  _S578 : u32,  _S579 : f32,  _S580 : f32,  _S581 : bool,  _S582 : bool,  _S583 : bool) -> vec3<f32>
{
    var _S584 : vec3<f32> = bounds_in_0(plane_at_0(fabrics_0[_S577].plane_records_0 + words_0[_S578] * u32(16)), _S579, _S580, _S581, _S582, _S583);
    var _S585 : Cell_0 = locate_varied_0(fabrics_0[_S577].plane_axes_0, _S579);
    var _S586 : Cell_0 = locate_varied_0(fabrics_0[_S577].plane_axes_0 + u32(1), _S580);
    var _S587 : bool = (fabrics_0[_S577].stacks_0) == u32(1);
    return vec3<f32>(_S584.x + table_number_0(_S578 + u32(1)), min(_S584.y, select(select(_S585.below_0, _S585.above_0, _S582), 1.0e+06f, _S587)), min(_S584.z, select(select(_S586.below_0, _S586.above_0, _S583), 1.0e+06f, _S587)));
}

fn plane_shown_0( _S588 : u32,  _S589 : f32,  _S590 : f32,  _S591 : bool,  _S592 : bool,  _S593 : bool) -> PlaneHere_0
{
    var here_6 : PlaneHere_0;
    here_6.plane_3 = whole_plane_0(_S588);
    here_6.number_1 = u32(0);
    here_6.level_1 = 0.0f;
    here_6.edge_x_0 = 1.0e+06f;
    here_6.edge_y_0 = 1.0e+06f;
    here_6.bounds_0 = vec3<f32>(0.0f);
    if(!is_layered_0(_S588))
    {
        return here_6;
    }
    var _S594 : u32 = plane_order_0(_S588, _S589, _S590, _S591);
    var _S595 : vec3<f32> = first_bounds_0(_S588, _S594, _S589, _S590, _S591, _S592, _S593);
    here_6.bounds_0 = _S595;
    var _S596 : bool = (fabrics_0[_S588].stacks_0) == u32(1);
    here_6.edge_x_0 = select(_S595.y, 1.0e+06f, _S596);
    here_6.edge_y_0 = select(_S595.z, 1.0e+06f, _S596);
    var is_hole_0 : bool = true;
    var rank_1 : u32 = u32(0);
    for(;;)
    {
        if(((rank_1 < (fabrics_0[_S588].planes_0)) & (is_hole_0)))
        {
        }
        else
        {
            break;
        }
        var _S597 : u32 = _S594 + u32(2) * rank_1;
        var _S598 : u32 = words_0[_S597];
        here_6.number_1 = _S598;
        here_6.level_1 = table_number_0(_S597 + u32(1));
        here_6.plane_3 = plane_at_0(fabrics_0[_S588].plane_records_0 + _S598 * u32(16));
        var _S599 : Cell_0 = locate_varied_0(here_6.plane_3.warp_1, _S589 - here_6.plane_3.start_x_0);
        var _S600 : Cell_0 = locate_varied_0(here_6.plane_3.weft_1, _S590 - here_6.plane_3.start_y_0);
        var is_hole_1 : bool = !((((abs(_S599.across_0)) < (_S599.half_width_1)) | (((abs(_S600.across_0)) < (_S600.half_width_1)))));
        here_6.edge_x_0 = min(here_6.edge_x_0, select(1.0e+06f, hole_edge_0(_S599, _S592), is_hole_1));
        here_6.edge_y_0 = min(here_6.edge_y_0, select(1.0e+06f, hole_edge_0(_S600, _S593), is_hole_1));
        var _S601 : u32 = rank_1 + u32(1);
        is_hole_0 = is_hole_1;
        rank_1 = _S601;
    }
    return here_6;
}

fn sample_at_0( _S602 : u32,  _S603 : f32,  _S604 : f32,  _S605 : bool) -> Sample_0
{
    return sample_in_0(plane_shown_0(_S602, _S603, _S604, _S605, true, true), _S603, _S604, _S605);
}

fn steps_per_length_0( _S606 : u32,  _S607 : SearchQuality_0,  _S608 : vec3<f32>) -> f32
{
    return max(max(abs(_S608.x) * fabrics_0[_S606].threads_per_x_0, abs(_S608.y) * fabrics_0[_S606].threads_per_y_0) * _S607.steps_per_thread_0, abs(_S608.z) * fabrics_0[_S606].per_relief_0 * _S607.steps_per_relief_0);
}

fn plane_count_0( _S609 : u32) -> u32
{
    return select(u32(1), fabrics_0[_S609].planes_0, is_layered_0(_S609));
}

fn probe_0( _S610 : u32,  _S611 : f32,  _S612 : f32,  _S613 : bool,  _S614 : bool,  _S615 : bool) -> Probe_0
{
    var _S616 : PlaneHere_0 = plane_shown_0(_S610, _S611, _S612, _S613, _S614, _S615);
    var _S617 : Sample_0 = sample_in_0(_S616, _S611, _S612, _S613);
    var probe_1 : Probe_0;
    probe_1.height_3 = _S617.height_2;
    probe_1.hole_1 = _S617.shown_2.hole_0;
    probe_1.slope_x_1 = _S617.slope_x_0;
    probe_1.slope_y_1 = _S617.slope_y_0;
    var _S618 : bool = !is_layered_0(_S610);
    probe_1.yarn_1 = select(_S617.crossing_3.weft_2.thread_1 * u32(2), _S617.crossing_3.warp_2.thread_1 * u32(2) + u32(1), _S617.shown_2.is_warp_0) * plane_count_0(_S610) + _S616.number_1;
    probe_1.cell_max_0 = select(_S616.bounds_0.x, cell_maximum_0(_S616.plane_3, _S617.crossing_3), _S618);
    probe_1.side_x_0 = select(_S616.bounds_0.y, select(_S617.crossing_3.warp_2.below_0, _S617.crossing_3.warp_2.above_0, _S614), _S618);
    probe_1.side_y_0 = select(_S616.bounds_0.z, select(_S617.crossing_3.weft_2.below_0, _S617.crossing_3.weft_2.above_0, _S615), _S618);
    probe_1.edge_x_1 = min(_S616.edge_x_0, outline_distance_0(_S617.crossing_3.warp_2, _S617.shown_2, _S617.run_2, !_S617.shown_2.is_warp_0, _S614));
    probe_1.edge_y_1 = min(_S616.edge_y_0, outline_distance_0(_S617.crossing_3.weft_2, _S617.shown_2, _S617.run_2, _S617.shown_2.is_warp_0, _S615));
    return probe_1;
}

fn is_free_0( _S619 : u32,  _S620 : SearchQuality_0,  _S621 : vec3<f32>,  _S622 : vec3<f32>,  _S623 : bool,  _S624 : f32) -> bool
{
    var _S625 : f32 = _S622.z;
    if(_S625 <= 0.0f)
    {
        return false;
    }
    var _S626 : f32 = 1.0f / max(_S620.shadow_share_0 * steps_per_length_0(_S619, _S620, _S622), 9.99999971718068537e-10f);
    var _S627 : StepControl_0 = step_control_0(_S622.xy, _S626);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_4 : u32 = u32(0);
    var distance_2 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        if(((count_4 < u32(1024)) & (((_S621.z + _S625 * distance_2) < _S624))))
        {
        }
        else
        {
            break;
        }
        var _S628 : vec3<f32> = _S621 + _S622 * vec3<f32>(distance_2);
        var _S629 : Probe_0 = probe_0(_S619, _S628.x, _S628.y, _S623, _S627.right_1, _S627.up_1);
        var _S630 : f32 = _S628.z;
        var _S631 : f32 = _S630 - _S629.height_3;
        var _S632 : f32 = _S625 - _S629.slope_x_1 * _S622.x - _S629.slope_y_1 * _S622.y;
        if(((!_S629.hole_1) & ((_S631 < 0.0f))))
        {
            return false;
        }
        var _S633 : f32 = way_back_to_dip_0(previous_3, _S631, _S632, last_step_0, _S629);
        if(_S633 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S633;
            distance_2 = distance_2 - _S633;
            last_step_0 = last_step_1;
            count_4 = count_4 + u32(1);
            continue;
        }
        var _S634 : bool = _S630 > (_S629.cell_max_0);
        var last_step_2 : f32 = select(StepControl_to_next_sample_0(_S627, _S629, _S631, _S632), max(StepControl_to_cell_exit_0(_S627, _S629.side_x_0, _S629.side_y_0), _S626), _S634);
        var distance_3 : f32 = distance_2 + last_step_2;
        previous_3 = after_sample_0(_S631, _S632, _S629, _S634);
        distance_2 = distance_3;
        last_step_0 = last_step_2;
        count_4 = count_4 + u32(1);
    }
    return true;
}

fn passes_through_0( _S635 : u32,  _S636 : SearchQuality_0,  _S637 : f32,  _S638 : f32,  _S639 : vec3<f32>,  _S640 : bool) -> bool
{
    if(!sample_at_0(_S635, _S637, _S638, _S640).shown_2.hole_0)
    {
        return false;
    }
    var _S641 : vec3<f32> = vec3<f32>(_S637, _S638, 0.0f);
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
        var _S642 : bool = is_free_0(_S635, _S636, _S641, select_vector_2(side_3 == u32(0), _S639, vec3<f32>(- _S639.x, - _S639.y, _S639.z)), _S640 != (side_3 == u32(1)), fabrics_0[_S635].height_high_0);
        var _S643 : u32 = side_3 + u32(1);
        passes_0 = _S642;
        side_3 = _S643;
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

fn plane_of_0( _S644 : u32,  _S645 : u32) -> Plane_0
{
    if(!is_layered_0(_S644))
    {
        return whole_plane_0(_S644);
    }
    return plane_at_0(fabrics_0[_S644].plane_records_0 + _S645 * u32(16));
}

fn max_height_along_0( _S646 : u32,  _S647 : f32,  _S648 : f32,  _S649 : f32,  _S650 : vec3<f32>,  _S651 : bool) -> f32
{
    var _S652 : f32 = _S650.x;
    var _S653 : f32 = _S650.y;
    var _S654 : u32 = select(u32(0), u32(1), _S652 > 0.0f) + select(u32(0), u32(2), _S653 > 0.0f);
    var _S655 : f32 = max(abs(_S652) * fabrics_0[_S646].threads_per_x_0, abs(_S653) * fabrics_0[_S646].threads_per_y_0) / _S650.z;
    var levels_4 : vec4<f32> = vec4<f32>(-1.00000001504746622e+30f);
    var number_8 : u32 = u32(0);
    for(;;)
    {
        if(number_8 < (plane_count_0(_S646)))
        {
        }
        else
        {
            break;
        }
        var _S656 : Plane_0 = plane_of_0(_S646, number_8);
        var _S657 : u32 = (words_0[_S656.max_heights_1 + u32(4) * (locate_0(_S656.weft_1, _S648 - _S656.start_y_0).thread_1 / u32(2) * _S656.max_height_columns_1 + locate_0(_S656.warp_1, _S647 - _S656.start_x_0).thread_1 / u32(2)) + _S654] >> (u32(select(i32(0), i32(4), _S651))));
        var _S658 : vec4<f32> = max(levels_4, vec4<f32>(f32((_S657 & (u32(15)))), f32((((_S657 >> (u32(8)))) & (u32(15)))), f32((((_S657 >> (u32(16)))) & (u32(15)))), f32((((_S657 >> (u32(24)))) & (u32(15))))) * vec4<f32>(0.06666667014360428f) * vec4<f32>(_S656.height_high_1) + vec4<f32>(select(_S656.front_level_0, _S656.back_level_0, _S651)));
        var _S659 : u32 = number_8 + u32(1);
        levels_4 = _S658;
        number_8 = _S659;
    }
    var max_height_0 : f32 = fabrics_0[_S646].height_high_0;
    var number_9 : i32 = i32(3);
    for(;;)
    {
        if(number_9 >= i32(0))
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S649) * _S655) <= (PYRAMID_RADII_0[number_9]))
        {
            max_height_0 = min(max_height_0, levels_4[number_9]);
        }
        number_9 = number_9 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S660 : u32,  _S661 : f32,  _S662 : f32,  _S663 : bool,  _S664 : bool,  _S665 : bool) -> vec3<f32>
{
    if(is_layered_0(_S660))
    {
        return first_bounds_0(_S660, plane_order_0(_S660, _S661, _S662, _S663), _S661, _S662, _S663, _S664, _S665);
    }
    return bounds_in_0(whole_plane_0(_S660), _S661, _S662, _S663, _S664, _S665);
}

fn first_sample_height_0( _S666 : u32,  _S667 : ViewRay_0,  _S668 : StepControl_0,  _S669 : bool) -> f32
{
    var _S670 : f32 = max_height_along_0(_S666, _S667.origin_0.x, _S667.origin_0.y, 0.0f, vec3<f32>(_S667.slope_1, 1.0f), _S669);
    var count_5 : u32 = u32(0);
    var height_7 : f32 = _S670;
    for(;;)
    {
        if(count_5 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S671 : vec2<f32> = ViewRay_at_0(_S667, height_7);
        var _S672 : vec3<f32> = cell_bounds_0(_S666, _S671.x, _S671.y, _S669, _S668.right_1, _S668.up_1);
        var _S673 : f32 = height_7 - _S672.x;
        var _S674 : f32 = StepControl_to_cell_exit_0(_S668, _S672.y, _S672.z);
        var height_8 : f32 = height_7 - clamp(_S673, 0.0f, _S674);
        if(_S673 <= _S674)
        {
            height_7 = height_8;
            break;
        }
        count_5 = count_5 + u32(1);
        height_7 = height_8;
    }
    return height_7;
}

fn search_down_0( _S675 : u32,  _S676 : ViewRay_0,  _S677 : StepControl_0,  _S678 : bool) -> ViewRayEnd_0
{
    var _S679 : f32 = fabrics_0[_S675].height_low_0 - (fabrics_0[_S675].height_high_0 - fabrics_0[_S675].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_6 = first_sample_height_0(_S675, _S676, _S677, _S678);
    end_1.last_step_3 = _S677.epsilon_0;
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
        var _S680 : vec2<f32> = ViewRay_at_0(_S676, end_1.height_6);
        var _S681 : Probe_0 = probe_0(_S675, _S680.x, _S680.y, _S678, _S677.right_1, _S677.up_1);
        var _S682 : f32 = end_1.height_6 - _S681.height_3;
        var _S683 : f32 = ViewRay_rate_0(_S676, _S681);
        end_1.depth_0 = - _S682;
        end_1.rate_4 = _S683;
        var _S684 : bool = !_S681.hole_1;
        end_1.smooth_0 = ((((end_1.previous_4.known_0) & (_S684))) & (((end_1.previous_4.yarn_0) == (_S681.yarn_1))));
        if((((_S684 & ((_S682 <= 0.0f)))) | (((end_1.height_6) <= _S679))))
        {
            break;
        }
        var _S685 : f32 = way_back_to_dip_0(end_1.previous_4, _S682, _S683, end_1.last_step_3, _S681);
        if(_S685 >= 0.0f)
        {
            end_1.height_6 = end_1.height_6 + _S685;
            end_1.last_step_3 = end_1.last_step_3 - _S685;
            count_6 = count_6 + u32(1);
            continue;
        }
        var _S686 : f32 = min(StepControl_to_cell_exit_0(_S677, _S681.side_x_0, _S681.side_y_0), end_1.height_6 - _S681.cell_max_0);
        var _S687 : f32 = StepControl_to_next_sample_0(_S677, _S681, _S682, _S683);
        end_1.previous_4 = after_sample_0(_S682, _S683, _S681, _S686 > _S687);
        var _S688 : f32 = max(_S686, _S687);
        end_1.last_step_3 = _S688;
        end_1.height_6 = end_1.height_6 - _S688;
        count_6 = count_6 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S689 : u32,  _S690 : ViewRay_0,  _S691 : StepControl_0,  _S692 : bool,  _S693 : ViewRayEnd_0,  _S694 : u32) -> f32
{
    var _S695 : f32 = fabrics_0[_S689].height_high_0 - fabrics_0[_S689].height_low_0;
    var above_2 : f32 = _S693.height_6 + _S693.last_step_3;
    var above_gap_1 : f32 = clamp(_S693.previous_4.clearance_0, 0.0f, _S695);
    var under_gap_1 : f32 = clamp(_S693.depth_0, 0.0f, _S695);
    var middle_0 : f32 = select(between_0(above_2, _S693.height_6, above_gap_1, under_gap_1), above_2 - cubic_root_0(above_gap_1, - under_gap_1, _S693.previous_4.rate_0 * _S693.last_step_3, _S693.rate_4 * _S693.last_step_3) * _S693.last_step_3, _S693.smooth_0);
    var side_4 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S693.height_6;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < _S694)
        {
        }
        else
        {
            break;
        }
        var _S696 : vec2<f32> = ViewRay_at_0(_S690, middle_0);
        var _S697 : Probe_0 = probe_0(_S689, _S696.x, _S696.y, _S692, _S691.right_1, _S691.up_1);
        var _S698 : f32 = clamp(middle_0 - select(_S697.height_3, -1.0e+09f, _S697.hole_1), - _S695, _S695);
        if(_S698 <= 0.0f)
        {
            var _S699 : f32 = select(above_gap_2, 0.5f * above_gap_2, side_4 > 0.0f);
            var _S700 : f32 = - _S698;
            under_1 = middle_0;
            above_gap_2 = _S699;
            under_gap_2 = _S700;
            side_4 = 1.0f;
        }
        else
        {
            var _S701 : f32 = select(under_gap_2, 0.5f * under_gap_2, side_4 < 0.0f);
            above_3 = middle_0;
            above_gap_2 = _S698;
            under_gap_2 = _S701;
            side_4 = -1.0f;
        }
        var _S702 : f32 = select(between_0(above_3, under_1, above_gap_2, under_gap_2), clamp(middle_0 + _S698 / min(ViewRay_rate_0(_S690, _S697), -9.99999997475242708e-07f), under_1, above_3), _S693.smooth_0);
        var _S703 : u32 = i_1 + u32(1);
        middle_0 = _S702;
        i_1 = _S703;
    }
    return select(under_1, middle_0, _S693.smooth_0);
}

fn first_hit_of_yarn_0( _S704 : u32,  _S705 : SearchQuality_0,  _S706 : f32,  _S707 : f32,  _S708 : vec3<f32>,  _S709 : bool) -> Hit_0
{
    var _S710 : f32 = max(_S708.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S706, _S707);
    var _S711 : vec2<f32> = _S708.xy / vec2<f32>(_S710);
    ray_0.slope_1 = _S711;
    var _S712 : StepControl_0 = step_control_0((vec2<f32>(0) - _S711), 1.0f / max(steps_per_length_0(_S704, _S705, _S708) / _S710, 9.99999971718068537e-10f));
    var _S713 : ViewRayEnd_0 = search_down_0(_S704, ray_0, _S712, _S709);
    var hit_0 : Hit_0;
    hit_0.hole_3 = false;
    var _S714 : f32 = refined_height_0(_S704, ray_0, _S712, _S709, _S713, _S705.refinements_0);
    hit_0.height_5 = _S714;
    var _S715 : vec2<f32> = ViewRay_at_0(ray_0, _S714);
    hit_0.x_16 = _S715.x;
    hit_0.y_8 = _S715.y;
    return hit_0;
}

fn first_hit_0( _S716 : u32,  _S717 : SearchQuality_0,  _S718 : f32,  _S719 : f32,  _S720 : vec3<f32>,  _S721 : bool) -> Hit_0
{
    if(!passes_through_0(_S716, _S717, _S718, _S719, _S720, _S721))
    {
        return first_hit_of_yarn_0(_S716, _S717, _S718, _S719, _S720, _S721);
    }
    var hit_1 : Hit_0;
    hit_1.x_16 = _S718;
    hit_1.y_8 = _S719;
    hit_1.height_5 = 0.0f;
    hit_1.hole_3 = true;
    return hit_1;
}

fn taps_at_yarns_0( _S722 : u32,  _S723 : Footprint_0,  _S724 : AnisotropicTaps_0,  _S725 : vec3<f32>,  _S726 : bool) -> AnisotropicTaps_0
{
    var _S727 : f32 = 1.0f - clamp(natural_logarithm_0(max(AnisotropicTaps_size_0(_S724), 9.99999997475242708e-07f) / 0.25f) * 0.48089835047721863f, 0.0f, 1.0f);
    if(_S727 <= 0.0f)
    {
        return _S724;
    }
    var _S728 : Hit_0 = first_hit_0(_S722, default_quality_0(), _S723.centre_0.x, _S723.centre_0.y, _S725, _S726);
    if(_S728.hole_3)
    {
        return _S724;
    }
    var moved_2 : AnisotropicTaps_0 = _S724;
    moved_2.centre_1 = moved_2.centre_1 + vec2<f32>(_S727) * vec2<f32>(fabrics_0[_S722].neural_0.ends_per_mm_0, fabrics_0[_S722].neural_0.picks_per_mm_0) * (vec2<f32>(_S728.x_16, _S728.y_8) - _S723.centre_0);
    return moved_2;
}

fn add_texel_0( _S729 : u32,  _S730 : u32,  _S731 : f32,  _S732 : ptr<function, array<f32, i32(88)>>)
{
    var _S733 : u32 = fabrics_0[_S729].neural_0.latents_0 + _S730 * u32(8);
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
        var _S734 : Eight_0 = eight_halves_0(packed_numbers_0[_S733 + part_0]);
        var _S735 : i32 = i32(u32(8) * part_0);
        (*_S732)[_S735] = (*_S732)[_S735] + _S731 * _S734.low_0[i32(0)];
        (*_S732)[_S735 + i32(4)] = (*_S732)[_S735 + i32(4)] + _S731 * _S734.high_0[i32(0)];
        var _S736 : i32 = _S735 + i32(1);
        (*_S732)[_S736] = (*_S732)[_S736] + _S731 * _S734.low_0[i32(1)];
        (*_S732)[_S736 + i32(4)] = (*_S732)[_S736 + i32(4)] + _S731 * _S734.high_0[i32(1)];
        var _S737 : i32 = _S735 + i32(2);
        (*_S732)[_S737] = (*_S732)[_S737] + _S731 * _S734.low_0[i32(2)];
        (*_S732)[_S737 + i32(4)] = (*_S732)[_S737 + i32(4)] + _S731 * _S734.high_0[i32(2)];
        var _S738 : i32 = _S735 + i32(3);
        (*_S732)[_S738] = (*_S732)[_S738] + _S731 * _S734.low_0[i32(3)];
        (*_S732)[_S738 + i32(4)] = (*_S732)[_S738 + i32(4)] + _S731 * _S734.high_0[i32(3)];
        part_0 = part_0 + u32(1);
    }
    return;
}

fn add_level_0( _S739 : u32,  _S740 : u32,  _S741 : bool,  _S742 : vec2<f32>,  _S743 : f32,  _S744 : ptr<function, array<f32, i32(88)>>)
{
    var _S745 : Neural_std430_0 = fabrics_0[_S739].neural_0;
    var _S746 : u32 = fabrics_0[_S739].neural_0.levels_1 + u32(4) * _S740;
    var _S747 : f32 = table_number_0(_S746);
    var _S748 : f32 = table_number_0(_S746 + u32(1));
    var _S749 : f32 = table_number_0(_S746 + u32(2));
    var _S750 : vec2<f32> = _S742 * vec2<f32>(table_number_0(_S746 + u32(3))) - vec2<f32>(select(0.5f, 1.0f, ((_S740 > u32(3)) & ((_S740 < (fabrics_0[_S739].neural_0.top_level_0))))));
    var _S751 : vec2<f32> = floor(_S750);
    var _S752 : vec2<f32> = _S750 - _S751;
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
        var _S753 : f32 = f32((corner_1 & (u32(1))));
        var _S754 : f32 = f32((corner_1 >> (u32(1))));
        var _S755 : vec2<f32> = mix(vec2<f32>(1.0f) - _S752, _S752, vec2<f32>(_S753, _S754));
        add_texel_0(_S739, u32(_S747 + wrapped_0(_S751.y + _S754, _S749) * _S748 + wrapped_0(_S751.x + _S753, _S748)) + select(u32(0), _S745.texels_0, _S741), _S743 * _S755.x * _S755.y, &((*_S744)));
        corner_1 = corner_1 + u32(1);
    }
    return;
}

fn code_footprint_0( _S756 : u32,  _S757 : AnisotropicTaps_0,  _S758 : vec3<f32>,  _S759 : bool,  _S760 : ptr<function, array<f32, i32(88)>>)
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
        (*_S760)[k_0] = 0.0f;
        k_0 = k_0 + i32(1);
    }
    var _S761 : vec2<f32> = vec2<f32>(fabrics_0[_S756].neural_0.ends_0, fabrics_0[_S756].neural_0.picks_0);
    var _S762 : f32 = f32(fabrics_0[_S756].neural_0.top_level_0);
    var _S763 : f32 = clamp(binary_logarithm_0(max(_S757.side_2, 9.99999997475242708e-07f)) + 3.0f, 0.0f, _S762);
    var _S764 : f32 = min(floor(_S763), _S762 - 1.0f);
    var _S765 : u32 = select(u32(1), u32(4), AnisotropicTaps_has_steps_0(_S757));
    var number_10 : u32 = u32(0);
    for(;;)
    {
        if(number_10 < (u32(2) * _S765))
        {
        }
        else
        {
            break;
        }
        var _S766 : vec2<f32> = AnisotropicTaps_place_0(_S757, (number_10 >> (u32(1))));
        var _S767 : bool = ((number_10 & (u32(1)))) != u32(0);
        var _S768 : f32 = _S763 - _S764;
        add_level_0(_S756, u32(_S764) + select(u32(0), u32(1), _S767), _S759, clamp(_S766 - _S761 * floor(_S766 / _S761), vec2<f32>(0.0f), _S761), select(1.0f - _S768, _S768, _S767) / f32(_S765), &((*_S760)));
        number_10 = number_10 + u32(1);
    }
    var number_11 : i32 = i32(0);
    for(;;)
    {
        if(number_11 < i32(3))
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
            var offset_1 : f32 = _S758[number_11] - (f32(bin_0) + 0.5f) / 8.0f;
            var offset_2 : f32;
            if(number_11 < i32(2))
            {
                offset_2 = offset_1 - round(offset_1);
            }
            else
            {
                offset_2 = offset_1;
            }
            (*_S760)[i32(64) + number_11 * i32(8) + bin_0] = bump_0(offset_2 * 3.20000004768371582f);
            bin_0 = bin_0 + i32(1);
        }
        number_11 = number_11 + i32(1);
    }
    return;
}

fn crown_fibres_0( _S769 : u32,  _S770 : bool,  _S771 : bool) -> vec3<f32>
{
    if(_S770)
    {
        return vec3<f32>(select(1.0f, -1.0f, _S771) * fabrics_0[_S769].neural_0.warp_x_0, fabrics_0[_S769].neural_0.warp_y_0, fabrics_0[_S769].neural_0.warp_roughness_0);
    }
    return vec3<f32>(fabrics_0[_S769].neural_0.weft_x_0, select(1.0f, -1.0f, _S771) * fabrics_0[_S769].neural_0.weft_y_0, fabrics_0[_S769].neural_0.weft_roughness_0);
}

fn yarns_over_0( _S772 : u32,  _S773 : Footprint_0,  _S774 : bool) -> Yarns_0
{
    var _S775 : vec2<f32> = _S773.dx_0;
    var _S776 : vec2<f32> = _S773.dy_0;
    var _S777 : vec2<f32> = sqrt(_S775 * _S775 + _S776 * _S776);
    var _S778 : f32 = Footprint_spread_side_0(_S773);
    var _S779 : vec4<f32> = vec4<f32>(0.0f);
    var yarns_1 : Yarns_0 = Yarns_x24init_0(_S779, _S779, vec3<f32>(0.0f));
    var _S780 : bool = (fabrics_0[_S772].is_irregular_0) != u32(0);
    var number_12 : u32 = u32(0);
    for(;;)
    {
        if(number_12 < select(u32(0), u32(2), _S780))
        {
        }
        else
        {
            break;
        }
        var _S781 : bool = number_12 == u32(0);
        var _S782 : u32 = select(fabrics_0[_S772].weft_0, fabrics_0[_S772].warp_0, _S781);
        var _S783 : vec2<f32> = select_vector_1(_S781, _S773.centre_0, _S773.centre_0.yx);
        var _S784 : vec2<f32> = select_vector_1(_S781, _S777, _S777.yx);
        var _S785 : f32 = _S783.x;
        var _S786 : Cell_0 = locate_0(_S782, _S785);
        var yarn_3 : vec4<f32> = irregular_over_0(_S782, irregular_key_0(_S772, number_12), irregular_thread_0(_S782, _S785, _S786) + _S786.below_0 / (_S786.below_0 + _S786.above_0), _S784.x * (families_0[_S782].count_0 / families_0[_S782].period_0), _S783.y, _S784.y);
        yarn_3[i32(1)] = yarn_3[i32(1)] * (1.0f - moved_share_0(_S782, _S778));
        yarns_1.warp_3 = yarns_1.weft_3;
        yarns_1.weft_3 = yarn_3;
        number_12 = number_12 + u32(1);
    }
    var _S787 : vec2<f32> = vec2<f32>(families_0[fabrics_0[_S772].warp_0].cover_0, families_0[fabrics_0[_S772].weft_0].cover_0);
    var _S788 : f32 = select(fabrics_0[_S772].warp_on_top_0, 1.0f - fabrics_0[_S772].warp_on_top_0, _S774);
    var _S789 : vec3<f32> = shown_of_covers_0(_S787, _S788);
    var _S790 : vec3<f32> = select_vector_2(_S780, shown_of_covers_0(saturate(_S787 + _S787 * vec2<f32>(yarns_1.warp_3.y, yarns_1.weft_3.y)), _S788) / max(_S789, vec3<f32>(0.00009999999747379f)), vec3<f32>(1.0f));
    yarns_1.shares_0 = _S790;
    yarns_1.shares_0[i32(2)] = select(1.0f, _S790.z, (_S789.z) > 0.00009999999747379f);
    return yarns_1;
}

fn neural_view_0( _S791 : u32,  _S792 : Footprint_0,  _S793 : vec3<f32>,  _S794 : ptr<function, NeuralView_0>)
{
    var _S795 : bool = (_S793.z) < 0.0f;
    var _S796 : vec3<f32> = to_face_frame_0(_S793, _S795);
    var _S797 : AnisotropicTaps_0 = taps_at_yarns_0(_S791, _S792, anisotropic_taps_0(_S791, _S792), _S796, _S795);
    var _S798 : vec3<f32> = footprint_coordinates_0(_S797);
    var weights_23 : HalfWeights_0;
    weights_23.first_2 = fabrics_0[_S791].neural_0.network_0;
    var inputs_23 : array<f32, i32(88)>;
    code_footprint_0(_S791, _S797, _S798, _S795, &(inputs_23));
    var hidden_1 : array<f32, i32(64)>;
    dense_7(weights_23, u32(0), false, &(inputs_23), &(hidden_1));
    var fused_0 : array<f32, i32(68)>;
    dense_part_8(weights_23, u32(712), false, &(hidden_1), &(fused_0));
    fused_0[i32(64)] = _S796.x;
    fused_0[i32(65)] = _S796.y;
    var _S799 : vec2<f32> = _S796.xy;
    fused_0[i32(66)] = dot(crown_fibres_0(_S791, true, _S795).xy, _S799);
    fused_0[i32(67)] = dot(crown_fibres_0(_S791, false, _S795).xy, _S799);
    var of_hole_0 : array<f32, i32(16)>;
    dense_6(weights_23, u32(1232), false, &(fused_0), &(of_hole_0));
    var hole_4 : array<f32, i32(1)>;
    dense_5(weights_23, u32(1380), false, &(of_hole_0), &(hole_4));
    var _S800 : array<f32, i32(64)> = (*_S794).sums_12;
    dense_4(weights_23, u32(1392), false, &(fused_0), &(_S800));
    (*_S794).sums_12 = _S800;
    var _S801 : f32 = clamp(hole_4[i32(0)], 0.0f, 1.0f);
    (*_S794).even_hole_0 = _S801;
    (*_S794).yarns_0 = yarns_over_0(_S791, _S792, _S795);
    (*_S794).hole_2 = min(_S801 * (*_S794).yarns_0.shares_0.z, 1.0f);
    (*_S794).correction_weight_0 = correction_weight_of_0(_S798.z);
    (*_S794).view_8 = _S796;
    (*_S794).back_10 = _S795;
    return;
}

fn stack_share_0( _S802 : u32,  _S803 : vec2<f32>,  _S804 : vec2<f32>,  _S805 : u32) -> f32
{
    if((fabrics_0[_S802].stacks_0) == u32(1))
    {
        return 1.0f;
    }
    var _S806 : u32 = fabrics_0[_S802].plane_axes_0 + u32(1);
    var _S807 : Stretch_0 = stretch_of_0(fabrics_0[_S802].plane_axes_0, _S803.x, _S804.x);
    var _S808 : Stretch_0 = stretch_of_0(_S806, _S803.y, _S804.y);
    return clamp(integral_on_top_0(fabrics_0[_S802].plane_axes_0, _S807, _S808, u32(families_0[_S806].count_0), _S805) / (lengths_0(fabrics_0[_S802].plane_axes_0, _S807).x * lengths_0(_S806, _S808).x), 0.0f, 1.0f);
}

fn layered_albedos_0( _S809 : u32,  _S810 : Footprint_0,  _S811 : NearestLayer_0,  _S812 : bool,  _S813 : vec3<f32>,  _S814 : vec3<f32>) -> LayeredAlbedos_0
{
    var _S815 : vec2<f32> = _S810.dx_0;
    var _S816 : vec2<f32> = _S810.dy_0;
    var _S817 : vec2<f32> = sqrt(_S815 * _S815 + _S816 * _S816);
    var _S818 : vec3<f32> = vec3<f32>(0.0f);
    var _S819 : Albedos_0 = Albedos_x24init_0(_S818, _S818, _S818, _S818);
    var _S820 : LayersBehind_0 = LayersBehind_x24init_0(_S818, _S818);
    var found_1 : LayeredAlbedos_0 = LayeredAlbedos_x24init_0(FamilyAlbedos_x24init_0(_S819, _S819), _S820);
    var _S821 : LayerSums_0 = LayerSums_x24init_0(_S819, 0.0f, _S820);
    var warp_10 : LayerSums_0 = _S821;
    var weft_10 : LayerSums_0 = _S821;
    var number_13 : u32 = u32(0);
    for(;;)
    {
        if(number_13 < (plane_count_0(_S809)))
        {
        }
        else
        {
            break;
        }
        var _S822 : FamilyAlbedos_0 = albedos_in_0(plane_of_0(_S809, number_13), _S810.centre_0, _S817, _S812);
        if(!is_layered_0(_S809))
        {
            found_1.albedos_0 = _S822;
            return found_1;
        }
        var _S823 : f32 = select(1.0f - _S811.weight_0, 1.0f, number_13 == (_S811.number_4));
        var stack_0 : u32 = u32(0);
        for(;;)
        {
            if(stack_0 < (fabrics_0[_S809].stacks_0))
            {
            }
            else
            {
                break;
            }
            var _S824 : f32 = stack_share_0(_S809, _S810.centre_0, _S817, stack_0);
            var _S825 : u32 = fabrics_0[_S809].plane_shares_0 + u32(144) * (u32(2) * (stack_0 * fabrics_0[_S809].planes_0 + number_13) + select(u32(0), u32(1), _S812));
            var _S826 : LayerSums_0 = with_seen_0(warp_10, _S822.warp_5, families_0[fabrics_0[_S809].warp_0].layer_through_0, _S825, _S824, _S823, _S813, _S814);
            var _S827 : LayerSums_0 = with_seen_0(weft_10, _S822.weft_5, families_0[fabrics_0[_S809].weft_0].layer_through_0, _S825 + u32(72), _S824, _S823, _S813, _S814);
            var _S828 : u32 = stack_0 + u32(1);
            warp_10 = _S826;
            weft_10 = _S827;
            stack_0 = _S828;
        }
        number_13 = number_13 + u32(1);
    }
    found_1.albedos_0.warp_5 = divided_0(warp_10.albedos_2, warp_10.weight_2);
    found_1.albedos_0.weft_5 = divided_0(weft_10.albedos_2, weft_10.weight_2);
    found_1.behind_0.reflected_0 = warp_10.behind_2.reflected_0 + weft_10.behind_2.reflected_0;
    found_1.behind_0.transmitted_0 = warp_10.behind_2.transmitted_0 + weft_10.behind_2.transmitted_0;
    return found_1;
}

fn albedos_over_0( _S829 : u32,  _S830 : Footprint_0,  _S831 : bool) -> FamilyAlbedos_0
{
    const _S832 : vec3<f32> = vec3<f32>(0.0f, 0.0f, 1.0f);
    return layered_albedos_0(_S829, _S830, NearestLayer_x24init_0(u32(0), 0.0f), _S831, _S832, _S832).albedos_0;
}

fn toned_0( _S833 : u32,  _S834 : u32,  _S835 : Albedos_0,  _S836 : vec4<f32>) -> Albedos_0
{
    var _S837 : vec3<f32> = _S835.diffuse_reflect_0 + _S835.diffuse_transmit_0;
    var _S838 : vec3<f32> = vec3<f32>(1.0f);
    var _S839 : vec3<f32> = _S838 - vec3<f32>(fabrics_0[_S833].layer_bound_0) * max(_S835.specular_reflect_0, _S835.specular_transmit_0);
    var _S840 : vec3<f32> = vec3<f32>(0.0f);
    var _S841 : vec3<f32> = max(_S838 - _S837, _S840) / (_S838 + _S837);
    var _S842 : vec3<f32> = vec3<f32>(9.99999997475242708e-07f);
    var _S843 : vec3<f32> = (_S839 / max(_S837, _S842) - _S838) / max(vec3<f32>(0.89999997615814209f) * _S841, _S842);
    var _S844 : vec3<f32> = _S838 - vec3<f32>((saturate(min(min(_S843.x, _S843.y), _S843.z)) * _S836.z)) * _S841;
    var _S845 : vec3<f32> = min(vec3<f32>(families_0[_S834].nep_red_0, families_0[_S834].nep_green_0, families_0[_S834].nep_blue_0), _S839);
    var found_2 : Albedos_0 = _S835;
    var _S846 : f32 = _S836.w;
    var _S847 : vec3<f32> = _S844 * _S835.diffuse_transmit_0 * vec3<f32>((1.0f - _S846));
    found_2.diffuse_transmit_0 = _S847;
    found_2.diffuse_reflect_0 = clamp(mix(_S844 * _S835.diffuse_reflect_0, _S845, vec3<f32>(_S846)), _S840, max(_S839 - _S847, _S840));
    return found_2;
}

fn with_tones_0( _S848 : u32,  _S849 : FamilyAlbedos_0,  _S850 : Yarns_0) -> FamilyAlbedos_0
{
    if((fabrics_0[_S848].is_irregular_0) == u32(0))
    {
        return _S849;
    }
    var result_5 : FamilyAlbedos_0;
    result_5.warp_5 = toned_0(_S848, fabrics_0[_S848].warp_0, _S849.warp_5, _S850.warp_3);
    result_5.weft_5 = toned_0(_S848, fabrics_0[_S848].weft_0, _S849.weft_5, _S850.weft_3);
    return result_5;
}

fn light_sample_count_0() -> u32
{
    return frame_record_0.lights_0 + frame_record_0.environment_samples_0;
}

fn visibility_at_0( _S851 : u32,  _S852 : vec2<u32>) -> f32
{
    if((frame_record_0.casts_shadows_0) == u32(0))
    {
        return 1.0f;
    }
    return visibilities_0[(_S851 * frame_record_0.height_0 + _S852.y) * frame_record_0.width_0 + _S852.x];
}

struct LightSample_0
{
     towards_0 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_4 : f32,
};

fn environment_texel_0( _S853 : u32,  _S854 : u32) -> vec3<f32>
{
    var _S855 : u32 = frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + frame_record_0.environment_rows_0 * (frame_record_0.environment_columns_0 + u32(1)) + u32(3) * (_S853 * frame_record_0.environment_columns_0 + _S854);
    return vec3<f32>(scene_number_0(_S855), scene_number_0(_S855 + u32(1)), scene_number_0(_S855 + u32(2)));
}

fn sample_environment_0( _S856 : vec2<f32>,  _S857 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S858 : u32 = frame_record_0.environment_rows_0;
    var _S859 : Choice_0 = choose_0(frame_record_0.environment_table_0, frame_record_0.environment_rows_0, _S856.y);
    var _S860 : u32 = frame_record_0.environment_columns_0;
    var _S861 : Choice_0 = choose_0(frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + _S859.index_7 * (frame_record_0.environment_columns_0 + u32(1)), frame_record_0.environment_columns_0, _S856.x);
    var _S862 : vec3<f32> = environment_texel_0(_S859.index_7, _S861.index_7);
    (*_S857) = _S862 * vec3<f32>((frame_record_0.environment_total_0 / max(mean_0(_S862), 9.99999968265522539e-21f)));
    var _S863 : f32 = 3.14159274101257324f / f32(_S858);
    var _S864 : f32 = mix(sine_cosine_0(f32(_S859.index_7) * _S863).y, sine_cosine_0(f32(_S859.index_7 + u32(1)) * _S863).y, _S859.remainder_0);
    var _S865 : f32 = sqrt(max(1.0f - _S864 * _S864, 0.0f));
    var _S866 : vec2<f32> = sine_cosine_0((f32(_S861.index_7) + _S861.remainder_0) * (6.28318548202514648f / f32(_S860)));
    var _S867 : f32 = _S865 * _S866.x;
    var _S868 : f32 = - _S865 * _S866.y;
    return vec3<f32>(frame_record_0.environment_cosine_0 * _S867 + frame_record_0.environment_sine_0 * _S868, _S864, frame_record_0.environment_cosine_0 * _S868 - frame_record_0.environment_sine_0 * _S867);
}

fn light_sample_0( _S869 : u32,  _S870 : vec2<u32>,  _S871 : vec3<f32>) -> LightSample_0
{
    var sample_1 : LightSample_0;
    sample_1.distance_4 = 1.00000001504746622e+30f;
    var _S872 : u32 = frame_record_0.lights_0;
    if(_S869 >= (frame_record_0.lights_0))
    {
        var weight_8 : vec3<f32>;
        var _S873 : vec3<f32> = sample_environment_0(pixel_sequence_0(_S870, frame_record_0.pass_number_0 * frame_record_0.environment_samples_0 + (_S869 - _S872), u32(3)), &(weight_8));
        sample_1.towards_0 = _S873;
        sample_1.irradiance_1 = weight_8 / vec3<f32>(f32(frame_record_0.environment_samples_0));
        return sample_1;
    }
    var _S874 : Light_0 = scene_light_0(frame_record_0.light_records_0 + u32(7) * _S869);
    sample_1.irradiance_1 = vec3<f32>(_S874.red_0, _S874.green_0, _S874.blue_0);
    sample_1.towards_0 = vec3<f32>(_S874.x_12, _S874.y_4, _S874.z_1);
    if((_S874.is_point_0) != u32(0))
    {
        var _S875 : vec3<f32> = sample_1.towards_0 - _S871;
        var _S876 : f32 = max(square_0(_S875), 9.999999960041972e-13f);
        sample_1.distance_4 = sqrt(_S876);
        sample_1.irradiance_1 = sample_1.irradiance_1 / vec3<f32>(_S876);
        sample_1.towards_0 = normalize(_S875);
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

fn code_light_0( _S877 : u32,  _S878 : vec3<f32>,  _S879 : vec3<f32>,  _S880 : bool,  _S881 : ptr<function, array<f32, i32(39)>>)
{
    (*_S881)[i32(0)] = _S878.x;
    (*_S881)[i32(1)] = _S878.y;
    (*_S881)[i32(2)] = _S878.z;
    var _S882 : vec3<f32> = _S878 + _S879;
    var _S883 : f32 = _S882.z;
    var _S884 : f32 = _S883 * _S883 + 0.00009999999747379f;
    var _S885 : vec2<f32> = _S882.xy;
    var _S886 : f32 = 1.0f / (dot(_S885, _S885) + _S884);
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
        var _S887 : vec3<f32> = crown_fibres_0(_S877, family_20 == i32(0), _S880);
        var _S888 : vec2<f32> = _S887.xy;
        (*_S881)[i32(3) + family_20] = dot(_S888, _S878.xy);
        var _S889 : f32 = dot(_S888, _S885);
        var _S890 : f32 = _S889 * _S889;
        var _S891 : f32 = (0.75f * _S889 / (0.5f * sqrt(_S890 + _S884) + abs(_S889)) + 0.5f) * 8.0f;
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
            (*_S881)[i32(5) + family_20 * i32(16) + bin_1] = bump_0(_S891 - (f32(bin_1) + 0.5f) / 2.0f);
            bin_1 = bin_1 + i32(1);
        }
        var _S892 : f32 = _S887.z;
        var _S893 : f32 = _S892 * _S892;
        var _S894 : f32 = _S890 * _S886 * (1.0f - _S893) + _S893;
        (*_S881)[i32(37) + family_20] = 0.25f * natural_logarithm_0(1.0f + 9.54929637908935547f * _S893 * _S892 / (_S894 * _S894));
        family_20 = family_20 + i32(1);
    }
    return;
}

fn mixed_bundles_0( _S895 : u32,  _S896 : u32,  _S897 : u32,  _S898 : vec3<f32>,  _S899 : vec3<f32>,  _S900 : bool,  _S901 : ptr<function, array<f32, i32(52)>>) -> f32
{
    var _S902 : vec3<f32> = _S898 + _S899;
    var _S903 : f32 = 1.0f / (square_0(_S902) + 0.00009999999747379f);
    var _S904 : f32 = _S902.x;
    var _S905 : f32 = select(_S904, - _S904, ((_S896 == u32(0)) & (_S900)));
    var _S906 : f32 = _S902.y;
    var _S907 : f32 = select(_S906, - _S906, ((_S896 == u32(1)) & (_S900)));
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
        var _S908 : u32 = _S896 * u32(25);
        var _S909 : u32 = fabrics_0[_S895].neural_0.bundles_0 + u32(4) * (_S908 + bundle_1);
        var _S910 : f32 = dot(vec3<f32>(table_number_0(_S909), table_number_0(_S909 + u32(1)), table_number_0(_S909 + u32(2))), vec3<f32>(_S905, _S907, _S902.z));
        var _S911 : f32 = _S910 * _S910 * _S903 + table_number_0(_S909 + u32(3));
        var sum_3 : f32 = sum_2 + max((*_S901)[_S897 + _S908 + select(bundle_1, mirrored_bundle_0(bundle_1), _S900)], (*_S901)[_S897 + _S908 + select(bundle_1, mirrored_bundle_0(bundle_1), _S900)] * 0.00999999977648258f) / (_S911 * _S911);
        bundle_1 = bundle_1 + u32(1);
        sum_2 = sum_3;
    }
    return 0.01999999955296516f * sum_2;
}

fn with_shares_0( _S912 : u32,  _S913 : Components_0,  _S914 : Yarns_0) -> Components_0
{
    var result_6 : Components_0;
    var _S915 : f32 = min(_S913.hole_5 * _S914.shares_0.z, 1.0f);
    result_6.hole_5 = _S915;
    var _S916 : f32 = _S914.shares_0.x;
    result_6.diffuse_warp_0 = _S913.diffuse_warp_0 * _S916;
    var _S917 : f32 = _S914.shares_0.y;
    result_6.diffuse_weft_0 = _S913.diffuse_weft_0 * _S917;
    result_6.specular_warp_0 = _S913.specular_warp_0 * _S916;
    result_6.specular_weft_0 = _S913.specular_weft_0 * _S917;
    result_6.light_visibility_1 = _S913.light_visibility_1 * select(1.0f, (1.0f - _S915) / max(1.0f - _S913.hole_5, 9.99999997475242708e-07f), (fabrics_0[_S912].is_irregular_0) != u32(0));
    return result_6;
}

fn neural_components_0( _S918 : u32,  _S919 : ptr<function, NeuralView_0>,  _S920 : vec3<f32>) -> Components_0
{
    var _S921 : bool = (*_S919).back_10;
    var _S922 : vec3<f32> = to_face_frame_0(_S920, (*_S919).back_10);
    var _S923 : vec3<f32> = (*_S919).view_8;
    var weights_24 : HalfWeights_0;
    var _S924 : Neural_std430_0 = fabrics_0[_S918].neural_0;
    weights_24.first_2 = fabrics_0[_S918].neural_0.network_0;
    var directions_0 : array<f32, i32(39)>;
    code_light_0(_S918, _S922, (*_S919).view_8, (*_S919).back_10, &(directions_0));
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
        skip_0[k_1] = (*_S919).sums_12[k_1];
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
    var _S925 : bool;
    if((_S924.is_corrected_0) != u32(0))
    {
        _S925 = (_S922.z) > 0.0f;
    }
    else
    {
        _S925 = false;
    }
    if(_S925)
    {
        _S925 = ((*_S919).correction_weight_0) > 0.0f;
    }
    else
    {
        _S925 = false;
    }
    if(_S925)
    {
        var fitted_0 : FloatWeights_0;
        fitted_0.first_0 = _S924.correction_0;
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
            outputs_17[k_1 + i32(2)] = outputs_17[k_1 + i32(2)] + (*_S919).correction_weight_0 * change_0[k_1];
            k_1 = k_1 + i32(1);
        }
    }
    var _S926 : f32 = select(0.00100000004749745f, 0.00999999977648258f, (_S922.z) > 0.0f);
    var result_7 : Components_0;
    var _S927 : f32 = unmapped_0(outputs_17[i32(0)], _S926);
    result_7.diffuse_warp_0 = _S927;
    var _S928 : f32 = unmapped_0(outputs_17[i32(1)], _S926);
    result_7.diffuse_weft_0 = _S928;
    var _S929 : f32 = 2979.9580078125f * _S926;
    var _S930 : f32 = mixed_bundles_0(_S918, u32(0), u32(2), _S922, _S923, _S921, &(outputs_17));
    result_7.specular_warp_0 = clamp(_S930, 0.0f, _S929);
    var _S931 : f32 = mixed_bundles_0(_S918, u32(1), u32(2), _S922, _S923, _S921, &(outputs_17));
    result_7.specular_weft_0 = clamp(_S931, 0.0f, _S929);
    result_7.hole_5 = (*_S919).even_hole_0;
    result_7.light_visibility_1 = min(light_visibility_of_0(_S927 + _S928, _S922, _S923, fabrics_0[_S918].diffuse_blend_0), 1.0f - (*_S919).even_hole_0);
    return with_shares_0(_S918, result_7, (*_S919).yarns_0);
}

fn diffuse_kept_0( _S932 : u32,  _S933 : vec3<f32>,  _S934 : vec3<f32>) -> f32
{
    return (1.0f - fabrics_0[_S932].grazing_loss_0 * fourth_power_0(max(1.0f - abs(_S933.z), 0.0f))) * (1.0f - fabrics_0[_S932].grazing_loss_0 * fourth_power_0(max(1.0f - abs(_S934.z), 0.0f)));
}

fn highlight_rise_0( _S935 : u32,  _S936 : vec3<f32>,  _S937 : vec3<f32>) -> f32
{
    var _S938 : f32 = 1.0f - sqrt(clamp(0.5f * dot(_S936, _S937) + 0.5f, 9.99999993922529029e-09f, 1.0f));
    return fabrics_0[_S935].grazing_gain_0 * fourth_power_0(_S938) * _S938;
}

fn towards_grazing_0( _S939 : u32,  _S940 : Albedos_0,  _S941 : vec3<f32>,  _S942 : vec3<f32>) -> Albedos_0
{
    var _S943 : f32 = diffuse_kept_0(_S939, _S941, _S942);
    var result_8 : Albedos_0 = _S940;
    var _S944 : vec3<f32> = vec3<f32>(_S943);
    result_8.diffuse_reflect_0 = result_8.diffuse_reflect_0 * _S944;
    result_8.diffuse_transmit_0 = result_8.diffuse_transmit_0 * _S944;
    result_8.specular_reflect_0 = result_8.specular_reflect_0 + vec3<f32>(highlight_rise_0(_S939, _S941, _S942));
    return result_8;
}

fn openness_number_0( _S945 : u32,  _S946 : u32) -> f32
{
    return table_number_0(fabrics_0[_S945].openness_0 + _S946);
}

fn scattered_by_0( _S947 : u32,  _S948 : Albedos_0,  _S949 : u32,  _S950 : vec3<f32>) -> Scattered_0
{
    var _S951 : u32 = u32(159) + u32(2) * _S949;
    var yarn_4 : Scattered_0;
    yarn_4.back_9 = _S950 * _S948.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S947, _S951)) * _S948.specular_reflect_0;
    yarn_4.through_1 = _S950 * _S948.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S947, _S951 + u32(1))) * _S948.specular_transmit_0;
    return yarn_4;
}

fn sent_0( _S952 : u32,  _S953 : u32,  _S954 : vec3<f32>,  _S955 : vec3<f32>,  _S956 : vec3<f32>,  _S957 : vec3<f32>,  _S958 : ptr<function, vec3<f32>>,  _S959 : ptr<function, vec3<f32>>)
{
    var _S960 : u32 = u32(146) + u32(4) * _S953;
    var _S961 : f32 = openness_number_0(_S952, _S960 + u32(1));
    var _S962 : f32 = openness_number_0(_S952, _S960 + u32(2));
    var _S963 : vec3<f32> = vec3<f32>(1.0f);
    var _S964 : vec3<f32> = _S963 - _S956 * vec3<f32>(openness_number_0(_S952, _S960));
    var _S965 : vec3<f32> = _S963 - _S957 * vec3<f32>(openness_number_0(_S952, _S960 + u32(3)));
    var _S966 : vec3<f32> = _S963 / (_S964 * _S965 - _S956 * _S957 * vec3<f32>((_S961 * _S962)));
    (*_S958) = (_S954 * _S965 + _S956 * vec3<f32>(_S961) * _S955) * _S966;
    (*_S959) = (_S955 * _S964 + _S957 * vec3<f32>(_S962) * _S954) * _S966;
    return;
}

fn face_sends_0( _S967 : u32,  _S968 : u32,  _S969 : Scattered_0,  _S970 : Scattered_0) -> FaceSends_0
{
    var _S971 : u32 = u32(2) * _S968;
    var _S972 : u32 = u32(142) + _S971;
    var _S973 : f32 = openness_number_0(_S967, _S972);
    var _S974 : f32 = openness_number_0(_S967, _S972 + u32(1));
    var _S975 : vec3<f32> = vec3<f32>((1.0f - _S973)) * _S969.back_9;
    var _S976 : vec3<f32> = vec3<f32>((1.0f - _S974)) * _S970.back_9;
    var sends_1 : FaceSends_0;
    var _S977 : u32 = u32(154) + _S971;
    var _S978 : f32 = openness_number_0(_S967, _S977);
    sends_1.blocks_warp_0 = _S978;
    var _S979 : f32 = openness_number_0(_S967, _S977 + u32(1));
    sends_1.blocks_weft_0 = _S979;
    sends_1.open_0 = _S978 * _S973 + _S979 * _S974;
    var _S980 : vec3<f32> = vec3<f32>(_S973) * _S969.back_9;
    var _S981 : vec3<f32> = vec3<f32>(_S974) * _S970.back_9;
    var _S982 : vec3<f32> = sends_1.sky_warp_0;
    var _S983 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S967, _S968, _S980, _S981, _S975, _S976, &(_S982), &(_S983));
    sends_1.sky_warp_0 = _S982;
    sends_1.sky_weft_0 = _S983;
    var _S984 : vec3<f32> = sends_1.crossing_warp_0;
    var _S985 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S967, _S968, _S969.through_1, _S970.through_1, _S975, _S976, &(_S984), &(_S985));
    sends_1.crossing_warp_0 = _S984;
    sends_1.crossing_weft_0 = _S985;
    return sends_1;
}

fn interior_between_0( _S986 : u32,  _S987 : u32,  _S988 : u32,  _S989 : vec3<f32>,  _S990 : bool) -> Interior_0
{
    var _S991 : Scattered_0 = scattered_by_0(_S986, table_albedos_0(_S987), u32(0), _S989);
    var _S992 : Scattered_0 = scattered_by_0(_S986, table_albedos_0(_S988), u32(1), _S989);
    var _S993 : FaceSends_0 = face_sends_0(_S986, select(u32(0), u32(1), _S990), _S991, _S992);
    var _S994 : FaceSends_0 = face_sends_0(_S986, select(u32(1), u32(0), _S990), _S991, _S992);
    var _S995 : vec3<f32> = vec3<f32>(_S993.blocks_warp_0);
    var _S996 : vec3<f32> = vec3<f32>(_S993.blocks_weft_0);
    var _S997 : vec3<f32> = _S995 * _S993.crossing_warp_0 + _S996 * _S993.crossing_weft_0;
    var _S998 : vec3<f32> = vec3<f32>(_S994.blocks_warp_0);
    var _S999 : vec3<f32> = vec3<f32>(_S994.blocks_weft_0);
    var _S1000 : vec3<f32> = _S998 * _S994.crossing_warp_0 + _S999 * _S994.crossing_weft_0;
    var _S1001 : f32 = 1.0f - _S993.open_0;
    var _S1002 : f32 = 1.0f - _S994.open_0;
    var _S1003 : vec3<f32> = vec3<f32>(1.0f);
    var _S1004 : vec3<f32> = _S1003 / (_S1003 - _S997 * _S1000 * vec3<f32>((_S1001 * _S1002)));
    var _S1005 : vec3<f32> = _S1000 * (vec3<f32>(_S993.open_0) + vec3<f32>(_S1001) * (_S995 * _S993.sky_warp_0 + _S996 * _S993.sky_weft_0)) * _S1004;
    var _S1006 : vec3<f32> = _S997 * (vec3<f32>(_S994.open_0) + vec3<f32>(_S1002) * (_S998 * _S994.sky_warp_0 + _S999 * _S994.sky_weft_0)) * _S1004;
    var _S1007 : FaceRadiance_0 = face_radiance_0(_S993, _S994.open_0, _S1005, _S1006);
    var _S1008 : FaceRadiance_0 = face_radiance_0(_S994, _S993.open_0, _S1006, _S1005);
    var interior_1 : Interior_0;
    interior_1.warp_9 = _S1007.warp_8;
    interior_1.weft_9 = _S1007.weft_8;
    interior_1.leaked_1 = _S1007.leaked_0;
    interior_1.far_1 = _S1008.mean_1;
    interior_1.far_leaked_0 = _S1008.leaked_0;
    return interior_1;
}

fn interior_of_0( _S1009 : u32,  _S1010 : vec3<f32>,  _S1011 : bool) -> Interior_0
{
    return interior_between_0(_S1009, families_0[fabrics_0[_S1009].warp_0].cloth_mean_0, families_0[fabrics_0[_S1009].weft_0].cloth_mean_0, _S1010, _S1011);
}

fn blocked_of_terms_0( _S1012 : u32,  _S1013 : u32,  _S1014 : array<f32, i32(6)>,  _S1015 : u32) -> Blocked_0
{
    var shares_2 : array<f32, i32(3)>;
    var share_4 : u32 = u32(0);
    for(;;)
    {
        if(share_4 < u32(3))
        {
        }
        else
        {
            break;
        }
        shares_2[share_4] = 0.0f;
        var term_2 : u32 = u32(0);
        for(;;)
        {
            if(term_2 < _S1015)
            {
            }
            else
            {
                break;
            }
            shares_2[share_4] = shares_2[share_4] + openness_number_0(_S1012, _S1013 + share_4 * _S1015 + term_2) * _S1014[term_2];
            term_2 = term_2 + u32(1);
        }
        shares_2[share_4] = saturate(shares_2[share_4]);
        share_4 = share_4 + u32(1);
    }
    var blocked_2 : Blocked_0;
    blocked_2.by_warp_0 = shares_2[i32(0)] * shares_2[i32(2)];
    blocked_2.by_weft_0 = shares_2[i32(0)] * (1.0f - shares_2[i32(2)]);
    blocked_2.far_0 = shares_2[i32(1)];
    return blocked_2;
}

fn blocked_from_0( _S1016 : u32,  _S1017 : vec3<f32>,  _S1018 : bool,  _S1019 : bool) -> Blocked_0
{
    var terms_5 : array<f32, i32(6)>;
    view_terms_0(_S1017, &(terms_5));
    return blocked_of_terms_0(_S1016, (select(u32(0), u32(2), _S1019) + select(u32(1), u32(0), _S1018)) * u32(15), terms_5, u32(5));
}

fn warp_seen_from_0( _S1020 : u32,  _S1021 : vec3<f32>,  _S1022 : bool) -> f32
{
    var terms_6 : array<f32, i32(6)>;
    view_terms_1(_S1021, &(terms_6));
    var term_3 : u32 = u32(0);
    var share_5 : f32 = 0.0f;
    for(;;)
    {
        if(term_3 < u32(5))
        {
        }
        else
        {
            break;
        }
        var share_6 : f32 = share_5 + openness_number_0(_S1020, u32(132) + select(u32(0), u32(5), _S1022) + term_3) * terms_6[term_3];
        term_3 = term_3 + u32(1);
        share_5 = share_6;
    }
    return saturate(share_5);
}

fn bounced_of_families_0( _S1023 : u32,  _S1024 : FamilyAlbedos_0,  _S1025 : vec3<f32>,  _S1026 : Interior_0,  _S1027 : Blocked_0,  _S1028 : Blocked_0) -> Bounced_0
{
    return sum_of_0(bounced_by_0(_S1027, scattered_by_0(_S1023, _S1024.warp_5, u32(0), _S1025), _S1026), bounced_by_0(_S1028, scattered_by_0(_S1023, _S1024.weft_5, u32(1), _S1025), _S1026));
}

fn bounced_far_0( _S1029 : u32,  _S1030 : FamilyAlbedos_0,  _S1031 : vec3<f32>,  _S1032 : Interior_0,  _S1033 : vec3<f32>,  _S1034 : bool,  _S1035 : f32,  _S1036 : f32,  _S1037 : f32) -> Bounced_0
{
    var _S1038 : Blocked_0 = blocked_from_0(_S1029, _S1033, true, _S1034);
    var _S1039 : Blocked_0 = blocked_from_0(_S1029, _S1033, false, _S1034);
    var _S1040 : f32 = _S1035 / max(1.0f - _S1038.by_warp_0 - _S1038.by_weft_0, 0.10000000149011612f);
    var _S1041 : f32 = (0.0020000000949949f * warp_seen_from_0(_S1029, _S1033, _S1034) + _S1040) / (_S1040 + _S1036 / max(1.0f - _S1039.by_warp_0 - _S1039.by_weft_0, 0.10000000149011612f) + 0.0020000000949949f);
    var _S1042 : f32 = 1.0f - _S1037;
    return bounced_of_families_0(_S1029, _S1030, _S1031, _S1032, scaled_0(_S1038, _S1041 * _S1042), scaled_0(_S1039, (1.0f - _S1041) * _S1042));
}

fn bounced_over_0( _S1043 : u32,  _S1044 : Components_0,  _S1045 : CloseUp_0,  _S1046 : FamilyAlbedos_0,  _S1047 : vec3<f32>,  _S1048 : vec3<f32>) -> Bounced_0
{
    var _S1049 : bool = (_S1048.z) < 0.0f;
    var _S1050 : Interior_0 = interior_of_0(_S1043, _S1047, _S1049);
    var bounced_2 : Bounced_0 = bounced_far_0(_S1043, _S1046, _S1047, _S1050, to_face_frame_0(_S1048, _S1049), _S1049, _S1044.diffuse_warp_0, _S1044.diffuse_weft_0, _S1044.hole_5);
    if((_S1045.weight_7) > 0.0f)
    {
        var _S1051 : Bounced_0 = bounced_of_families_0(_S1043, _S1046, _S1047, _S1050, _S1045.warp_7, _S1045.weft_7);
        var _S1052 : vec3<f32> = vec3<f32>(_S1045.weight_7);
        bounced_2.reflected_2 = mix(bounced_2.reflected_2, _S1051.reflected_2, _S1052);
        bounced_2.transmitted_2 = mix(bounced_2.transmitted_2, _S1051.transmitted_2, _S1052);
    }
    return bounced_2;
}

fn composed_before_0( _S1053 : u32,  _S1054 : Components_0,  _S1055 : CloseUp_0,  _S1056 : FamilyAlbedos_0,  _S1057 : LayersBehind_0,  _S1058 : vec3<f32>,  _S1059 : vec3<f32>,  _S1060 : vec3<f32>) -> vec3<f32>
{
    var _S1061 : Albedos_0 = towards_grazing_0(_S1053, tinted_0(_S1056.warp_5, _S1058), _S1059, _S1060);
    var _S1062 : Albedos_0 = towards_grazing_0(_S1053, tinted_0(_S1056.weft_5, _S1058), _S1059, _S1060);
    var _S1063 : vec3<f32> = vec3<f32>(_S1054.diffuse_warp_0);
    var _S1064 : vec3<f32> = vec3<f32>(_S1054.diffuse_weft_0);
    var _S1065 : vec3<f32> = vec3<f32>(_S1054.specular_warp_0);
    var _S1066 : vec3<f32> = vec3<f32>(_S1054.specular_weft_0);
    var _S1067 : vec3<f32> = _S1061.diffuse_reflect_0 * _S1063 + _S1062.diffuse_reflect_0 * _S1064 + _S1061.specular_reflect_0 * _S1065 + _S1062.specular_reflect_0 * _S1066;
    var _S1068 : f32 = _S1059.z;
    var _S1069 : f32 = _S1060.z;
    var _S1070 : bool = (_S1068 * _S1069) < 0.0f;
    var body_0 : vec3<f32>;
    if(_S1070)
    {
        body_0 = _S1061.diffuse_transmit_0 * _S1063 + _S1062.diffuse_transmit_0 * _S1064 + _S1061.specular_transmit_0 * _S1065 + _S1062.specular_transmit_0 * _S1066;
    }
    else
    {
        body_0 = _S1067;
    }
    if((fabrics_0[_S1053].openness_0) != u32(4294967295))
    {
        body_0 = body_0 + bounced_value_0(bounced_over_0(_S1053, _S1054, _S1055, _S1056, _S1058, _S1060), _S1059, _S1060) * vec3<f32>(diffuse_kept_0(_S1053, _S1059, _S1060));
    }
    if(is_layered_0(_S1053))
    {
        body_0 = body_0 + _S1058 * select_vector_2(_S1070, _S1057.transmitted_0, _S1057.reflected_0) * vec3<f32>((abs(_S1068) * 0.31830987334251404f)) * vec3<f32>(diffuse_kept_0(_S1053, _S1059, _S1060));
    }
    var _S1071 : f32 = fabrics_0[_S1053].sheen_strength_0;
    if((fabrics_0[_S1053].sheen_strength_0) <= 0.0f)
    {
        return body_0;
    }
    var _S1072 : bool = _S1069 < 0.0f;
    var _S1073 : vec2<f32> = sheen_with_transmittance_0(to_face_frame_0(_S1059, _S1072), to_face_frame_0(_S1060, _S1072), _S1071, fabrics_0[_S1053].sheen_roughness_0);
    return vec3<f32>(_S1073.y) * body_0 + vec3<f32>(((_S1054.light_visibility_1 + _S1054.hole_5) * _S1073.x));
}

fn composed_0( _S1074 : u32,  _S1075 : Components_0,  _S1076 : CloseUp_0,  _S1077 : FamilyAlbedos_0,  _S1078 : vec3<f32>,  _S1079 : vec3<f32>,  _S1080 : vec3<f32>) -> vec3<f32>
{
    var _S1081 : vec3<f32> = vec3<f32>(0.0f);
    return composed_before_0(_S1074, _S1075, _S1076, _S1077, LayersBehind_x24init_0(_S1081, _S1081), _S1078, _S1079, _S1080);
}

fn light_of_neural_0( _S1082 : u32,  _S1083 : VisiblePoint_0,  _S1084 : vec2<u32>,  _S1085 : vec3<f32>) -> vec4<f32>
{
    var footprint_1 : Footprint_0;
    footprint_1.dx_0 = _S1083.draft_dx_0;
    footprint_1.dy_0 = _S1083.draft_dy_0;
    footprint_1.centre_0 = irregular_place_0(_S1082, _S1083.draft_0, Footprint_spread_side_0(footprint_1));
    var _S1086 : vec3<f32> = to_local_0(_S1083, _S1083.view_0);
    var activations_0 : NeuralView_0;
    neural_view_0(_S1082, footprint_1, _S1086, &(activations_0));
    var _S1087 : f32 = _S1086.z;
    var _S1088 : FamilyAlbedos_0 = with_tones_0(_S1082, albedos_over_0(_S1082, footprint_1, _S1087 < 0.0f), activations_0.yarns_0);
    var _S1089 : vec3<f32> = vec3<f32>(0.0f);
    var number_14 : u32 = u32(0);
    var radiance_1 : vec3<f32> = _S1089;
    for(;;)
    {
        if(number_14 < (light_sample_count_0()))
        {
        }
        else
        {
            break;
        }
        var _S1090 : f32 = visibility_at_0(number_14, _S1084);
        if(_S1090 <= 0.0f)
        {
            number_14 = number_14 + u32(1);
            continue;
        }
        var _S1091 : LightSample_0 = light_sample_0(number_14, _S1084, _S1083.position_4);
        var _S1092 : vec3<f32> = to_local_0(_S1083, _S1091.towards_0);
        var _S1093 : Components_0 = neural_components_0(_S1082, &(activations_0), _S1092);
        radiance_1 = radiance_1 + vec3<f32>(_S1090) * _S1091.irradiance_1 * composed_0(_S1082, _S1093, no_close_up_0(), _S1088, _S1085, _S1092, _S1086);
        number_14 = number_14 + u32(1);
    }
    var hole_6 : f32 = activations_0.hole_2;
    var _S1094 : f32 = fabrics_0[_S1082].sheen_strength_0;
    var hole_7 : f32;
    if((fabrics_0[_S1082].sheen_strength_0) > 0.0f)
    {
        hole_7 = hole_6 * (1.0f - _S1094 * sheen_lobe_0(abs(_S1087), fabrics_0[_S1082].sheen_roughness_0).z);
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
    var _S1095 : u32 = id_0.x;
    var _S1096 : bool;
    if(_S1095 >= (frame_record_0.width_0))
    {
        _S1096 = true;
    }
    else
    {
        _S1096 = (id_0.y) >= (frame_record_0.height_0);
    }
    if(_S1096)
    {
        return;
    }
    var _S1097 : u32 = id_0.y * frame_record_0.width_0 + _S1095;
    var _S1098 : u32 = layers_0[_S1097].face_0;
    if((layers_0[_S1097].face_0) == u32(0))
    {
        return;
    }
    var _S1099 : u32 = _S1098 - u32(1);
    var _S1100 : u32 = fabric_of_0(_S1099);
    var _S1101 : vec2<u32> = id_0.xy;
    var _S1102 : VisiblePoint_0 = visible_point_0(_S1100, _S1099, _S1101);
    accumulate_0(_S1097, light_of_neural_0(_S1100, _S1102, _S1101, filtered_albedo_0(_S1100, _S1102)));
    return;
}

