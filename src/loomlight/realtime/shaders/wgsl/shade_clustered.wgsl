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

@binding(6) @group(0) var<storage, read_write> visibilities_0 : array<f32>;

@binding(7) @group(0) var<storage, read_write> radiance_0 : array<vec4<f32>>;

fn select_vector_0( condition_0 : bool,  yes_0 : vec4<f32>,  no_0 : vec4<f32>) -> vec4<f32>
{
    var chosen_0 : vec4<f32>;
    chosen_0[i32(0)] = select(no_0[i32(0)], yes_0[i32(0)], condition_0);
    chosen_0[i32(1)] = select(no_0[i32(1)], yes_0[i32(1)], condition_0);
    chosen_0[i32(2)] = select(no_0[i32(2)], yes_0[i32(2)], condition_0);
    chosen_0[i32(3)] = select(no_0[i32(3)], yes_0[i32(3)], condition_0);
    return chosen_0;
}

fn select_vector_1( condition_1 : bool,  yes_1 : vec2<f32>,  no_1 : vec2<f32>) -> vec2<f32>
{
    var chosen_1 : vec2<f32>;
    chosen_1[i32(0)] = select(no_1[i32(0)], yes_1[i32(0)], condition_1);
    chosen_1[i32(1)] = select(no_1[i32(1)], yes_1[i32(1)], condition_1);
    return chosen_1;
}

fn rsqrt_0( x_0 : f32) -> f32
{
    return 1.0f / sqrt(x_0);
}

fn select_vector_2( condition_2 : bool,  yes_2 : vec3<f32>,  no_2 : vec3<f32>) -> vec3<f32>
{
    var chosen_2 : vec3<f32>;
    chosen_2[i32(0)] = select(no_2[i32(0)], yes_2[i32(0)], condition_2);
    chosen_2[i32(1)] = select(no_2[i32(1)], yes_2[i32(1)], condition_2);
    chosen_2[i32(2)] = select(no_2[i32(2)], yes_2[i32(2)], condition_2);
    return chosen_2;
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

fn fabric_of_0( face_1 : u32) -> u32
{
    return scene_words_0[frame_record_0.face_fabrics_0 + face_1];
}

struct Vertex_0
{
     x_1 : f32,
     y_0 : f32,
     z_0 : f32,
     normal_x_0 : f32,
     normal_y_0 : f32,
     normal_z_0 : f32,
     u_0 : f32,
     v_0 : f32,
};

fn scene_vertex_0( first_0 : u32) -> Vertex_0
{
    var record_0 : Vertex_0;
    record_0.x_1 = (bitcast<f32>((scene_words_0[first_0])));
    record_0.y_0 = (bitcast<f32>((scene_words_0[first_0 + u32(1)])));
    record_0.z_0 = (bitcast<f32>((scene_words_0[first_0 + u32(2)])));
    record_0.normal_x_0 = (bitcast<f32>((scene_words_0[first_0 + u32(3)])));
    record_0.normal_y_0 = (bitcast<f32>((scene_words_0[first_0 + u32(4)])));
    record_0.normal_z_0 = (bitcast<f32>((scene_words_0[first_0 + u32(5)])));
    record_0.u_0 = (bitcast<f32>((scene_words_0[first_0 + u32(6)])));
    record_0.v_0 = (bitcast<f32>((scene_words_0[first_0 + u32(7)])));
    return record_0;
}

fn vertex_at_0( corner_0 : u32) -> Vertex_0
{
    return scene_vertex_0(frame_record_0.vertices_0 + u32(8) * scene_words_0[frame_record_0.corners_0 + corner_0]);
}

fn position_of_0( vertex_0 : Vertex_0) -> vec3<f32>
{
    return vec3<f32>(vertex_0.x_1, vertex_0.y_0, vertex_0.z_0);
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
    var _S1 : u32 = value_0 * u32(747796405) + u32(2891336453);
    var _S2 : u32 = ((((_S1 >> ((((_S1 >> (u32(28)))) + u32(4))))) ^ (_S1))) * u32(277803737);
    return (((_S2 >> (u32(22)))) ^ (_S2));
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
    var _S3 : vec2<f32> = floor(place_0);
    var _S4 : vec2<f32> = place_0 - _S3;
    var _S5 : vec2<f32> = _S4 * _S4 * (vec2<f32>(3.0f) - vec2<f32>(2.0f) * _S4);
    var _S6 : u32 = u32(i32(_S3.x)) * u32(65536) + u32(i32(_S3.y));
    var _S7 : f32 = _S5.x;
    return mix(mix(uneven_corner_0(key_2, _S6), uneven_corner_0(key_2, _S6 + u32(65536)), _S7), mix(uneven_corner_0(key_2, _S6 + u32(1)), uneven_corner_0(key_2, _S6 + u32(65537)), _S7), _S5.y);
}

fn square_1( x_2 : f32) -> f32
{
    return x_2 * x_2;
}

fn natural_logarithm_0( x_3 : f32) -> f32
{
    var _S8 : u32 = (bitcast<u32>((x_3)));
    var m_0 : f32 = (bitcast<f32>(((((_S8 & (u32(8388607)))) | (u32(1056964608))))));
    var _S9 : bool = m_0 < 0.70710676908493042f;
    var exponent_0 : f32 = f32(i32((_S8 >> (u32(23)))) - i32(126)) - select(0.0f, 1.0f, _S9);
    var m_1 : f32 = select(m_0, m_0 + m_0, _S9) - 1.0f;
    var _S10 : f32 = m_1 * m_1;
    return m_1 + (((((((((0.07037683576345444f * m_1 - 0.11514610052108765f) * m_1 + 0.11676998436450958f) * m_1 - 0.12420140951871872f) * m_1 + 0.14249323308467865f) * m_1 - 0.16668057441711426f) * m_1 + 0.20000714063644409f) * m_1 - 0.24999994039535522f) * m_1 + 0.33333331346511841f) * m_1 * _S10 - exponent_0 * 0.00021219444170129f - 0.5f * _S10) + exponent_0 * 0.693359375f;
}

fn binary_logarithm_0( x_4 : f32) -> f32
{
    return natural_logarithm_0(x_4) * 1.4426950216293335f;
}

fn exponential_0( x_5 : f32) -> f32
{
    var _S11 : f32 = clamp(x_5, -87.0f, 88.0f);
    var _S12 : f32 = floor(_S11 * 1.4426950216293335f + 0.5f);
    var _S13 : f32 = _S11 - _S12 * 0.693359375f + _S12 * 0.00021219444170129f;
    return select(((((((0.00019875691214111f * _S13 + 0.00139819993637502f) * _S13 + 0.00833345204591751f) * _S13 + 0.04166579619050026f) * _S13 + 0.1666666567325592f) * _S13 + 0.5f) * _S13 * _S13 + _S13 + 1.0f) * (bitcast<f32>(((u32(i32(_S12) + i32(127)) << (u32(23)))))), 0.0f, x_5 < -87.0f);
}

fn map_texel_0( index_0 : u32) -> vec3<f32>
{
    var _S14 : u32 = scene_words_0[index_0];
    var _S15 : vec3<f32> = vec3<f32>(f32((_S14 & (u32(1023)))), f32((((_S14 >> (u32(10)))) & (u32(1023)))), f32((_S14 >> (u32(20))))) / vec3<f32>(1023.0f);
    return _S15 * _S15;
}

fn map_level_0( first_1 : u32,  side_0 : u32,  uv_0 : vec2<f32>) -> vec3<f32>
{
    var _S16 : f32 = uv_0.x;
    var _S17 : f32 = f32(side_0);
    var _S18 : f32 = (_S16 - floor(_S16)) * _S17 - 0.5f;
    var _S19 : f32 = uv_0.y;
    var _S20 : f32 = (_S19 - floor(_S19)) * _S17 - 0.5f;
    var _S21 : f32 = floor(_S18);
    var _S22 : i32 = i32(side_0);
    var _S23 : u32 = side_0 - u32(1);
    var _S24 : u32 = (u32(i32(_S21) + _S22) & (_S23));
    var _S25 : f32 = floor(_S20);
    var _S26 : u32 = (u32(i32(_S25) + _S22) & (_S23));
    var _S27 : u32 = ((_S24 + u32(1)) & (_S23));
    var _S28 : u32 = first_1 + _S26 * side_0;
    var _S29 : vec3<f32> = vec3<f32>((_S18 - _S21));
    var _S30 : u32 = first_1 + (((_S26 + u32(1)) & (_S23))) * side_0;
    return mix(mix(map_texel_0(_S28 + _S24), map_texel_0(_S28 + _S27), _S29), mix(map_texel_0(_S30 + _S24), map_texel_0(_S30 + _S27), _S29), vec3<f32>((_S20 - _S25)));
}

struct Footprint_0
{
     centre_0 : vec2<f32>,
     dx_0 : vec2<f32>,
     dy_0 : vec2<f32>,
};

fn Footprint_spread_side_0( this_0 : Footprint_0) -> f32
{
    var _S31 : vec2<f32> = this_0.dx_0;
    var _S32 : vec2<f32> = this_0.dy_0;
    return sqrt(0.5f * (dot(_S31, _S31) + dot(_S32, _S32)));
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
    var _S33 : f32 = floor(fma(index_1, families_0[family_1].inverse_count_0, families_0[family_1].half_inverse_count_0));
    return vec2<f32>(_S33, fma(- _S33, families_0[family_1].count_0, index_1));
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
    var _S34 : f32 = floor(position_0 * families_0[family_2].inverse_size_0);
    var cell_2 : Cell_0;
    var _S35 : f32 = fma(- _S34, families_0[family_2].size_0, position_0);
    cell_2.below_0 = _S35;
    cell_2.above_0 = families_0[family_2].size_0 - _S35;
    cell_2.across_0 = _S35 - 0.5f * families_0[family_2].size_0;
    cell_2.half_width_1 = families_0[family_2].half_width_0;
    cell_2.thread_1 = u32(clamp(turns_and_remainder_0(family_2, _S34).y, 0.0f, families_0[family_2].count_0 - 1.0f));
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
    var _S36 : f32 = turns_1 * families_0[family_3].period_0;
    var thread_2 : u32 = words_0[families_0[family_3].first_thread_table_0 + u32(clamp(turns_1 * families_0[family_3].bins_0, 0.0f, families_0[family_3].bins_0 - 1.0f))];
    var _S37 : u32 = min(thread_2 + select(u32(0), u32(1), _S36 >= (table_number_0(families_0[family_3].place_table_0 + thread_2 * u32(4) + u32(1)))), u32(families_0[family_3].count_0) - u32(1));
    var _S38 : u32 = families_0[family_3].place_table_0 + _S37 * u32(4);
    var cell_3 : Cell_0;
    cell_3.thread_1 = _S37;
    cell_3.below_0 = _S36 - table_number_0(_S38);
    cell_3.above_0 = table_number_0(_S38 + u32(1)) - _S36;
    cell_3.across_0 = _S36 - table_number_0(_S38 + u32(2));
    cell_3.half_width_1 = table_number_0(_S38 + u32(3));
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

fn irregular_entry_0( row_0 : u32,  column_0 : f32) -> vec4<u32>
{
    var _S39 : u32 = row_0 + u32(4) * ((u32(i32(column_0)) & (u32(1023))));
    return vec4<u32>(words_0[_S39], words_0[_S39 + u32(1)], words_0[_S39 + u32(2)], words_0[_S39 + u32(3)]);
}

fn irregular_integral_0( family_6 : u32,  threads_0 : u32,  begin_0 : f32,  steps_0 : f32) -> vec4<f32>
{
    var _S40 : u32 = families_0[family_6].irregular_table_0 + threads_0 * u32(4096);
    var _S41 : f32 = begin_0 + steps_0;
    var _S42 : f32 = floor(begin_0);
    var _S43 : vec4<u32> = irregular_entry_0(_S40, _S42);
    var _S44 : f32 = floor(_S41);
    var _S45 : vec4<u32> = irregular_entry_0(_S40, _S44);
    return vec4<f32>(vec4<i32>(_S45 - _S43)) + (vec4<f32>(vec4<i32>(irregular_entry_0(_S40, _S44 + 1.0f) - _S45)) * vec4<f32>((_S41 - _S44)) - vec4<f32>(vec4<i32>(irregular_entry_0(_S40, _S42 + 1.0f) - _S43)) * vec4<f32>((begin_0 - _S42)));
}

fn irregular_units_0( family_7 : u32) -> vec4<f32>
{
    return vec4<f32>(families_0[family_7].irregular_thickness_0, families_0[family_7].irregular_cover_0, families_0[family_7].irregular_tone_0, families_0[family_7].irregular_nep_0);
}

fn irregular_at_0( family_8 : u32,  key_3 : u32,  number_0 : f32,  along_0 : f32) -> vec4<f32>
{
    var _S46 : f32 = floor(number_0 / 64.0f);
    var _S47 : u32 = hash_bits_0(key_3, u32(i32(_S46)));
    var _S48 : u32 = ((_S47 & (u32(127)))) + u32(number_0 - 64.0f * _S46);
    var _S49 : f32 = along_0 / 2.0f - 0.5f + f32((_S47 >> (u32(22))));
    var sums_1 : vec4<f32> = vec4<f32>(0.0f);
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
        var _S50 : vec4<f32> = irregular_integral_0(family_8, _S48 + side_1, _S49, 1.0f) - sums_1;
        var _S51 : u32 = side_1 + u32(1);
        sums_1 = _S50;
        side_1 = _S51;
    }
    return sums_1 * irregular_units_0(family_8);
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

fn mixed_0( number_1 : u32) -> u32
{
    var bits_0 : u32 = ((number_1 ^ (((number_1 >> (u32(16))))))) * u32(2246822507);
    var bits_1 : u32 = ((bits_0 ^ (((bits_0 >> (u32(13))))))) * u32(3266489909);
    return (bits_1 ^ (((bits_1 >> (u32(16))))));
}

fn uniform_of_0( seed_1 : u32,  dimension_0 : u32) -> f32
{
    return f32(((mixed_0(seed_1 + (dimension_0 + u32(1)) * u32(2654435769))) >> (u32(8)))) * 5.9604644775390625e-08f;
}

fn to_face_frame_0( direction_1 : vec3<f32>,  back_2 : bool) -> vec3<f32>
{
    var _S52 : f32 = direction_1.z;
    return vec3<f32>(direction_1.xy, select(_S52, - _S52, back_2));
}

struct TexelBox_0
{
     corner_1 : vec2<f32>,
     size_3 : vec2<f32>,
     first_2 : vec2<u32>,
     extent_0 : vec2<f32>,
     last_0 : vec2<u32>,
     turns_2 : vec2<f32>,
};

fn texel_box_0( tables_0 : ptr<function, Clustered_std430_0>,  footprint_0 : Footprint_0,  offset_1 : vec2<f32>,  place_1 : f32) -> TexelBox_0
{
    var _S53 : f32 = footprint_0.dx_0.x;
    var _S54 : f32 = footprint_0.dy_0.x;
    var _S55 : f32 = sqrt(_S53 * _S53 + _S54 * _S54);
    var _S56 : f32 = footprint_0.dx_0.y;
    var _S57 : f32 = footprint_0.dy_0.y;
    var _S58 : f32 = sqrt(_S56 * _S56 + _S57 * _S57);
    var _S59 : vec2<f32> = vec2<f32>(_S55, _S58);
    var _S60 : f32 = (_S53 * _S56 + _S54 * _S57) / max(_S55 * _S58, 1.00000000317107685e-30f);
    var _S61 : f32 = abs(_S60);
    var _S62 : f32 = place_1 * sqrt(min(_S61, 1.0f));
    var _S63 : vec2<f32> = _S59 * vec2<f32>(_S62, select(_S62, - _S62, _S60 < 0.0f));
    var _S64 : vec2<f32> = vec2<f32>((*tables_0).texel_width_0, (*tables_0).texel_height_0);
    var _S65 : u32 = (*tables_0).columns_0;
    var _S66 : u32 = (*tables_0).rows_0;
    var _S67 : vec2<f32> = vec2<f32>(f32((*tables_0).columns_0), f32((*tables_0).rows_0));
    var box_0 : TexelBox_0;
    var _S68 : vec2<f32> = _S59 * vec2<f32>(sqrt(max(1.0f - _S61, 0.0f)));
    box_0.size_3 = _S68;
    var _S69 : vec2<f32> = vec2<f32>(0.5f);
    var _S70 : vec2<f32> = _S69 * _S68;
    var _S71 : vec2<f32> = footprint_0.centre_0 + _S63 - _S70;
    box_0.corner_1 = _S71;
    var _S72 : vec2<f32> = max(round(_S68 / _S64), vec2<f32>(1.0f));
    box_0.extent_0 = _S72;
    var _S73 : vec2<f32> = round((_S71 + _S70 + offset_1) / _S64 - _S69 * _S72);
    var _S74 : vec2<f32> = vec2<f32>(0.0f);
    var _S75 : vec2<f32> = max(_S73 - floor(_S73 / _S67) * _S67, _S74);
    var _S76 : vec2<u32> = vec2<u32>(min(u32(_S75.x), (*tables_0).columns_0 - u32(1)), min(u32(_S75.y), (*tables_0).rows_0 - u32(1)));
    box_0.first_2 = _S76;
    var _S77 : vec2<f32> = floor(_S72 / _S67);
    box_0.turns_2 = _S77;
    var _S78 : vec2<f32> = max(_S72 - _S77 * _S67, _S74);
    var _S79 : vec2<u32> = _S76 + vec2<u32>(u32(_S78.x), u32(_S78.y));
    box_0.last_0 = _S79;
    if((_S79.x) >= ((*tables_0).columns_0))
    {
        box_0.last_0[i32(0)] = box_0.last_0[i32(0)] - _S65;
        box_0.turns_2[i32(0)] = box_0.turns_2[i32(0)] + 1.0f;
    }
    if((box_0.last_0.y) >= _S66)
    {
        box_0.last_0[i32(1)] = box_0.last_0[i32(1)] - _S66;
        box_0.turns_2[i32(1)] = box_0.turns_2[i32(1)] + 1.0f;
    }
    return box_0;
}

fn arc_tangent_quotient_0( x_6 : f32,  y_1 : f32) -> f32
{
    return ((((((0.0f * x_6 + 0.00809729471802711f) * x_6 + -0.0377517081797123f) * x_6 + 0.08475969731807709f) * x_6 + -0.13537675142288208f) * x_6 + 0.19895026087760925f) * x_6 + -0.33327975869178772f) * x_6 + 0.99999970197677612f;
}

fn arc_tangent_of_ratio_0( ratio_0 : f32) -> f32
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0f);
}

struct BinTaps_0
{
     corner_2 : u32,
     bins_1 : u32,
     weights_0 : vec4<f32>,
};

fn bin_taps_0( direction_2 : vec3<f32>,  bins_2 : u32) -> BinTaps_0
{
    var _S80 : f32 = sqrt(max(1.0f - direction_2.z, 0.0f));
    var _S81 : f32 = direction_2.x;
    var _S82 : f32 = abs(_S81);
    var _S83 : f32 = direction_2.y;
    var _S84 : f32 = abs(_S83);
    var _S85 : bool = _S82 >= _S84;
    var _S86 : f32 = _S80 * (arc_tangent_of_ratio_0(min(_S82, _S84) / max(max(_S82, _S84), 9.999999960041972e-13f)) * 1.27323949337005615f);
    var _S87 : f32 = f32(bins_2);
    var _S88 : vec2<f32> = clamp((vec2<f32>(select(1.0f, -1.0f, _S81 < 0.0f) * select(_S86, _S80, _S85), select(1.0f, -1.0f, _S83 < 0.0f) * select(_S80, _S86, _S85)) + vec2<f32>(1.0f)) * vec2<f32>((0.5f * _S87)) - vec2<f32>(0.5f), vec2<f32>(0.0f), vec2<f32>((_S87 - 1.0f)));
    var _S89 : f32 = _S88.x;
    var _S90 : u32 = bins_2 - u32(2);
    var _S91 : u32 = min(u32(_S89), _S90);
    var _S92 : f32 = _S88.y;
    var _S93 : u32 = min(u32(_S92), _S90);
    var _S94 : f32 = _S89 - f32(_S91);
    var _S95 : f32 = _S92 - f32(_S93);
    var taps_0 : BinTaps_0;
    taps_0.corner_2 = _S93 * bins_2 + _S91;
    taps_0.bins_1 = bins_2;
    var _S96 : f32 = 1.0f - _S94;
    var _S97 : f32 = 1.0f - _S95;
    taps_0.weights_0 = vec4<f32>(_S96 * _S97, _S94 * _S97, _S96 * _S95, _S94 * _S95);
    return taps_0;
}

fn BinTaps_read_0( this_1 : BinTaps_0,  table_0 : u32,  first_3 : u32,  stride_0 : u32,  offset_2 : u32) -> f32
{
    var _S98 : u32 = table_0 + (first_3 + this_1.corner_2) * stride_0 + offset_2;
    return table_number_0(_S98) * this_1.weights_0.x + table_number_0(_S98 + stride_0) * this_1.weights_0.y + table_number_0(_S98 + this_1.bins_1 * stride_0) * this_1.weights_0.z + table_number_0(_S98 + (this_1.bins_1 + u32(1)) * stride_0) * this_1.weights_0.w;
}

fn summed_0( tables_1 : ptr<function, Clustered_std430_0>,  first_4 : u32,  column_1 : u32,  row_1 : u32) -> i32
{
    return i32(words_0[first_4 + (row_1 * ((*tables_1).columns_0 + u32(1)) + column_1) * (*tables_1).channels_0]);
}

fn box_mean_0( tables_2 : ptr<function, Clustered_std430_0>,  box_1 : TexelBox_0,  face_2 : u32,  channel_0 : u32) -> f32
{
    var _S99 : u32 = (*tables_2).columns_0;
    var _S100 : u32 = (*tables_2).rows_0;
    var _S101 : u32 = (*tables_2).sums_0 + face_2 * ((*tables_2).columns_0 + u32(1)) * ((*tables_2).rows_0 + u32(1)) * (*tables_2).channels_0 + channel_0;
    var _S102 : u32 = box_1.last_0.x;
    var _S103 : u32 = box_1.first_2.y;
    var _S104 : i32 = summed_0(&((*tables_2)), _S101, _S102, _S103);
    var _S105 : u32 = box_1.first_2.x;
    var _S106 : i32 = summed_0(&((*tables_2)), _S101, _S105, _S103);
    var _S107 : i32 = _S104 - _S106;
    var _S108 : u32 = box_1.last_0.y;
    var _S109 : i32 = summed_0(&((*tables_2)), _S101, _S102, _S108);
    var _S110 : i32 = summed_0(&((*tables_2)), _S101, _S105, _S108);
    var total_0 : f32 = f32(_S109 - _S110 - _S107);
    var _S111 : f32 = box_1.turns_2.x;
    var _S112 : bool = _S111 > 0.0f;
    var total_1 : f32;
    if(_S112)
    {
        var _S113 : i32 = summed_0(&((*tables_2)), _S101, _S99, _S108);
        var _S114 : i32 = summed_0(&((*tables_2)), _S101, _S99, _S103);
        total_1 = total_0 + _S111 * f32(_S113 - _S114);
    }
    else
    {
        total_1 = total_0;
    }
    var _S115 : f32 = box_1.turns_2.y;
    var _S116 : bool = _S115 > 0.0f;
    if(_S116)
    {
        var _S117 : i32 = summed_0(&((*tables_2)), _S101, _S102, _S100);
        var _S118 : i32 = summed_0(&((*tables_2)), _S101, _S105, _S100);
        total_1 = total_1 + _S115 * f32(_S117 - _S118);
    }
    if((_S112 & (_S116)))
    {
        var _S119 : f32 = _S111 * _S115;
        var _S120 : i32 = summed_0(&((*tables_2)), _S101, _S99, _S100);
        total_1 = total_1 + _S119 * f32(_S120);
    }
    return total_1 / (box_1.extent_0.x * box_1.extent_0.y);
}

fn box_mean_1( tables_3 : ptr<function, Clustered_std430_0>,  box_2 : TexelBox_0,  face_3 : u32,  channel_1 : u32) -> f32
{
    var _S121 : u32 = (*tables_3).columns_0;
    var _S122 : u32 = (*tables_3).rows_0;
    var _S123 : u32 = (*tables_3).sums_0 + face_3 * ((*tables_3).columns_0 + u32(1)) * ((*tables_3).rows_0 + u32(1)) * (*tables_3).channels_0 + channel_1;
    var _S124 : u32 = box_2.last_0.x;
    var _S125 : u32 = box_2.first_2.y;
    var _S126 : i32 = summed_0(&((*tables_3)), _S123, _S124, _S125);
    var _S127 : u32 = box_2.first_2.x;
    var _S128 : i32 = summed_0(&((*tables_3)), _S123, _S127, _S125);
    var _S129 : i32 = _S126 - _S128;
    var _S130 : u32 = box_2.last_0.y;
    var _S131 : i32 = summed_0(&((*tables_3)), _S123, _S124, _S130);
    var _S132 : i32 = summed_0(&((*tables_3)), _S123, _S127, _S130);
    var total_2 : f32 = f32(_S131 - _S132 - _S129);
    var _S133 : f32 = box_2.turns_2.x;
    var _S134 : bool = _S133 > 0.0f;
    var total_3 : f32;
    if(_S134)
    {
        var _S135 : i32 = summed_0(&((*tables_3)), _S123, _S121, _S130);
        var _S136 : i32 = summed_0(&((*tables_3)), _S123, _S121, _S125);
        total_3 = total_2 + _S133 * f32(_S135 - _S136);
    }
    else
    {
        total_3 = total_2;
    }
    var _S137 : f32 = box_2.turns_2.y;
    var _S138 : bool = _S137 > 0.0f;
    if(_S138)
    {
        var _S139 : i32 = summed_0(&((*tables_3)), _S123, _S124, _S122);
        var _S140 : i32 = summed_0(&((*tables_3)), _S123, _S127, _S122);
        total_3 = total_3 + _S137 * f32(_S139 - _S140);
    }
    if((_S134 & (_S138)))
    {
        var _S141 : f32 = _S133 * _S137;
        var _S142 : i32 = summed_0(&((*tables_3)), _S123, _S121, _S122);
        total_3 = total_3 + _S141 * f32(_S142);
    }
    return total_3 / (box_2.extent_0.x * box_2.extent_0.y);
}

fn box_mean_2( tables_4 : ptr<function, Clustered_std430_0>,  box_3 : TexelBox_0,  face_4 : u32,  channel_2 : u32) -> f32
{
    var _S143 : u32 = (*tables_4).columns_0;
    var _S144 : u32 = (*tables_4).rows_0;
    var _S145 : u32 = (*tables_4).sums_0 + face_4 * ((*tables_4).columns_0 + u32(1)) * ((*tables_4).rows_0 + u32(1)) * (*tables_4).channels_0 + channel_2;
    var _S146 : u32 = box_3.last_0.x;
    var _S147 : u32 = box_3.first_2.y;
    var _S148 : i32 = summed_0(&((*tables_4)), _S145, _S146, _S147);
    var _S149 : u32 = box_3.first_2.x;
    var _S150 : i32 = summed_0(&((*tables_4)), _S145, _S149, _S147);
    var _S151 : i32 = _S148 - _S150;
    var _S152 : u32 = box_3.last_0.y;
    var _S153 : i32 = summed_0(&((*tables_4)), _S145, _S146, _S152);
    var _S154 : i32 = summed_0(&((*tables_4)), _S145, _S149, _S152);
    var total_4 : f32 = f32(_S153 - _S154 - _S151);
    var _S155 : f32 = box_3.turns_2.x;
    var _S156 : bool = _S155 > 0.0f;
    var total_5 : f32;
    if(_S156)
    {
        var _S157 : i32 = summed_0(&((*tables_4)), _S145, _S143, _S152);
        var _S158 : i32 = summed_0(&((*tables_4)), _S145, _S143, _S147);
        total_5 = total_4 + _S155 * f32(_S157 - _S158);
    }
    else
    {
        total_5 = total_4;
    }
    var _S159 : f32 = box_3.turns_2.y;
    var _S160 : bool = _S159 > 0.0f;
    if(_S160)
    {
        var _S161 : i32 = summed_0(&((*tables_4)), _S145, _S146, _S144);
        var _S162 : i32 = summed_0(&((*tables_4)), _S145, _S149, _S144);
        total_5 = total_5 + _S159 * f32(_S161 - _S162);
    }
    if((_S156 & (_S160)))
    {
        var _S163 : f32 = _S155 * _S159;
        var _S164 : i32 = summed_0(&((*tables_4)), _S145, _S143, _S144);
        total_5 = total_5 + _S163 * f32(_S164);
    }
    return total_5 / (box_3.extent_0.x * box_3.extent_0.y);
}

fn parallax_offset_0( tables_5 : ptr<function, Clustered_std430_0>,  below_1 : TexelBox_0,  face_5 : u32,  view_1 : vec3<f32>) -> vec2<f32>
{
    var _S165 : f32 = view_1.z;
    var _S166 : f32 = max(1.0f - _S165 * _S165, 9.999999960041972e-13f);
    var _S167 : f32 = max(_S165, 0.60000002384185791f);
    var _S168 : f32 = sqrt((1.0f - _S167 * _S167) / _S166) / _S167;
    var _S169 : f32 = (_S167 - 0.60000002384185791f) * 2.5000002384185791f;
    var _S170 : vec2<f32> = view_1.xy;
    var _S171 : BinTaps_0 = bin_taps_0(vec3<f32>(_S170 * vec2<f32>(sqrt(max(1.0f - _S169 * _S169, 0.0f) / _S166)), _S169), u32(16));
    var _S172 : u32 = face_5 * u32(256);
    var _S173 : u32 = (*tables_5).channels_0 - u32(4);
    var _S174 : u32 = (*tables_5).heights_0;
    var _S175 : f32 = BinTaps_read_0(_S171, (*tables_5).heights_0, _S172, u32(5), u32(0));
    var number_2 : u32 = u32(0);
    var height_2 : f32 = _S175;
    for(;;)
    {
        if(number_2 < u32(4))
        {
        }
        else
        {
            break;
        }
        var _S176 : f32 = box_mean_2(&((*tables_5)), below_1, face_5, _S173 + number_2);
        var height_3 : f32 = height_2 + _S176 * BinTaps_read_0(_S171, _S174, _S172, u32(5), u32(1) + number_2);
        number_2 = number_2 + u32(1);
        height_2 = height_3;
    }
    return _S170 * vec2<f32>((_S168 * height_2));
}

struct Yarns_0
{
     warp_1 : vec4<f32>,
     weft_1 : vec4<f32>,
     shares_0 : vec3<f32>,
};

fn Yarns_x24init_0( warp_2 : vec4<f32>,  weft_2 : vec4<f32>,  shares_1 : vec3<f32>) -> Yarns_0
{
    var _S177 : Yarns_0;
    _S177.warp_1 = warp_2;
    _S177.weft_1 = weft_2;
    _S177.shares_0 = shares_1;
    return _S177;
}

fn irregular_over_0( family_9 : u32,  key_4 : u32,  place_2 : f32,  width_2 : f32,  along_1 : f32,  length_0 : f32) -> vec4<f32>
{
    var _S178 : f32 = max(width_2, 0.0625f);
    var _S179 : f32 = min(_S178, 64.0f);
    var _S180 : f32 = max(length_0 / 2.0f, 1.0f);
    var _S181 : f32 = along_1 / 2.0f - 0.5f * _S180;
    var _S182 : f32 = 0.5f * _S179;
    var _S183 : vec2<f32> = floor(vec2<f32>(place_2 - _S182, place_2 + _S182) / vec2<f32>(64.0f));
    var _S184 : vec4<f32> = vec4<f32>(0.0f);
    var number_3 : u32 = u32(0);
    var sums_2 : vec4<f32> = _S184;
    for(;;)
    {
        if(number_3 < u32(6))
        {
        }
        else
        {
            break;
        }
        var _S185 : bool = number_3 >= u32(3);
        var _S186 : u32 = select(number_3, number_3 - u32(3), _S185);
        var _S187 : f32 = select(-1.0f, 1.0f, _S185);
        var _S188 : f32 = _S183.y;
        var _S189 : f32 = _S183.x;
        var _S190 : f32 = select(_S189, _S188, _S185);
        var _S191 : f32 = place_2 + _S187 * 0.5f * _S179 - 64.0f * _S190;
        var _S192 : f32 = clamp(floor(_S191), 0.0f, 63.0f);
        var _S193 : f32 = _S191 - _S192;
        var _S194 : f32 = select(select(64.0f, 0.0f, _S185), _S192 + f32(_S186), _S186 < u32(2));
        var _S195 : f32 = _S187 * select(select(select(0.0f, -1.0f, _S189 != _S188), _S193, _S186 == u32(1)), 1.0f - _S193, _S186 == u32(0));
        if(_S195 == 0.0f)
        {
            number_3 = number_3 + u32(1);
            continue;
        }
        var _S196 : u32 = hash_bits_0(key_4, u32(i32(_S190)));
        sums_2 = sums_2 + vec4<f32>(_S195) * irregular_integral_0(family_9, ((_S196 & (u32(127)))) + u32(_S194), _S181 + f32((_S196 >> (u32(22)))), _S180);
        number_3 = number_3 + u32(1);
    }
    return sums_2 * irregular_units_0(family_9) * vec4<f32>((sqrt(_S179 / _S178) / (_S179 * _S180)));
}

fn shown_of_covers_0( covers_0 : vec2<f32>,  warp_on_top_1 : f32) -> vec3<f32>
{
    var _S197 : f32 = covers_0.x;
    var _S198 : f32 = covers_0.y;
    return vec3<f32>(_S197 * (1.0f - _S198 * (1.0f - warp_on_top_1)), _S198 * (1.0f - _S197 * warp_on_top_1), (1.0f - _S197) * (1.0f - _S198));
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
    var _S199 : Albedos_0;
    _S199.diffuse_reflect_0 = diffuse_reflect_1;
    _S199.diffuse_transmit_0 = diffuse_transmit_1;
    _S199.specular_reflect_0 = specular_reflect_1;
    _S199.specular_transmit_0 = specular_transmit_1;
    return _S199;
}

struct FamilyAlbedos_0
{
     warp_3 : Albedos_0,
     weft_3 : Albedos_0,
};

fn FamilyAlbedos_x24init_0( warp_4 : Albedos_0,  weft_4 : Albedos_0) -> FamilyAlbedos_0
{
    var _S200 : FamilyAlbedos_0;
    _S200.warp_3 = warp_4;
    _S200.weft_3 = weft_4;
    return _S200;
}

struct Plane_0
{
     warp_5 : u32,
     weft_5 : u32,
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

fn plane_at_0( first_5 : u32) -> Plane_0
{
    var record_1 : Plane_0;
    record_1.warp_5 = words_0[first_5];
    record_1.weft_5 = words_0[first_5 + u32(1)];
    record_1.run_words_1 = words_0[first_5 + u32(2)];
    record_1.ends_2 = words_0[first_5 + u32(3)];
    record_1.end_numbers_0 = words_0[first_5 + u32(4)];
    record_1.pick_numbers_0 = words_0[first_5 + u32(5)];
    record_1.max_heights_1 = words_0[first_5 + u32(6)];
    record_1.max_height_columns_1 = words_0[first_5 + u32(7)];
    record_1.height_low_1 = (bitcast<f32>((words_0[first_5 + u32(8)])));
    record_1.height_high_1 = (bitcast<f32>((words_0[first_5 + u32(9)])));
    record_1.front_level_0 = (bitcast<f32>((words_0[first_5 + u32(10)])));
    record_1.back_level_0 = (bitcast<f32>((words_0[first_5 + u32(11)])));
    record_1.start_x_0 = (bitcast<f32>((words_0[first_5 + u32(12)])));
    record_1.start_y_0 = (bitcast<f32>((words_0[first_5 + u32(13)])));
    record_1.fine_x_0 = (bitcast<f32>((words_0[first_5 + u32(14)])));
    record_1.fine_y_0 = (bitcast<f32>((words_0[first_5 + u32(15)])));
    return record_1;
}

struct Bound_0
{
     thread_3 : u32,
     turns_3 : f32,
     cell_5 : f32,
     visible_0 : f32,
     width_3 : f32,
     gap_0 : f32,
};

fn bound_at_0( family_10 : u32,  position_5 : f32) -> Bound_0
{
    var _S201 : Cell_0 = locate_0(family_10, position_5);
    var _S202 : f32 = table_number_0(families_0[family_10].before_0 + u32(2) * _S201.thread_1 + u32(1));
    var bound_0 : Bound_0;
    bound_0.thread_3 = _S201.thread_1;
    bound_0.turns_3 = round((position_5 - families_0[family_10].start_0 - _S202 - _S201.below_0) * families_0[family_10].inverse_period_0);
    bound_0.cell_5 = _S201.below_0;
    var _S203 : f32 = 2.0f * _S201.half_width_1;
    bound_0.width_3 = _S203;
    bound_0.visible_0 = clamp((_S201.across_0 + _S201.half_width_1) / _S203, 0.0f, 1.0f);
    bound_0.gap_0 = min(_S201.below_0, _S201.below_0 - _S201.across_0 - _S201.half_width_1) + max(_S201.across_0 - _S201.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
     low_0 : Bound_0,
     high_0 : Bound_0,
};

fn stretch_of_0( family_11 : u32,  centre_1 : f32,  size_4 : f32) -> Stretch_0
{
    var _S204 : f32 = centre_1 - floor((centre_1 - families_0[family_11].start_0) * families_0[family_11].inverse_period_0) * families_0[family_11].period_0;
    var _S205 : f32 = 0.5f * max(size_4, families_0[family_11].smallest_box_0);
    var stretch_0 : Stretch_0;
    stretch_0.low_0 = bound_at_0(family_11, _S204 - _S205);
    stretch_0.high_0 = bound_at_0(family_11, _S204 + _S205);
    return stretch_0;
}

fn table_colour_0( index_3 : u32) -> vec3<f32>
{
    return vec3<f32>(table_number_0(index_3), table_number_0(index_3 + u32(1)), table_number_0(index_3 + u32(2)));
}

fn table_albedos_0( row_2 : u32) -> Albedos_0
{
    var albedos_0 : Albedos_0;
    albedos_0.diffuse_reflect_0 = table_colour_0(row_2);
    albedos_0.diffuse_transmit_0 = table_colour_0(row_2 + u32(3));
    albedos_0.specular_reflect_0 = table_colour_0(row_2 + u32(6));
    albedos_0.specular_transmit_0 = table_colour_0(row_2 + u32(9));
    return albedos_0;
}

fn Stretch_turns_0( this_2 : Stretch_0) -> f32
{
    return this_2.high_0.turns_3 - this_2.low_0.turns_3;
}

fn lengths_0( family_12 : u32,  stretch_1 : Stretch_0) -> vec3<f32>
{
    var _S206 : f32 = Stretch_turns_0(stretch_1);
    var _S207 : u32 = families_0[family_12].before_0 + u32(2) * stretch_1.low_0.thread_3;
    var _S208 : u32 = families_0[family_12].before_0 + u32(2) * stretch_1.high_0.thread_3;
    var _S209 : f32 = table_number_0(_S208) - table_number_0(_S207);
    var _S210 : f32 = table_number_0(_S208 + u32(1)) - table_number_0(_S207 + u32(1));
    return vec3<f32>(_S209 + stretch_1.high_0.visible_0 * stretch_1.high_0.width_3 - stretch_1.low_0.visible_0 * stretch_1.low_0.width_3 + _S206 * families_0[family_12].visible_total_0, _S210 - _S209 + stretch_1.high_0.gap_0 - stretch_1.low_0.gap_0 + _S206 * (families_0[family_12].period_0 - families_0[family_12].visible_total_0), _S210 + stretch_1.high_0.cell_5 - stretch_1.low_0.cell_5 + _S206 * families_0[family_12].period_0);
}

fn integrals_along_0( family_13 : u32,  stretch_2 : Stretch_0,  quantity_0 : u32) -> vec2<f32>
{
    var _S211 : u32 = u32(3) * families_0[family_13].quantities_0;
    var _S212 : u32 = families_0[family_13].colour_threads_0 + _S211 * stretch_2.low_0.thread_3 + quantity_0;
    var _S213 : u32 = families_0[family_13].colour_threads_0 + _S211 * stretch_2.high_0.thread_3 + quantity_0;
    var _S214 : u32 = families_0[family_13].colour_threads_0 + _S211 * u32(families_0[family_13].count_0) + quantity_0;
    var _S215 : f32 = table_number_0(_S212);
    var _S216 : f32 = table_number_0(_S213);
    var _S217 : f32 = Stretch_turns_0(stretch_2);
    var _S218 : u32 = u32(2) * families_0[family_13].quantities_0;
    return vec2<f32>(table_number_0(_S213 + families_0[family_13].quantities_0) - table_number_0(_S212 + families_0[family_13].quantities_0) + _S216 * stretch_2.high_0.visible_0 * stretch_2.high_0.width_3 - _S215 * stretch_2.low_0.visible_0 * stretch_2.low_0.width_3 + _S217 * table_number_0(_S214 + families_0[family_13].quantities_0), table_number_0(_S213 + _S218) - table_number_0(_S212 + _S218) + _S216 * stretch_2.high_0.cell_5 - _S215 * stretch_2.low_0.cell_5 + _S217 * table_number_0(_S214 + _S218));
}

fn Stretch_wraps_0( this_3 : Stretch_0) -> bool
{
    return (this_3.high_0.thread_3) < (this_3.low_0.thread_3);
}

fn Stretch_differences_0( this_4 : Stretch_0,  entries_0 : vec4<u32>,  whole_0 : u32) -> vec4<u32>
{
    var _S219 : u32 = entries_0.z;
    var _S220 : u32 = entries_0.x;
    return vec4<u32>(_S219 - _S220 + select(u32(0), whole_0, Stretch_wraps_0(this_4)), entries_0.w - _S219, entries_0.y - _S220, whole_0);
}

fn row_differences_0( across_1 : Stretch_0,  row_3 : u32,  count_1 : u32,  quantities_1 : u32) -> vec4<u32>
{
    var _S221 : u32 = row_3 + across_1.low_0.thread_3 * quantities_1;
    var _S222 : u32 = row_3 + across_1.high_0.thread_3 * quantities_1;
    return Stretch_differences_0(across_1, vec4<u32>(words_0[_S221], words_0[_S221 + quantities_1], words_0[_S222], words_0[_S222 + quantities_1]), words_0[row_3 + count_1 * quantities_1]);
}

fn Stretch_weights_0( this_5 : Stretch_0) -> vec4<f32>
{
    return vec4<f32>(1.0f, this_5.high_0.visible_0, - this_5.low_0.visible_0, Stretch_turns_0(this_5) - select(0.0f, 1.0f, Stretch_wraps_0(this_5)));
}

fn integral_on_top_0( family_14 : u32,  across_2 : Stretch_0,  along_2 : Stretch_0,  crossing_count_0 : u32,  quantity_1 : u32) -> f32
{
    var _S223 : u32 = u32(families_0[family_14].count_0);
    var _S224 : u32 = (_S223 + u32(1)) * families_0[family_14].quantities_0;
    var _S225 : u32 = families_0[family_14].colour_areas_0 + quantity_1;
    var _S226 : vec4<u32> = row_differences_0(across_2, _S225 + along_2.low_0.thread_3 * _S224, _S223, families_0[family_14].quantities_0);
    var _S227 : vec4<u32> = row_differences_0(across_2, _S225 + along_2.high_0.thread_3 * _S224, _S223, families_0[family_14].quantities_0);
    var _S228 : vec4<u32> = row_differences_0(across_2, _S225 + crossing_count_0 * _S224, _S223, families_0[family_14].quantities_0);
    var _S229 : vec4<f32> = Stretch_weights_0(across_2);
    return dot(vec4<f32>(dot(vec4<f32>(vec4<i32>(_S227 - _S226 + select_vector_3(Stretch_wraps_0(along_2), _S228, vec4<u32>(vec4<i32>(i32(0)))))), _S229), dot(vec4<f32>(vec4<i32>(row_differences_0(across_2, _S225 + (along_2.high_0.thread_3 + u32(1)) * _S224, _S223, families_0[family_14].quantities_0) - _S227)), _S229), dot(vec4<f32>(vec4<i32>(row_differences_0(across_2, _S225 + (along_2.low_0.thread_3 + u32(1)) * _S224, _S223, families_0[family_14].quantities_0) - _S226)), _S229), dot(vec4<f32>(vec4<i32>(_S228)), _S229)), Stretch_weights_0(along_2)) * families_0[family_14].area_unit_0;
}

fn with_added_albedos_0( albedos_1 : Albedos_0,  weight_0 : f32,  row_4 : u32) -> Albedos_0
{
    var _S230 : Albedos_0 = table_albedos_0(row_4);
    var sum_0 : Albedos_0;
    var _S231 : vec3<f32> = vec3<f32>(weight_0);
    sum_0.diffuse_reflect_0 = albedos_1.diffuse_reflect_0 + _S231 * _S230.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_1.diffuse_transmit_0 + _S231 * _S230.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_1.specular_reflect_0 + _S231 * _S230.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_1.specular_transmit_0 + _S231 * _S230.specular_transmit_0;
    return sum_0;
}

fn mean_albedos_0( family_15 : u32,  crossing_0 : u32,  own_0 : Stretch_0,  other_0 : Stretch_0,  back_3 : bool) -> Albedos_0
{
    var albedos_2 : Albedos_0 = table_albedos_0(families_0[family_15].colour_mean_0);
    if((families_0[family_15].quantities_0) == u32(1))
    {
        return albedos_2;
    }
    var _S232 : vec3<f32> = lengths_0(crossing_0, other_0);
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
        var _S233 : vec2<f32> = integrals_along_0(family_15, own_0, quantity_2);
        var _S234 : f32 = integral_on_top_0(family_15, own_0, other_0, u32(families_0[crossing_0].count_0), quantity_2);
        var _S235 : f32 = _S233.x;
        var _S236 : f32 = _S235 * _S232.x;
        var _S237 : f32 = select(_S234, _S236 - _S234, back_3);
        var _S238 : bool = quantity_2 == u32(0);
        if(_S238)
        {
            is_exposed_0 = _S237 > (16.0f * families_0[family_15].area_unit_0 * min(_S236 / families_0[family_15].crossing_area_0, 1.0f) + 0.00000999999974738f * _S236);
        }
        var _S239 : f32 = _S235 * _S232.y + select(0.0f, _S237, is_exposed_0) + 0.000244140625f * _S232.z * _S233.y;
        if(_S238)
        {
            weight_1 = 1.0f / max(_S239, 9.99999968265522539e-21f);
        }
        else
        {
            albedos_2 = with_added_albedos_0(albedos_2, _S239 * weight_1, families_0[family_15].colour_axes_0 + u32(12) * (quantity_2 - u32(1)));
        }
        quantity_2 = quantity_2 + u32(1);
    }
    albedos_2.diffuse_reflect_0 = saturate(albedos_2.diffuse_reflect_0);
    albedos_2.diffuse_transmit_0 = saturate(albedos_2.diffuse_transmit_0);
    albedos_2.specular_reflect_0 = saturate(albedos_2.specular_reflect_0);
    albedos_2.specular_transmit_0 = saturate(albedos_2.specular_transmit_0);
    return albedos_2;
}

fn albedos_in_0( plane_0 : Plane_0,  centre_2 : vec2<f32>,  size_5 : vec2<f32>,  back_4 : bool) -> FamilyAlbedos_0
{
    var _S240 : Stretch_0 = stretch_of_0(plane_0.warp_5, centre_2.x - plane_0.start_x_0, size_5.x);
    var _S241 : Stretch_0 = stretch_of_0(plane_0.weft_5, centre_2.y - plane_0.start_y_0, size_5.y);
    var albedos_3 : FamilyAlbedos_0;
    albedos_3.warp_3 = mean_albedos_0(plane_0.warp_5, plane_0.weft_5, _S240, _S241, back_4);
    albedos_3.weft_3 = mean_albedos_0(plane_0.weft_5, plane_0.warp_5, _S241, _S240, back_4);
    return albedos_3;
}

struct PlaneShares_0
{
     area_0 : f32,
     passed_0 : vec3<f32>,
     added_0 : vec3<f32>,
};

fn PlaneShares_x24init_0( area_1 : f32,  passed_1 : vec3<f32>,  added_1 : vec3<f32>) -> PlaneShares_0
{
    var _S242 : PlaneShares_0;
    _S242.area_0 = area_1;
    _S242.passed_0 = passed_1;
    _S242.added_0 = added_1;
    return _S242;
}

fn with_shares_at_0( sums_3 : PlaneShares_0,  share_1 : f32,  first_6 : u32) -> PlaneShares_0
{
    var result_0 : PlaneShares_0;
    result_0.area_0 = sums_3.area_0 + share_1 * table_number_0(first_6);
    var _S243 : vec3<f32> = vec3<f32>(share_1);
    result_0.passed_0 = sums_3.passed_0 + _S243 * vec3<f32>(table_number_0(first_6 + u32(1)), table_number_0(first_6 + u32(2)), table_number_0(first_6 + u32(3)));
    result_0.added_0 = sums_3.added_0 + _S243 * vec3<f32>(table_number_0(first_6 + u32(4)), table_number_0(first_6 + u32(5)), table_number_0(first_6 + u32(6)));
    return result_0;
}

fn with_plane_0( sums_4 : Albedos_0,  albedos_4 : Albedos_0,  shares_2 : PlaneShares_0) -> Albedos_0
{
    var result_1 : Albedos_0;
    var _S244 : vec3<f32> = vec3<f32>(shares_2.area_0);
    result_1.diffuse_reflect_0 = sums_4.diffuse_reflect_0 + _S244 * albedos_4.diffuse_reflect_0 + shares_2.added_0;
    result_1.diffuse_transmit_0 = sums_4.diffuse_transmit_0 + shares_2.passed_0 * albedos_4.diffuse_transmit_0;
    result_1.specular_reflect_0 = sums_4.specular_reflect_0 + _S244 * albedos_4.specular_reflect_0;
    result_1.specular_transmit_0 = sums_4.specular_transmit_0 + shares_2.passed_0 * albedos_4.specular_transmit_0;
    return result_1;
}

fn divided_0( sums_5 : Albedos_0,  area_2 : f32) -> Albedos_0
{
    var result_2 : Albedos_0;
    var _S245 : vec3<f32> = vec3<f32>((1.0f / max(area_2, 9.99999997475242708e-07f)));
    result_2.diffuse_reflect_0 = sums_5.diffuse_reflect_0 * _S245;
    result_2.diffuse_transmit_0 = sums_5.diffuse_transmit_0 * _S245;
    result_2.specular_reflect_0 = sums_5.specular_reflect_0 * _S245;
    result_2.specular_transmit_0 = sums_5.specular_transmit_0 * _S245;
    return result_2;
}

fn tinted_0( albedos_5 : Albedos_0,  tint_0 : vec3<f32>) -> Albedos_0
{
    var result_3 : Albedos_0 = albedos_5;
    result_3.diffuse_reflect_0 = result_3.diffuse_reflect_0 * tint_0;
    result_3.diffuse_transmit_0 = result_3.diffuse_transmit_0 * tint_0;
    return result_3;
}

struct FaceRadiance_0
{
     warp_6 : vec3<f32>,
     weft_6 : vec3<f32>,
     mean_0 : vec3<f32>,
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

fn face_radiance_0( sends_0 : FaceSends_0,  open_of_other_0 : f32,  passed_2 : vec3<f32>,  from_other_0 : vec3<f32>) -> FaceRadiance_0
{
    var _S246 : vec3<f32> = vec3<f32>((1.0f - open_of_other_0)) * passed_2;
    var found_0 : FaceRadiance_0;
    var _S247 : vec3<f32> = sends_0.sky_warp_0 + _S246 * sends_0.crossing_warp_0;
    found_0.warp_6 = _S247;
    var _S248 : vec3<f32> = sends_0.sky_weft_0 + _S246 * sends_0.crossing_weft_0;
    found_0.weft_6 = _S248;
    found_0.mean_0 = vec3<f32>(sends_0.blocks_warp_0) * _S247 + vec3<f32>(sends_0.blocks_weft_0) * _S248;
    found_0.leaked_0 = from_other_0;
    return found_0;
}

fn view_terms_0( view_2 : vec3<f32>,  terms_0 : ptr<function, array<f32, i32(6)>>)
{
    var _S249 : f32 = 1.0f - view_2.z;
    var _S250 : f32 = _S249 * _S249;
    (*terms_0)[i32(0)] = 1.0f;
    var _S251 : f32 = view_2.x;
    var _S252 : f32 = _S251 * _S251;
    var _S253 : f32 = view_2.y;
    var _S254 : f32 = _S253 * _S253;
    (*terms_0)[i32(1)] = sqrt(max(_S252 + _S254, 9.999999960041972e-13f));
    (*terms_0)[i32(2)] = _S250;
    (*terms_0)[i32(3)] = _S250 * _S250;
    (*terms_0)[i32(4)] = _S252 - _S254;
    (*terms_0)[i32(5)] = 0.0f;
    return;
}

struct Bounced_0
{
     reflected_0 : vec3<f32>,
     transmitted_0 : vec3<f32>,
     is_covered_0 : bool,
};

struct Blocked_0
{
     by_warp_0 : f32,
     by_weft_0 : f32,
     far_0 : f32,
};

struct Scattered_0
{
     back_5 : vec3<f32>,
     through_0 : vec3<f32>,
};

struct Interior_0
{
     warp_7 : vec3<f32>,
     weft_7 : vec3<f32>,
     leaked_1 : vec3<f32>,
     far_1 : vec3<f32>,
     far_leaked_0 : vec3<f32>,
};

fn bounced_by_0( blocked_0 : Blocked_0,  yarn_0 : Scattered_0,  interior_0 : Interior_0) -> Bounced_0
{
    var _S255 : vec3<f32> = vec3<f32>((blocked_0.by_warp_0 + blocked_0.by_weft_0)) * interior_0.leaked_1;
    var _S256 : vec3<f32> = vec3<f32>(blocked_0.far_0) * yarn_0.through_0;
    var bounced_0 : Bounced_0;
    bounced_0.reflected_0 = yarn_0.back_5 * (vec3<f32>(blocked_0.by_warp_0) * interior_0.warp_7 + vec3<f32>(blocked_0.by_weft_0) * interior_0.weft_7) + _S256 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S256 * interior_0.far_1 + yarn_0.back_5 * _S255;
    bounced_0.is_covered_0 = false;
    return bounced_0;
}

fn texel_along_0( share_2 : f32,  first_7 : u32,  extent_1 : f32,  count_2 : u32) -> u32
{
    var _S257 : f32 = min(floor(share_2 * extent_1), extent_1 - 1.0f);
    var _S258 : f32 = f32(count_2);
    var _S259 : u32 = first_7 + min(u32(max(_S257 - floor(_S257 / _S258) * _S258, 0.0f)), count_2 - u32(1));
    return select(_S259, _S259 - count_2, _S259 >= count_2);
}

fn texel_of_0( tables_6 : ptr<function, Clustered_std430_0>,  box_4 : TexelBox_0,  share_3 : vec2<f32>) -> u32
{
    return texel_along_0(share_3.y, box_4.first_2.y, box_4.extent_0.y, (*tables_6).rows_0) * (*tables_6).columns_0 + texel_along_0(share_3.x, box_4.first_2.x, box_4.extent_0.x, (*tables_6).columns_0);
}

fn uniform_hash_0( thread_4 : u32,  cell_6 : u32,  stream_1 : u32) -> f32
{
    return (f32(((hash_bits_0(hash_key_0(thread_4, stream_1), cell_6)) >> (u32(9)))) + 0.5f) * 1.1920928955078125e-07f;
}

fn pixel_sequence_0( pixel_0 : vec2<u32>,  index_4 : u32,  stream_2 : u32) -> vec2<f32>
{
    var _S260 : u32 = pixel_0.x;
    var _S261 : u32 = pixel_0.y;
    return fract(vec2<f32>(uniform_hash_0(_S260, _S261, stream_2), uniform_hash_0(_S260, _S261, stream_2 + u32(1))) + vec2<f32>(f32((index_4 & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
}

fn scene_number_0( index_5 : u32) -> f32
{
    return (bitcast<f32>((scene_words_0[index_5])));
}

struct Choice_0
{
     index_6 : u32,
     remainder_0 : f32,
};

fn choose_0( table_1 : u32,  count_3 : u32,  number_4 : f32) -> Choice_0
{
    var high_1 : u32 = count_3;
    var low_1 : u32 = u32(0);
    for(;;)
    {
        if((high_1 - low_1) > u32(1))
        {
        }
        else
        {
            break;
        }
        var _S262 : u32 = (low_1 + high_1) / u32(2);
        if((scene_number_0(table_1 + _S262)) <= number_4)
        {
            low_1 = _S262;
        }
        else
        {
            high_1 = _S262;
        }
    }
    var _S263 : u32 = table_1 + low_1;
    var _S264 : f32 = scene_number_0(_S263);
    var _S265 : f32 = scene_number_0(_S263 + u32(1));
    var choice_0 : Choice_0;
    choice_0.index_6 = low_1;
    choice_0.remainder_0 = saturate((number_4 - _S264) / max(_S265 - _S264, 9.999999960041972e-13f));
    return choice_0;
}

fn mean_1( colour_0 : vec3<f32>) -> f32
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

fn sine_cosine_0( x_7 : f32) -> vec2<f32>
{
    var _S266 : f32 = floor(x_7 * 0.63661974668502808f + 0.5f);
    var _S267 : f32 = x_7 - _S266 * 1.5703125f - _S266 * 0.00048375129699707f - _S266 * 7.54979012640433211e-08f;
    var _S268 : f32 = _S267 * _S267;
    var _S269 : f32 = ((-0.00019515295571182f * _S268 + 0.00833216123282909f) * _S268 - 0.16666655242443085f) * _S268 * _S267 + _S267;
    var _S270 : f32 = ((0.00002443315679557f * _S268 - 0.00138873164542019f) * _S268 + 0.04166664555668831f) * _S268 * _S268 - 0.5f * _S268 + 1.0f;
    var _S271 : u32 = (u32(i32(_S266)) & (u32(3)));
    var _S272 : vec2<f32> = select_vector_1(((_S271 & (u32(1)))) != u32(0), vec2<f32>(_S270, _S269), vec2<f32>(_S269, _S270));
    var _S273 : f32 = _S272.x;
    var _S274 : f32 = _S272.y;
    return vec2<f32>(select(_S273, - _S273, ((_S271 & (u32(2)))) != u32(0)), select(_S274, - _S274, (((_S271 + u32(1)) & (u32(2)))) != u32(0)));
}

struct Light_0
{
     is_point_0 : u32,
     x_8 : f32,
     y_2 : f32,
     z_1 : f32,
     red_0 : f32,
     green_0 : f32,
     blue_0 : f32,
};

fn scene_light_0( first_8 : u32) -> Light_0
{
    var record_2 : Light_0;
    record_2.is_point_0 = scene_words_0[first_8];
    record_2.x_8 = (bitcast<f32>((scene_words_0[first_8 + u32(1)])));
    record_2.y_2 = (bitcast<f32>((scene_words_0[first_8 + u32(2)])));
    record_2.z_1 = (bitcast<f32>((scene_words_0[first_8 + u32(3)])));
    record_2.red_0 = (bitcast<f32>((scene_words_0[first_8 + u32(4)])));
    record_2.green_0 = (bitcast<f32>((scene_words_0[first_8 + u32(5)])));
    record_2.blue_0 = (bitcast<f32>((scene_words_0[first_8 + u32(6)])));
    return record_2;
}

struct BaseTaps_0
{
     facing_0 : vec3<f32>,
     transmits_1 : bool,
     around_0 : BinTaps_0,
     first_9 : u32,
     half_vector_0 : BinTaps_0,
};

struct ViewedBase_0
{
     view_3 : vec3<f32>,
     back_6 : bool,
     face_6 : u32,
     box_5 : TexelBox_0,
};

fn base_taps_0( seen_0 : ViewedBase_0,  light_1 : vec3<f32>) -> BaseTaps_0
{
    var taps_1 : BaseTaps_0;
    var _S275 : vec3<f32> = to_face_frame_0(light_1, seen_0.back_6);
    taps_1.facing_0 = _S275;
    var _S276 : f32 = _S275.z;
    var _S277 : bool = _S276 < 0.0f;
    taps_1.transmits_1 = _S277;
    taps_1.around_0 = bin_taps_0(vec3<f32>(_S275.xy, abs(_S276)), u32(32));
    taps_1.first_9 = (seen_0.face_6 * u32(2) + select(u32(0), u32(1), _S277)) * u32(1024);
    var _S278 : vec3<f32> = _S275 + seen_0.view_3;
    var half_vector_1 : vec3<f32> = _S278 * vec3<f32>((1.0f / sqrt(max(square_0(_S278), 9.999999960041972e-13f))));
    taps_1.half_vector_0 = bin_taps_0(select_vector_2((half_vector_1.z) < 0.0f, (vec3<f32>(0) - half_vector_1), half_vector_1), u32(32));
    return taps_1;
}

struct Components_0
{
     diffuse_warp_0 : f32,
     diffuse_weft_0 : f32,
     specular_warp_0 : f32,
     specular_weft_0 : f32,
     light_visibility_1 : f32,
     hole_0 : f32,
};

fn no_components_0() -> Components_0
{
    var nothing_0 : Components_0;
    nothing_0.diffuse_warp_0 = 0.0f;
    nothing_0.diffuse_weft_0 = 0.0f;
    nothing_0.specular_warp_0 = 0.0f;
    nothing_0.specular_weft_0 = 0.0f;
    nothing_0.light_visibility_1 = 0.0f;
    nothing_0.hole_0 = 0.0f;
    return nothing_0;
}

fn clustered_cosine_0( taps_2 : BaseTaps_0,  normal_1 : vec3<f32>) -> f32
{
    var _S279 : f32 = 0.0078740157186985f * dot(normal_1, taps_2.facing_0);
    return select(_S279, - _S279, taps_2.transmits_1);
}

fn projected_area_1( direction_3 : vec3<f32>,  tangent_0 : vec3<f32>,  roughness_1 : f32) -> f32
{
    var _S280 : f32 = dot(direction_3, tangent_0);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S280 * _S280 + 1.0f, roughness_1 * roughness_1));
}

fn of_family_0( is_warp_0 : bool,  diffuse_0 : f32,  specular_0 : f32,  light_visibility_2 : f32) -> Components_0
{
    var result_4 : Components_0 = no_components_0();
    result_4.diffuse_warp_0 = select(0.0f, diffuse_0, is_warp_0);
    result_4.diffuse_weft_0 = select(diffuse_0, 0.0f, is_warp_0);
    result_4.specular_warp_0 = select(0.0f, specular_0, is_warp_0);
    result_4.specular_weft_0 = select(specular_0, 0.0f, is_warp_0);
    result_4.light_visibility_1 = light_visibility_2;
    return result_4;
}

fn with_added_0( sums_6 : Components_0,  more_0 : Components_0,  weight_2 : f32) -> Components_0
{
    var result_5 : Components_0;
    result_5.diffuse_warp_0 = sums_6.diffuse_warp_0 + weight_2 * more_0.diffuse_warp_0;
    result_5.diffuse_weft_0 = sums_6.diffuse_weft_0 + weight_2 * more_0.diffuse_weft_0;
    result_5.specular_warp_0 = sums_6.specular_warp_0 + weight_2 * more_0.specular_warp_0;
    result_5.specular_weft_0 = sums_6.specular_weft_0 + weight_2 * more_0.specular_weft_0;
    result_5.light_visibility_1 = sums_6.light_visibility_1 + weight_2 * more_0.light_visibility_1;
    result_5.hole_0 = sums_6.hole_0 + weight_2 * more_0.hole_0;
    return result_5;
}

fn fourth_power_0( value_1 : f32) -> f32
{
    var _S281 : f32 = value_1 * value_1;
    return _S281 * _S281;
}

fn bounced_value_0( bounced_1 : Bounced_0,  light_2 : vec3<f32>,  view_4 : vec3<f32>) -> vec3<f32>
{
    var _S282 : f32 = light_2.z;
    return select_vector_2((_S282 * view_4.z) < 0.0f, bounced_1.transmitted_0, bounced_1.reflected_0) * vec3<f32>((abs(_S282) * 0.31830987334251404f));
}

fn sheen_scale_0( x_9 : f32,  y_3 : f32) -> f32
{
    return (((((0.0f * x_9 + (((((-1.1402510404586792f * y_3 + 0.40672621130943298f) * y_3 + 1.65398800373077393f) * y_3 + -1.29730904102325439f) * y_3 + 0.30570998787879944f) * y_3 + -0.0220868494361639f)) * x_9 + (((((-0.21142719686031342f * y_3 + 1.05947399139404297f) * y_3 + -0.41116121411323547f) * y_3 + -0.93859231472015381f) * y_3 + 0.51606941223144531f) * y_3 + 0.05409301072359085f)) * x_9 + (((((1.22944498062133789f * y_3 + -0.45962560176849365f) * y_3 + -1.63861405849456787f) * y_3 + 1.33565104007720947f) * y_3 + -0.45725581049919128f) * y_3 + 0.08243165910243988f)) * x_9 + (((((0.39779931306838989f * y_3 + -1.18879103660583496f) * y_3 + 0.28251591324806213f) * y_3 + 1.168984055519104f) * y_3 + -0.76864629983901978f) * y_3 + 0.0091691892594099f)) * x_9 + (((((-0.26563560962677002f * y_3 + -0.19379159808158875f) * y_3 + 0.2677634060382843f) * y_3 + 0.00270519289188087f) * y_3 + 0.14349560439586639f) * y_3 + 0.10290180146694183f)) * x_9 + (((((-0.20701569318771362f * y_3 + 0.24526430666446686f) * y_3 + 0.19551840424537659f) * y_3 + 0.07586126774549484f) * y_3 + 0.38894739747047424f) * y_3 + 0.15043120086193085f);
}

fn sheen_shear_0( x_10 : f32,  y_4 : f32) -> f32
{
    return ((((0.0f * x_10 + (((((-0.10608240216970444f * y_4 + 1.99214303493499756f) * y_4 + -1.42255294322967529f) * y_4 + -1.09495604038238525f) * y_4 + 0.59180057048797607f) * y_4 + 0.06902855634689331f)) * x_10 + (((((-0.46220690011978149f * y_4 + -0.29113379120826721f) * y_4 + 1.39025199413299561f) * y_4 + 0.35589990019798279f) * y_4 + -1.17120099067687988f) * y_4 + 0.15940259397029877f)) * x_10 + (((((2.26068711280822754f * y_4 + -3.64728999137878418f) * y_4 + -0.72173482179641724f) * y_4 + 3.07659196853637695f) * y_4 + -0.6827620267868042f) * y_4 + -0.3039557933807373f)) * x_10 + (((((0.81201767921447754f * y_4 + 0.36014080047607422f) * y_4 + -1.72646903991699219f) * y_4 + -0.22630110383033752f) * y_4 + 0.89514690637588501f) * y_4 + -0.10397960245609283f)) * x_10 + (((((-0.37648698687553406f * y_4 + 1.10974001884460449f) * y_4 + 0.17824520170688629f) * y_4 + -1.04968702793121338f) * y_4 + 0.1461234986782074f) * y_4 + -0.00475129019469023f);
}

fn sheen_reflectance_0( x_11 : f32,  y_5 : f32) -> f32
{
    return ((((0.0f * x_11 + (((((12.95646953582763672f * y_5 + -21.38032913208007812f) * y_5 + -7.37853097915649414f) * y_5 + 34.55607986450195312f) * y_5 + -23.61347007751464844f) * y_5 + 5.00126314163208008f)) * x_11 + (((((10.91487026214599609f * y_5 + -6.08202791213989258f) * y_5 + -38.2036285400390625f) * y_5 + 53.3440399169921875f) * y_5 + -21.91996002197265625f) * y_5 + 2.01606011390686035f)) * x_11 + (((((-14.52206039428710938f * y_5 + 36.803619384765625f) * y_5 + -22.94047927856445312f) * y_5 + -10.07973003387451172f) * y_5 + 15.77003955841064453f) * y_5 + -4.92722177505493164f)) * x_11 + (((((-7.62505722045898438f * y_5 + 1.27310299873352051f) * y_5 + 31.19523048400878906f) * y_5 + -44.39989852905273438f) * y_5 + 26.44947052001953125f) * y_5 + -8.73507976531982422f)) * x_11 + (((((5.65633487701416016f * y_5 + -17.66820907592773438f) * y_5 + 24.65356063842773438f) * y_5 + -19.38941001892089844f) * y_5 + 11.06159019470214844f) * y_5 + -3.06573700904846191f);
}

fn sheen_lobe_0( cos_view_0 : f32,  roughness_2 : f32) -> vec3<f32>
{
    var _S283 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S284 : f32 = 2.0f * sqrt(_S283) - 1.0f;
    var _S285 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_2, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S284, _S285), 0.00999999977648258f, 1.0f), clamp((1.0f - _S283) * sheen_shear_0(_S284, _S285), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S284, _S285), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_3 : vec3<f32>,  view_5 : vec3<f32>,  scale_0 : f32,  shear_0 : f32) -> f32
{
    var _S286 : f32 = light_3.z;
    if(((_S286 <= 0.0f) | (((view_5.z) <= 0.0f))))
    {
        return 0.0f;
    }
    var _S287 : vec2<f32> = view_5.xy;
    var _S288 : f32 = dot(_S287, _S287);
    var _S289 : vec2<f32> = select_vector_1(_S288 > 9.99999968265522539e-21f, _S287 * vec2<f32>(rsqrt_0(max(_S288, 9.99999968265522539e-21f))), vec2<f32>(1.0f, 0.0f));
    var _S290 : f32 = scale_0 * dot(light_3.xy, _S289) + shear_0 * _S286;
    var _S291 : f32 = scale_0 * (light_3.y * _S289.x - light_3.x * _S289.y);
    var _S292 : f32 = _S290 * _S290 + _S291 * _S291 + _S286 * _S286;
    return 0.31830987334251404f * scale_0 * scale_0 * _S286 / max(_S292 * _S292, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_4 : vec3<f32>,  view_6 : vec3<f32>,  strength_0 : f32,  roughness_3 : f32) -> vec2<f32>
{
    var _S293 : vec3<f32> = sheen_lobe_0(view_6.z, roughness_3);
    var _S294 : f32 = strength_0 * _S293.z;
    return vec2<f32>(_S294 * transformed_cosine_0(light_4, view_6, _S293.x, _S293.y), 1.0f - _S294);
}

fn table_byte_0( table_2 : u32,  index_7 : u32) -> u32
{
    return (((words_0[table_2 + index_7 / u32(4)] >> ((u32(8) * ((index_7 & (u32(3)))))))) & (u32(255)));
}

fn gaussian_visibility_0( row_5 : u32,  towards_0 : vec3<f32>) -> f32
{
    var _S295 : f32 = dot(towards_0, vec3<f32>(table_number_0(row_5 + u32(3)), table_number_0(row_5 + u32(4)), table_number_0(row_5 + u32(5))));
    var _S296 : f32 = dot(towards_0, vec3<f32>(table_number_0(row_5 + u32(6)), table_number_0(row_5 + u32(7)), table_number_0(row_5 + u32(8))));
    return min(max(dot(towards_0, vec3<f32>(table_number_0(row_5), table_number_0(row_5 + u32(1)), table_number_0(row_5 + u32(2)))), 0.0f) * exponential_0(- (_S295 * _S295 + _S296 * _S296)), 1.0f);
}

fn accumulate_0( index_8 : u32,  light_5 : vec4<f32>)
{
    var _S297 : f32 = layers_0[index_8].share_0;
    radiance_0[index_8] = radiance_0[index_8] + vec4<f32>(layers_0[index_8].share_0) * light_5;
    layers_0[index_8].share_0 = _S297 * (1.0f - light_5.w);
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

fn uneven_shift_0( _S298 : u32,  _S299 : u32,  _S300 : u32,  _S301 : vec2<f32>) -> f32
{
    var _S302 : f32 = families_0[_S300].period_0 / families_0[_S300].count_0;
    var _S303 : u32 = hash_key_0(_S299, ((fabrics_0[_S298].seed_0) ^ (u32(625341585))));
    var _S304 : vec2<f32> = vec2<f32>(_S301.x, _S301.y / 4.0f) / vec2<f32>(_S302);
    return 0.20000000298023224f * sqrt(families_0[_S300].slub_0) * _S302 * (uneven_octave_0(_S303, _S304) * 0.66666668653488159f + uneven_octave_0(_S303 + u32(1), vec2<f32>(2.0f) * _S304 + vec2<f32>(0.5f, 0.0f)) / 3.0f);
}

fn uneven_place_0( _S305 : u32,  _S306 : vec2<f32>) -> vec2<f32>
{
    return select_vector_1((fabrics_0[_S305].has_detail_0) == u32(0), _S306, _S306 + vec2<f32>(uneven_shift_0(_S305, u32(0), fabrics_0[_S305].warp_0, _S306), uneven_shift_0(_S305, u32(1), fabrics_0[_S305].weft_0, _S306.yx)));
}

fn face_point_0( _S307 : u32,  _S308 : u32,  _S309 : f32,  _S310 : f32) -> VisiblePoint_0
{
    var _S311 : u32 = u32(3) * _S308;
    var _S312 : Vertex_0 = vertex_at_0(_S311);
    var _S313 : Vertex_0 = vertex_at_0(_S311 + u32(1));
    var _S314 : Vertex_0 = vertex_at_0(_S311 + u32(2));
    var _S315 : vec3<f32> = position_of_0(_S312);
    var _S316 : vec3<f32> = position_of_0(_S313) - _S315;
    var _S317 : vec3<f32> = position_of_0(_S314) - _S315;
    var _S318 : f32 = _S313.u_0 - _S312.u_0;
    var _S319 : f32 = _S313.v_0 - _S312.v_0;
    var _S320 : vec2<f32> = vec2<f32>(_S318, _S319);
    var _S321 : f32 = _S314.u_0 - _S312.u_0;
    var _S322 : f32 = _S314.v_0 - _S312.v_0;
    var _S323 : vec2<f32> = vec2<f32>(_S321, _S322);
    var _S324 : vec3<f32> = vec3<f32>(select(1.0f, -1.0f, (_S318 * _S322 - _S319 * _S321) < 0.0f));
    var _S325 : vec3<f32> = _S324 * (vec3<f32>(_S322) * _S316 - vec3<f32>(_S319) * _S317);
    var _S326 : vec3<f32> = _S324 * (vec3<f32>(_S318) * _S317 - vec3<f32>(_S321) * _S316);
    var point_1 : VisiblePoint_0;
    var _S327 : vec3<f32> = vec3<f32>(_S309);
    var _S328 : vec3<f32> = vec3<f32>(_S310);
    var _S329 : vec3<f32> = normalize(vec3<f32>((1.0f - _S309 - _S310)) * normal_of_0(_S312) + _S327 * normal_of_0(_S313) + _S328 * normal_of_0(_S314));
    point_1.normal_0 = _S329;
    var _S330 : vec3<f32> = normalize(_S325 - _S329 * vec3<f32>(dot(_S329, _S325)));
    point_1.axis_x_0 = _S330;
    point_1.axis_y_0 = cross(_S329, _S330);
    var _S331 : vec3<f32> = normalize(cross(_S316, _S317));
    point_1.face_normal_0 = select_vector_2((dot(_S331, _S329)) < 0.0f, (vec3<f32>(0) - _S331), _S331);
    point_1.position_4 = _S315 + _S327 * _S316 + _S328 * _S317;
    point_1.view_0 = _S329;
    var _S332 : vec2<f32> = vec2<f32>(_S312.u_0, _S312.v_0) + vec2<f32>(_S309) * _S320 + vec2<f32>(_S310) * _S323;
    point_1.uv_1 = _S332;
    var _S333 : bool = (dot(cross(_S325, _S326), _S329)) < 0.0f;
    var _S334 : vec2<f32> = vec2<f32>(fabrics_0[_S307].uv_width_0, select(fabrics_0[_S307].uv_height_0, - fabrics_0[_S307].uv_height_0, _S333));
    point_1.draft_per_uv_0 = _S334;
    point_1.draft_0 = uneven_place_0(_S307, _S332 * _S334 + vec2<f32>(0.0f, select(0.0f, fabrics_0[_S307].uv_height_0, _S333)));
    var _S335 : vec2<f32> = vec2<f32>(0.0f);
    point_1.draft_dx_0 = _S335;
    point_1.draft_dy_0 = _S335;
    return point_1;
}

fn visible_point_0( _S336 : u32,  _S337 : u32,  _S338 : vec2<u32>) -> VisiblePoint_0
{
    var _S339 : u32 = u32(3) * _S337;
    var _S340 : Vertex_0 = vertex_at_0(_S339);
    var _S341 : Vertex_0 = vertex_at_0(_S339 + u32(1));
    var _S342 : Vertex_0 = vertex_at_0(_S339 + u32(2));
    var _S343 : vec3<f32> = position_of_0(_S340);
    var _S344 : vec3<f32> = position_of_0(_S341) - _S343;
    var _S345 : vec3<f32> = position_of_0(_S342) - _S343;
    var _S346 : vec3<f32> = cross(_S344, _S345);
    var _S347 : f32 = f32(frame_record_0.width_0);
    var _S348 : vec3<f32> = camera_right_0() * vec3<f32>((2.0f / _S347));
    var _S349 : f32 = f32(frame_record_0.height_0);
    var _S350 : vec3<f32> = camera_up_0() * vec3<f32>((-2.0f / _S349));
    var _S351 : vec3<f32> = camera_forward_0() + vec3<f32>((f32(_S338.x) + 0.5f - 0.5f * _S347)) * _S348 + vec3<f32>((f32(_S338.y) + 0.5f - 0.5f * _S349)) * _S350;
    var _S352 : f32 = dot(_S351, _S346);
    var _S353 : f32 = 1.0f / select(1.00000000317107685e-30f, _S352, (abs(_S352)) > 1.00000000317107685e-30f);
    var _S354 : vec3<f32> = _S343 - camera_origin_0();
    var _S355 : vec3<f32> = vec3<f32>((dot(_S354, _S346) * _S353));
    var _S356 : vec3<f32> = _S351 * _S355 - _S354;
    var _S357 : vec3<f32> = _S355 * (_S348 - _S351 * vec3<f32>((dot(_S348, _S346) * _S353)));
    var _S358 : vec3<f32> = _S355 * (_S350 - _S351 * vec3<f32>((dot(_S350, _S346) * _S353)));
    var _S359 : vec3<f32> = vec3<f32>((1.0f / max(square_0(_S346), 1.00000000317107685e-30f)));
    var _S360 : vec3<f32> = cross(_S345, _S346) * _S359;
    var _S361 : vec3<f32> = cross(_S346, _S344) * _S359;
    var _S362 : vec2<f32> = vec2<f32>(_S341.u_0 - _S340.u_0, _S341.v_0 - _S340.v_0);
    var _S363 : vec2<f32> = vec2<f32>(_S342.u_0 - _S340.u_0, _S342.v_0 - _S340.v_0);
    var point_2 : VisiblePoint_0 = face_point_0(_S336, _S337, dot(_S356, _S360), dot(_S356, _S361));
    point_2.position_4 = _S343 + _S356;
    point_2.view_0 = (vec3<f32>(0) - normalize(_S351));
    point_2.draft_dx_0 = (vec2<f32>(dot(_S357, _S360)) * _S362 + vec2<f32>(dot(_S357, _S361)) * _S363) * point_2.draft_per_uv_0;
    point_2.draft_dy_0 = (vec2<f32>(dot(_S358, _S360)) * _S362 + vec2<f32>(dot(_S358, _S361)) * _S363) * point_2.draft_per_uv_0;
    return point_2;
}

fn filtered_albedo_0( _S364 : u32,  _S365 : VisiblePoint_0) -> vec3<f32>
{
    var _S366 : u32 = fabrics_0[_S364].albedo_map_levels_0;
    if((fabrics_0[_S364].albedo_map_levels_0) == u32(0))
    {
        return vec3<f32>(1.0f);
    }
    var _S367 : vec2<f32> = vec2<f32>(fabrics_0[_S364].uv_width_0, fabrics_0[_S364].uv_height_0);
    var _S368 : vec2<f32> = _S365.draft_dx_0 / _S367;
    var _S369 : vec2<f32> = _S365.draft_dy_0 / _S367;
    var _S370 : u32 = _S366 - u32(1);
    var _S371 : u32 = (u32(1) << (_S370));
    var _S372 : f32 = clamp(0.5f * binary_logarithm_0(max(abs(_S368.x * _S369.y - _S368.y * _S369.x), 9.99999968265522539e-21f) * (square_1(f32(_S371)) / 3.0f)), 0.0f, f32(_S366) - 1.0f);
    var _S373 : u32 = min(u32(_S372), max(_S366, u32(2)) - u32(2));
    var _S374 : u32 = min(_S373 + u32(1), _S370);
    var _S375 : u32 = (u32(1) << ((u32(2) * _S366)));
    return mix(map_level_0(fabrics_0[_S364].albedo_map_0 + (_S375 - ((_S375 >> ((u32(2) * _S373))))) / u32(3), (_S371 >> (_S373)), _S365.uv_1), map_level_0(fabrics_0[_S364].albedo_map_0 + (_S375 - ((_S375 >> ((u32(2) * _S374))))) / u32(3), (_S371 >> (_S374)), _S365.uv_1), vec3<f32>(((exponential_0(1.38629436492919922f * (_S372 - f32(_S373))) - 1.0f) / 3.0f)));
}

fn is_layered_0( _S376 : u32) -> bool
{
    return (HAS_LAYERS_0 & (((fabrics_0[_S376].planes_0) != u32(0))));
}

fn irregular_key_0( _S377 : u32,  _S378 : u32) -> u32
{
    return hash_key_0(_S378, ((fabrics_0[_S377].seed_0) ^ (u32(1821285621))));
}

fn irregular_place_0( _S379 : u32,  _S380 : vec2<f32>,  _S381 : f32) -> vec2<f32>
{
    var _S382 : u32 = fabrics_0[_S379].warp_0;
    var _S383 : u32 = fabrics_0[_S379].weft_0;
    var _S384 : bool = (((((fabrics_0[_S379].is_irregular_0) != u32(0)) & ((!is_layered_0(_S379))))) & (((max(moved_share_0(fabrics_0[_S379].warp_0, _S381), moved_share_0(fabrics_0[_S379].weft_0, _S381))) > 0.0f)));
    var number_5 : u32 = u32(0);
    var moved_0 : vec2<f32> = _S380;
    for(;;)
    {
        if(number_5 < select(u32(0), u32(2), _S384))
        {
        }
        else
        {
            break;
        }
        var _S385 : bool = number_5 == u32(0);
        var _S386 : u32 = select(_S383, _S382, _S385);
        var _S387 : vec2<f32> = select_vector_1(_S385, _S380, _S380.yx);
        var _S388 : u32 = irregular_key_0(_S379, number_5);
        var _S389 : f32 = _S387.x;
        var _S390 : Cell_0 = locate_0(_S386, _S389);
        var _S391 : f32 = irregular_thread_0(_S386, _S389, _S390);
        var _S392 : f32 = select(1.0f, -1.0f, (_S390.across_0) < 0.0f);
        var _S393 : vec2<f32> = vec2<f32>(0.0f);
        var other_1 : vec2<f32> = _S393;
        var own_1 : vec2<f32> = _S393;
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
            var _S394 : vec2<f32> = irregular_at_0(_S386, _S388, _S391 + _S392 * f32(neighbour_0), _S387.y).xy;
            var _S395 : u32 = neighbour_0 + u32(1);
            own_1 = other_1;
            other_1 = _S394;
            neighbour_0 = _S395;
        }
        var _S396 : f32 = _S390.below_0 + _S390.above_0;
        var _S397 : f32 = min(_S390.half_width_1 / _S396, 0.5f);
        var _S398 : f32 = min(_S397 * (2.0f + own_1.y + other_1.y), 1.0f);
        var _S399 : vec2<f32> = sqrt(max(vec2<f32>(1.0f) + vec2<f32>(own_1.x, other_1.x), vec2<f32>(0.25f)));
        var _S400 : f32 = _S399.x;
        var _S401 : f32 = _S398 * _S400 / (_S400 + _S399.y);
        var _S402 : f32 = abs(_S390.across_0) / _S396;
        var _S403 : f32 = 1.0f - _S398;
        var _S404 : f32 = _S402 - _S401;
        var _S405 : f32 = moved_share_0(_S386, _S381) * _S392 * _S396 * (select(select((_S404 - _S403) / max(_S398 - _S401, 9.99999997475242708e-07f) * _S397 + (1.0f - _S397), _S404 / max(_S403, 9.99999997475242708e-07f) * (1.0f - 2.0f * _S397) + _S397, _S404 < _S403), _S402 * _S397 / _S401, _S404 < 0.0f) - _S402);
        var moved_1 : vec2<f32> = moved_0 + select_vector_1(_S385, vec2<f32>(_S405, 0.0f), vec2<f32>(0.0f, _S405));
        number_5 = number_5 + u32(1);
        moved_0 = moved_1;
    }
    return moved_0;
}

struct ClusteredView_0
{
     base_0 : ViewedBase_0,
     yarns_0 : Yarns_0,
     even_hole_0 : f32,
     hole_1 : f32,
     albedos_6 : FamilyAlbedos_0,
     bounced_2 : Bounced_0,
     view_7 : vec3<f32>,
};

fn viewed_base_0( _S406 : u32,  _S407 : Footprint_0,  _S408 : vec3<f32>,  _S409 : f32) -> ViewedBase_0
{
    var seen_1 : ViewedBase_0;
    var _S410 : bool = (_S408.z) < 0.0f;
    seen_1.back_6 = _S410;
    var _S411 : vec3<f32> = to_face_frame_0(_S408, _S410);
    seen_1.view_3 = _S411;
    var _S412 : u32 = select(u32(0), u32(1), _S410);
    seen_1.face_6 = _S412;
    var _S413 : Clustered_std430_0 = fabrics_0[_S406].clustered_0;
    var _S414 : f32 = _S409 - 0.5f;
    var _S415 : TexelBox_0 = texel_box_0(&(_S413), _S407, vec2<f32>(0.0f), _S414);
    var _S416 : vec2<f32> = parallax_offset_0(&(_S413), _S415, _S412, _S411);
    var _S417 : TexelBox_0 = texel_box_0(&(_S413), _S407, _S416, _S414);
    seen_1.box_5 = _S417;
    return seen_1;
}

fn texel_hole_0( _S418 : u32,  _S419 : ViewedBase_0) -> f32
{
    var cluster_0 : u32 = u32(0);
    var covered_0 : f32 = 0.0f;
    for(;;)
    {
        var _S420 : Clustered_std430_0 = fabrics_0[_S418].clustered_0;
        if(cluster_0 < (_S420.clusters_0))
        {
        }
        else
        {
            break;
        }
        var _S421 : f32 = box_mean_0(&(_S420), _S419.box_5, _S419.face_6, cluster_0);
        var covered_1 : f32 = covered_0 + _S421;
        cluster_0 = cluster_0 + u32(1);
        covered_0 = covered_1;
    }
    return clamp(1.0f - covered_0, 0.0f, 1.0f);
}

fn yarns_over_0( _S422 : u32,  _S423 : Footprint_0,  _S424 : bool) -> Yarns_0
{
    var _S425 : vec2<f32> = _S423.dx_0;
    var _S426 : vec2<f32> = _S423.dy_0;
    var _S427 : vec2<f32> = sqrt(_S425 * _S425 + _S426 * _S426);
    var _S428 : f32 = Footprint_spread_side_0(_S423);
    var _S429 : vec4<f32> = vec4<f32>(0.0f);
    var yarns_1 : Yarns_0 = Yarns_x24init_0(_S429, _S429, vec3<f32>(0.0f));
    var _S430 : bool = (fabrics_0[_S422].is_irregular_0) != u32(0);
    var number_6 : u32 = u32(0);
    for(;;)
    {
        if(number_6 < select(u32(0), u32(2), _S430))
        {
        }
        else
        {
            break;
        }
        var _S431 : bool = number_6 == u32(0);
        var _S432 : u32 = select(fabrics_0[_S422].weft_0, fabrics_0[_S422].warp_0, _S431);
        var _S433 : vec2<f32> = select_vector_1(_S431, _S423.centre_0, _S423.centre_0.yx);
        var _S434 : vec2<f32> = select_vector_1(_S431, _S427, _S427.yx);
        var _S435 : f32 = _S433.x;
        var _S436 : Cell_0 = locate_0(_S432, _S435);
        var yarn_1 : vec4<f32> = irregular_over_0(_S432, irregular_key_0(_S422, number_6), irregular_thread_0(_S432, _S435, _S436) + _S436.below_0 / (_S436.below_0 + _S436.above_0), _S434.x * (families_0[_S432].count_0 / families_0[_S432].period_0), _S433.y, _S434.y);
        yarn_1[i32(1)] = yarn_1[i32(1)] * (1.0f - moved_share_0(_S432, _S428));
        yarns_1.warp_1 = yarns_1.weft_1;
        yarns_1.weft_1 = yarn_1;
        number_6 = number_6 + u32(1);
    }
    var _S437 : vec2<f32> = vec2<f32>(families_0[fabrics_0[_S422].warp_0].cover_0, families_0[fabrics_0[_S422].weft_0].cover_0);
    var _S438 : f32 = select(fabrics_0[_S422].warp_on_top_0, 1.0f - fabrics_0[_S422].warp_on_top_0, _S424);
    var _S439 : vec3<f32> = shown_of_covers_0(_S437, _S438);
    var _S440 : vec3<f32> = select_vector_2(_S430, shown_of_covers_0(saturate(_S437 + _S437 * vec2<f32>(yarns_1.warp_1.y, yarns_1.weft_1.y)), _S438) / max(_S439, vec3<f32>(0.00009999999747379f)), vec3<f32>(1.0f));
    yarns_1.shares_0 = _S440;
    yarns_1.shares_0[i32(2)] = select(1.0f, _S440.z, (_S439.z) > 0.00009999999747379f);
    return yarns_1;
}

fn plane_count_0( _S441 : u32) -> u32
{
    return select(u32(1), fabrics_0[_S441].planes_0, is_layered_0(_S441));
}

fn whole_plane_0( _S442 : u32) -> Plane_0
{
    var plane_1 : Plane_0;
    plane_1.warp_5 = fabrics_0[_S442].warp_0;
    plane_1.weft_5 = fabrics_0[_S442].weft_0;
    plane_1.run_words_1 = fabrics_0[_S442].run_words_0;
    plane_1.ends_2 = fabrics_0[_S442].ends_1;
    plane_1.end_numbers_0 = u32(0);
    plane_1.pick_numbers_0 = u32(0);
    plane_1.max_heights_1 = fabrics_0[_S442].max_heights_0;
    plane_1.max_height_columns_1 = fabrics_0[_S442].max_height_columns_0;
    plane_1.height_low_1 = fabrics_0[_S442].height_low_0;
    plane_1.height_high_1 = fabrics_0[_S442].height_high_0;
    plane_1.front_level_0 = 0.0f;
    plane_1.back_level_0 = 0.0f;
    plane_1.start_x_0 = 0.0f;
    plane_1.start_y_0 = 0.0f;
    plane_1.fine_x_0 = 0.0f;
    plane_1.fine_y_0 = 0.0f;
    return plane_1;
}

fn plane_of_0( _S443 : u32,  _S444 : u32) -> Plane_0
{
    if(!is_layered_0(_S443))
    {
        return whole_plane_0(_S443);
    }
    return plane_at_0(fabrics_0[_S443].plane_records_0 + _S444 * u32(16));
}

fn stack_share_0( _S445 : u32,  _S446 : vec2<f32>,  _S447 : vec2<f32>,  _S448 : u32) -> f32
{
    if((fabrics_0[_S445].stacks_0) == u32(1))
    {
        return 1.0f;
    }
    var _S449 : u32 = fabrics_0[_S445].plane_axes_0 + u32(1);
    var _S450 : Stretch_0 = stretch_of_0(fabrics_0[_S445].plane_axes_0, _S446.x, _S447.x);
    var _S451 : Stretch_0 = stretch_of_0(_S449, _S446.y, _S447.y);
    return clamp(integral_on_top_0(fabrics_0[_S445].plane_axes_0, _S450, _S451, u32(families_0[_S449].count_0), _S448) / (lengths_0(fabrics_0[_S445].plane_axes_0, _S450).x * lengths_0(_S449, _S451).x), 0.0f, 1.0f);
}

fn albedos_over_0( _S452 : u32,  _S453 : Footprint_0,  _S454 : bool) -> FamilyAlbedos_0
{
    var _S455 : vec2<f32> = _S453.dx_0;
    var _S456 : vec2<f32> = _S453.dy_0;
    var _S457 : vec2<f32> = sqrt(_S455 * _S455 + _S456 * _S456);
    var _S458 : vec3<f32> = vec3<f32>(0.0f);
    var _S459 : Albedos_0 = Albedos_x24init_0(_S458, _S458, _S458, _S458);
    var sums_7 : FamilyAlbedos_0 = FamilyAlbedos_x24init_0(_S459, _S459);
    var _S460 : vec2<f32> = vec2<f32>(0.0f);
    var number_7 : u32 = u32(0);
    var areas_0 : vec2<f32> = _S460;
    for(;;)
    {
        if(number_7 < (plane_count_0(_S452)))
        {
        }
        else
        {
            break;
        }
        var _S461 : FamilyAlbedos_0 = albedos_in_0(plane_of_0(_S452, number_7), _S453.centre_0, _S457, _S454);
        if(!is_layered_0(_S452))
        {
            return _S461;
        }
        var _S462 : PlaneShares_0 = PlaneShares_x24init_0(0.0f, _S458, _S458);
        var warp_8 : PlaneShares_0 = _S462;
        var weft_8 : PlaneShares_0 = _S462;
        var stack_0 : u32 = u32(0);
        for(;;)
        {
            if(stack_0 < (fabrics_0[_S452].stacks_0))
            {
            }
            else
            {
                break;
            }
            var _S463 : f32 = stack_share_0(_S452, _S453.centre_0, _S457, stack_0);
            var _S464 : u32 = fabrics_0[_S452].plane_shares_0 + u32(14) * (u32(2) * (stack_0 * fabrics_0[_S452].planes_0 + number_7) + select(u32(0), u32(1), _S454));
            var _S465 : PlaneShares_0 = with_shares_at_0(warp_8, _S463, _S464);
            var _S466 : PlaneShares_0 = with_shares_at_0(weft_8, _S463, _S464 + u32(7));
            var _S467 : u32 = stack_0 + u32(1);
            warp_8 = _S465;
            weft_8 = _S466;
            stack_0 = _S467;
        }
        sums_7.warp_3 = with_plane_0(sums_7.warp_3, _S461.warp_3, warp_8);
        sums_7.weft_3 = with_plane_0(sums_7.weft_3, _S461.weft_3, weft_8);
        var areas_1 : vec2<f32> = areas_0 + vec2<f32>(warp_8.area_0, weft_8.area_0);
        number_7 = number_7 + u32(1);
        areas_0 = areas_1;
    }
    var means_0 : FamilyAlbedos_0;
    means_0.warp_3 = divided_0(sums_7.warp_3, areas_0.x);
    means_0.weft_3 = divided_0(sums_7.weft_3, areas_0.y);
    return means_0;
}

fn toned_0( _S468 : u32,  _S469 : u32,  _S470 : Albedos_0,  _S471 : vec4<f32>) -> Albedos_0
{
    var _S472 : vec3<f32> = _S470.diffuse_reflect_0 + _S470.diffuse_transmit_0;
    var _S473 : vec3<f32> = vec3<f32>(1.0f);
    var _S474 : vec3<f32> = _S473 - vec3<f32>(fabrics_0[_S468].layer_bound_0) * max(_S470.specular_reflect_0, _S470.specular_transmit_0);
    var _S475 : vec3<f32> = vec3<f32>(0.0f);
    var _S476 : vec3<f32> = max(_S473 - _S472, _S475) / (_S473 + _S472);
    var _S477 : vec3<f32> = vec3<f32>(9.99999997475242708e-07f);
    var _S478 : vec3<f32> = (_S474 / max(_S472, _S477) - _S473) / max(vec3<f32>(0.89999997615814209f) * _S476, _S477);
    var _S479 : vec3<f32> = _S473 - vec3<f32>((saturate(min(min(_S478.x, _S478.y), _S478.z)) * _S471.z)) * _S476;
    var _S480 : vec3<f32> = min(vec3<f32>(families_0[_S469].nep_red_0, families_0[_S469].nep_green_0, families_0[_S469].nep_blue_0), _S474);
    var found_1 : Albedos_0 = _S470;
    var _S481 : f32 = _S471.w;
    var _S482 : vec3<f32> = _S479 * _S470.diffuse_transmit_0 * vec3<f32>((1.0f - _S481));
    found_1.diffuse_transmit_0 = _S482;
    found_1.diffuse_reflect_0 = clamp(mix(_S479 * _S470.diffuse_reflect_0, _S480, vec3<f32>(_S481)), _S475, max(_S474 - _S482, _S475));
    return found_1;
}

fn with_tones_0( _S483 : u32,  _S484 : FamilyAlbedos_0,  _S485 : Yarns_0) -> FamilyAlbedos_0
{
    if((fabrics_0[_S483].is_irregular_0) == u32(0))
    {
        return _S484;
    }
    var result_6 : FamilyAlbedos_0;
    result_6.warp_3 = toned_0(_S483, fabrics_0[_S483].warp_0, _S484.warp_3, _S485.warp_1);
    result_6.weft_3 = toned_0(_S483, fabrics_0[_S483].weft_0, _S484.weft_3, _S485.weft_1);
    return result_6;
}

fn openness_number_0( _S486 : u32,  _S487 : u32) -> f32
{
    return table_number_0(fabrics_0[_S486].openness_0 + _S487);
}

fn scattered_by_0( _S488 : u32,  _S489 : Albedos_0,  _S490 : u32,  _S491 : vec3<f32>) -> Scattered_0
{
    var _S492 : u32 = u32(159) + u32(2) * _S490;
    var yarn_2 : Scattered_0;
    yarn_2.back_5 = _S491 * _S489.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S488, _S492)) * _S489.specular_reflect_0;
    yarn_2.through_0 = _S491 * _S489.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S488, _S492 + u32(1))) * _S489.specular_transmit_0;
    return yarn_2;
}

fn sent_0( _S493 : u32,  _S494 : u32,  _S495 : vec3<f32>,  _S496 : vec3<f32>,  _S497 : vec3<f32>,  _S498 : vec3<f32>,  _S499 : ptr<function, vec3<f32>>,  _S500 : ptr<function, vec3<f32>>)
{
    var _S501 : u32 = u32(146) + u32(4) * _S494;
    var _S502 : f32 = openness_number_0(_S493, _S501 + u32(1));
    var _S503 : f32 = openness_number_0(_S493, _S501 + u32(2));
    var _S504 : vec3<f32> = vec3<f32>(1.0f);
    var _S505 : vec3<f32> = _S504 - _S497 * vec3<f32>(openness_number_0(_S493, _S501));
    var _S506 : vec3<f32> = _S504 - _S498 * vec3<f32>(openness_number_0(_S493, _S501 + u32(3)));
    var _S507 : vec3<f32> = _S504 / (_S505 * _S506 - _S497 * _S498 * vec3<f32>((_S502 * _S503)));
    (*_S499) = (_S495 * _S506 + _S497 * vec3<f32>(_S502) * _S496) * _S507;
    (*_S500) = (_S496 * _S505 + _S498 * vec3<f32>(_S503) * _S495) * _S507;
    return;
}

fn face_sends_0( _S508 : u32,  _S509 : u32,  _S510 : Scattered_0,  _S511 : Scattered_0) -> FaceSends_0
{
    var _S512 : u32 = u32(2) * _S509;
    var _S513 : u32 = u32(142) + _S512;
    var _S514 : f32 = openness_number_0(_S508, _S513);
    var _S515 : f32 = openness_number_0(_S508, _S513 + u32(1));
    var _S516 : vec3<f32> = vec3<f32>((1.0f - _S514)) * _S510.back_5;
    var _S517 : vec3<f32> = vec3<f32>((1.0f - _S515)) * _S511.back_5;
    var sends_1 : FaceSends_0;
    var _S518 : u32 = u32(154) + _S512;
    var _S519 : f32 = openness_number_0(_S508, _S518);
    sends_1.blocks_warp_0 = _S519;
    var _S520 : f32 = openness_number_0(_S508, _S518 + u32(1));
    sends_1.blocks_weft_0 = _S520;
    sends_1.open_0 = _S519 * _S514 + _S520 * _S515;
    var _S521 : vec3<f32> = vec3<f32>(_S514) * _S510.back_5;
    var _S522 : vec3<f32> = vec3<f32>(_S515) * _S511.back_5;
    var _S523 : vec3<f32> = sends_1.sky_warp_0;
    var _S524 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S508, _S509, _S521, _S522, _S516, _S517, &(_S523), &(_S524));
    sends_1.sky_warp_0 = _S523;
    sends_1.sky_weft_0 = _S524;
    var _S525 : vec3<f32> = sends_1.crossing_warp_0;
    var _S526 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S508, _S509, _S510.through_0, _S511.through_0, _S516, _S517, &(_S525), &(_S526));
    sends_1.crossing_warp_0 = _S525;
    sends_1.crossing_weft_0 = _S526;
    return sends_1;
}

fn interior_between_0( _S527 : u32,  _S528 : u32,  _S529 : u32,  _S530 : vec3<f32>,  _S531 : bool) -> Interior_0
{
    var _S532 : Scattered_0 = scattered_by_0(_S527, table_albedos_0(_S528), u32(0), _S530);
    var _S533 : Scattered_0 = scattered_by_0(_S527, table_albedos_0(_S529), u32(1), _S530);
    var _S534 : FaceSends_0 = face_sends_0(_S527, select(u32(0), u32(1), _S531), _S532, _S533);
    var _S535 : FaceSends_0 = face_sends_0(_S527, select(u32(1), u32(0), _S531), _S532, _S533);
    var _S536 : vec3<f32> = vec3<f32>(_S534.blocks_warp_0);
    var _S537 : vec3<f32> = vec3<f32>(_S534.blocks_weft_0);
    var _S538 : vec3<f32> = _S536 * _S534.crossing_warp_0 + _S537 * _S534.crossing_weft_0;
    var _S539 : vec3<f32> = vec3<f32>(_S535.blocks_warp_0);
    var _S540 : vec3<f32> = vec3<f32>(_S535.blocks_weft_0);
    var _S541 : vec3<f32> = _S539 * _S535.crossing_warp_0 + _S540 * _S535.crossing_weft_0;
    var _S542 : f32 = 1.0f - _S534.open_0;
    var _S543 : f32 = 1.0f - _S535.open_0;
    var _S544 : vec3<f32> = vec3<f32>(1.0f);
    var _S545 : vec3<f32> = _S544 / (_S544 - _S538 * _S541 * vec3<f32>((_S542 * _S543)));
    var _S546 : vec3<f32> = _S541 * (vec3<f32>(_S534.open_0) + vec3<f32>(_S542) * (_S536 * _S534.sky_warp_0 + _S537 * _S534.sky_weft_0)) * _S545;
    var _S547 : vec3<f32> = _S538 * (vec3<f32>(_S535.open_0) + vec3<f32>(_S543) * (_S539 * _S535.sky_warp_0 + _S540 * _S535.sky_weft_0)) * _S545;
    var _S548 : FaceRadiance_0 = face_radiance_0(_S534, _S535.open_0, _S546, _S547);
    var _S549 : FaceRadiance_0 = face_radiance_0(_S535, _S534.open_0, _S547, _S546);
    var interior_1 : Interior_0;
    interior_1.warp_7 = _S548.warp_6;
    interior_1.weft_7 = _S548.weft_6;
    interior_1.leaked_1 = _S548.leaked_0;
    interior_1.far_1 = _S549.mean_0;
    interior_1.far_leaked_0 = _S549.leaked_0;
    return interior_1;
}

fn interior_of_0( _S550 : u32,  _S551 : vec3<f32>,  _S552 : bool) -> Interior_0
{
    return interior_between_0(_S550, families_0[fabrics_0[_S550].warp_0].cloth_mean_0, families_0[fabrics_0[_S550].weft_0].cloth_mean_0, _S551, _S552);
}

fn blocked_of_terms_0( _S553 : u32,  _S554 : u32,  _S555 : array<f32, i32(6)>,  _S556 : u32) -> Blocked_0
{
    var shares_3 : array<f32, i32(3)>;
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
        shares_3[share_4] = 0.0f;
        var term_0 : u32 = u32(0);
        for(;;)
        {
            if(term_0 < _S556)
            {
            }
            else
            {
                break;
            }
            shares_3[share_4] = shares_3[share_4] + openness_number_0(_S553, _S554 + share_4 * _S556 + term_0) * _S555[term_0];
            term_0 = term_0 + u32(1);
        }
        shares_3[share_4] = saturate(shares_3[share_4]);
        share_4 = share_4 + u32(1);
    }
    var blocked_1 : Blocked_0;
    blocked_1.by_warp_0 = shares_3[i32(0)] * shares_3[i32(2)];
    blocked_1.by_weft_0 = shares_3[i32(0)] * (1.0f - shares_3[i32(2)]);
    blocked_1.far_0 = shares_3[i32(1)];
    return blocked_1;
}

fn blocked_from_0( _S557 : u32,  _S558 : vec3<f32>,  _S559 : bool,  _S560 : bool) -> Blocked_0
{
    var terms_1 : array<f32, i32(6)>;
    view_terms_0(_S558, &(terms_1));
    return blocked_of_terms_0(_S557, (select(u32(0), u32(2), _S560) + select(u32(1), u32(0), _S559)) * u32(15), terms_1, u32(5));
}

fn family_share_0( _S561 : u32,  _S562 : u32,  _S563 : f32) -> vec2<f32>
{
    var _S564 : bool = _S562 < (fabrics_0[_S561].clustered_0.clusters_0 / u32(2));
    return vec2<f32>(select(0.0f, _S563, _S564), select(_S563, 0.0f, _S564));
}

fn clustered_shown_0( _S565 : u32,  _S566 : ViewedBase_0) -> vec2<f32>
{
    var _S567 : Clustered_std430_0 = fabrics_0[_S565].clustered_0;
    var _S568 : u32 = _S567.clusters_0;
    var _S569 : vec2<f32> = vec2<f32>(0.0f);
    var cluster_1 : u32 = u32(0);
    var shown_0 : vec2<f32> = _S569;
    for(;;)
    {
        if(cluster_1 < _S568)
        {
        }
        else
        {
            break;
        }
        var _S570 : f32 = box_mean_0(&(_S567), _S566.box_5, _S566.face_6, cluster_1);
        var shown_1 : vec2<f32> = shown_0 + family_share_0(_S565, cluster_1, _S570);
        cluster_1 = cluster_1 + u32(1);
        shown_0 = shown_1;
    }
    return shown_0;
}

fn clustered_view_0( _S571 : u32,  _S572 : Footprint_0,  _S573 : vec3<f32>,  _S574 : vec3<f32>,  _S575 : u32) -> ClusteredView_0
{
    var seen_2 : ClusteredView_0;
    var _S576 : ViewedBase_0 = viewed_base_0(_S571, _S572, _S573, uniform_of_0(_S575, u32(0)));
    seen_2.base_0 = _S576;
    seen_2.view_7 = _S573;
    var _S577 : f32 = texel_hole_0(_S571, _S576);
    seen_2.even_hole_0 = _S577;
    var _S578 : Yarns_0 = yarns_over_0(_S571, _S572, seen_2.base_0.back_6);
    seen_2.yarns_0 = _S578;
    seen_2.hole_1 = min(_S577 * seen_2.yarns_0.shares_0.z, 1.0f);
    var _S579 : FamilyAlbedos_0 = with_tones_0(_S571, albedos_over_0(_S571, _S572, seen_2.base_0.back_6), _S578);
    seen_2.albedos_6.warp_3 = tinted_0(_S579.warp_3, _S574);
    seen_2.albedos_6.weft_3 = tinted_0(_S579.weft_3, _S574);
    var _S580 : vec3<f32> = vec3<f32>(0.0f);
    seen_2.bounced_2.reflected_0 = _S580;
    seen_2.bounced_2.transmitted_0 = _S580;
    if((fabrics_0[_S571].openness_0) == u32(4294967295))
    {
        return seen_2;
    }
    var _S581 : Interior_0 = interior_of_0(_S571, _S574, seen_2.base_0.back_6);
    var _S582 : Bounced_0 = bounced_by_0(blocked_from_0(_S571, seen_2.base_0.view_3, true, seen_2.base_0.back_6), scattered_by_0(_S571, _S579.warp_3, u32(0), _S574), _S581);
    var _S583 : Bounced_0 = bounced_by_0(blocked_from_0(_S571, seen_2.base_0.view_3, false, seen_2.base_0.back_6), scattered_by_0(_S571, _S579.weft_3, u32(1), _S574), _S581);
    var _S584 : vec2<f32> = clustered_shown_0(_S571, seen_2.base_0) * seen_2.yarns_0.shares_0.xy;
    var _S585 : vec3<f32> = vec3<f32>(_S584.x);
    var _S586 : vec3<f32> = vec3<f32>(_S584.y);
    seen_2.bounced_2.reflected_0 = _S585 * _S582.reflected_0 + _S586 * _S583.reflected_0;
    seen_2.bounced_2.transmitted_0 = _S585 * _S582.transmitted_0 + _S586 * _S583.transmitted_0;
    return seen_2;
}

fn residual_texel_0( _S587 : u32,  _S588 : ClusteredView_0,  _S589 : u32,  _S590 : u32) -> u32
{
    var _S591 : u32 = _S589 + _S590 * u32(1663821227);
    var _S592 : Clustered_std430_0 = fabrics_0[_S587].clustered_0;
    var _S593 : u32 = texel_of_0(&(_S592), _S588.base_0.box_5, vec2<f32>(uniform_of_0(_S591, u32(1)), uniform_of_0(_S591, u32(2))));
    return _S593;
}

fn light_sample_count_0() -> u32
{
    return frame_record_0.lights_0 + frame_record_0.environment_samples_0;
}

fn visibility_at_0( _S594 : u32,  _S595 : vec2<u32>) -> f32
{
    if((frame_record_0.casts_shadows_0) == u32(0))
    {
        return 1.0f;
    }
    return visibilities_0[(_S594 * frame_record_0.height_0 + _S595.y) * frame_record_0.width_0 + _S595.x];
}

struct LightSample_0
{
     towards_1 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_0 : f32,
};

fn environment_texel_0( _S596 : u32,  _S597 : u32) -> vec3<f32>
{
    var _S598 : u32 = frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + frame_record_0.environment_rows_0 * (frame_record_0.environment_columns_0 + u32(1)) + u32(3) * (_S596 * frame_record_0.environment_columns_0 + _S597);
    return vec3<f32>(scene_number_0(_S598), scene_number_0(_S598 + u32(1)), scene_number_0(_S598 + u32(2)));
}

fn sample_environment_0( _S599 : vec2<f32>,  _S600 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S601 : u32 = frame_record_0.environment_rows_0;
    var _S602 : Choice_0 = choose_0(frame_record_0.environment_table_0, frame_record_0.environment_rows_0, _S599.y);
    var _S603 : u32 = frame_record_0.environment_columns_0;
    var _S604 : Choice_0 = choose_0(frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + _S602.index_6 * (frame_record_0.environment_columns_0 + u32(1)), frame_record_0.environment_columns_0, _S599.x);
    var _S605 : vec3<f32> = environment_texel_0(_S602.index_6, _S604.index_6);
    (*_S600) = _S605 * vec3<f32>((frame_record_0.environment_total_0 / max(mean_1(_S605), 9.99999968265522539e-21f)));
    var _S606 : f32 = 3.14159274101257324f / f32(_S601);
    var _S607 : f32 = mix(sine_cosine_0(f32(_S602.index_6) * _S606).y, sine_cosine_0(f32(_S602.index_6 + u32(1)) * _S606).y, _S602.remainder_0);
    var _S608 : f32 = sqrt(max(1.0f - _S607 * _S607, 0.0f));
    var _S609 : vec2<f32> = sine_cosine_0((f32(_S604.index_6) + _S604.remainder_0) * (6.28318548202514648f / f32(_S603)));
    var _S610 : f32 = _S608 * _S609.x;
    var _S611 : f32 = - _S608 * _S609.y;
    return vec3<f32>(frame_record_0.environment_cosine_0 * _S610 + frame_record_0.environment_sine_0 * _S611, _S607, frame_record_0.environment_cosine_0 * _S611 - frame_record_0.environment_sine_0 * _S610);
}

fn light_sample_0( _S612 : u32,  _S613 : vec2<u32>,  _S614 : vec3<f32>) -> LightSample_0
{
    var sample_0 : LightSample_0;
    sample_0.distance_0 = 1.00000001504746622e+30f;
    var _S615 : u32 = frame_record_0.lights_0;
    if(_S612 >= (frame_record_0.lights_0))
    {
        var weight_3 : vec3<f32>;
        var _S616 : vec3<f32> = sample_environment_0(pixel_sequence_0(_S613, frame_record_0.pass_number_0 * frame_record_0.environment_samples_0 + (_S612 - _S615), u32(3)), &(weight_3));
        sample_0.towards_1 = _S616;
        sample_0.irradiance_1 = weight_3 / vec3<f32>(f32(frame_record_0.environment_samples_0));
        return sample_0;
    }
    var _S617 : Light_0 = scene_light_0(frame_record_0.light_records_0 + u32(7) * _S612);
    sample_0.irradiance_1 = vec3<f32>(_S617.red_0, _S617.green_0, _S617.blue_0);
    sample_0.towards_1 = vec3<f32>(_S617.x_8, _S617.y_2, _S617.z_1);
    if((_S617.is_point_0) != u32(0))
    {
        var _S618 : vec3<f32> = sample_0.towards_1 - _S614;
        var _S619 : f32 = max(square_0(_S618), 9.999999960041972e-13f);
        sample_0.distance_0 = sqrt(_S619);
        sample_0.irradiance_1 = sample_0.irradiance_1 / vec3<f32>(_S619);
        sample_0.towards_1 = normalize(_S618);
    }
    return sample_0;
}

fn cluster_density_0( _S620 : u32,  _S621 : ViewedBase_0,  _S622 : BaseTaps_0,  _S623 : u32,  _S624 : u32) -> f32
{
    return BinTaps_read_0(_S622.half_vector_0, fabrics_0[_S620].clustered_0.basis_0, _S621.face_6 * u32(1024), fabrics_0[_S620].clustered_0.clusters_0 * (u32(1) + fabrics_0[_S620].clustered_0.rank_0), _S624 * fabrics_0[_S620].clustered_0.clusters_0 + _S623);
}

fn cluster_visibility_0( _S625 : u32,  _S626 : BaseTaps_0,  _S627 : u32) -> f32
{
    return BinTaps_read_0(_S626.around_0, fabrics_0[_S625].clustered_0.light_0, _S626.first_9, fabrics_0[_S625].clustered_0.clusters_0, _S627);
}

fn clustered_diffuse_0( _S628 : u32,  _S629 : BaseTaps_0,  _S630 : f32,  _S631 : vec3<f32>) -> f32
{
    return 0.31830987334251404f * ((1.0f - fabrics_0[_S628].diffuse_blend_0) * abs(_S629.facing_0.z) * _S630 + fabrics_0[_S628].diffuse_blend_0 * clustered_cosine_0(_S629, _S631));
}

fn cluster_attenuation_0( _S632 : u32,  _S633 : ViewedBase_0,  _S634 : BaseTaps_0,  _S635 : u32) -> f32
{
    var _S636 : u32 = fabrics_0[_S632].clustered_0.moments_1 + (_S633.face_6 * fabrics_0[_S632].clustered_0.clusters_0 + _S635) * u32(8);
    var _S637 : vec3<f32> = vec3<f32>(table_number_0(_S636), table_number_0(_S636 + u32(1)), table_number_0(_S636 + u32(2)));
    var _S638 : vec3<f32> = vec3<f32>(table_number_0(_S636 + u32(3)), table_number_0(_S636 + u32(4)), table_number_0(_S636 + u32(5)));
    var _S639 : f32 = table_number_0(_S636 + u32(7));
    var _S640 : f32 = fabrics_0[_S632].optical_depth_0;
    var _S641 : f32 = dot(_S634.facing_0, _S637);
    var _S642 : f32 = max(dot(_S633.view_3, _S637), 0.10000000149011612f);
    var _S643 : f32 = projected_area_1(_S634.facing_0, _S638, _S639) / max(select(_S641, - _S641, _S634.transmits_1), 0.10000000149011612f);
    var _S644 : f32 = projected_area_1(_S633.view_3, _S638, _S639) / _S642;
    if(!_S634.transmits_1)
    {
        var _S645 : f32 = _S643 + _S644;
        return 0.25f * (1.0f - exponential_0(- _S640 * _S645)) / (_S645 * _S642);
    }
    var _S646 : f32 = max(_S640 * abs(_S643 - _S644), 0.00100000004749745f);
    return 0.25f * _S640 * exponential_0(- _S640 * min(_S643, _S644)) * (1.0f - exponential_0(- _S646)) / (_S646 * _S642);
}

fn clustered_base_0( _S647 : u32,  _S648 : ViewedBase_0,  _S649 : BaseTaps_0) -> Components_0
{
    var _S650 : Clustered_std430_0 = fabrics_0[_S647].clustered_0;
    var _S651 : u32 = _S650.clusters_0;
    var _S652 : u32 = _S650.rank_0;
    var base_1 : Components_0 = no_components_0();
    var cluster_2 : u32 = u32(0);
    for(;;)
    {
        if(cluster_2 < _S651)
        {
        }
        else
        {
            break;
        }
        var _S653 : f32 = box_mean_1(&(_S650), _S648.box_5, _S648.face_6, cluster_2);
        if(_S653 <= 0.0f)
        {
            cluster_2 = cluster_2 + u32(1);
            continue;
        }
        var _S654 : f32 = _S653 * cluster_density_0(_S647, _S648, _S649, cluster_2, u32(0));
        var number_8 : u32 = u32(1);
        var density_0 : f32 = _S654;
        for(;;)
        {
            if(number_8 <= _S652)
            {
            }
            else
            {
                break;
            }
            var _S655 : f32 = box_mean_1(&(_S650), _S648.box_5, _S648.face_6, number_8 * _S651 + cluster_2);
            var density_1 : f32 = density_0 + _S655 * cluster_density_0(_S647, _S648, _S649, cluster_2, number_8);
            number_8 = number_8 + u32(1);
            density_0 = density_1;
        }
        var _S656 : f32 = box_mean_1(&(_S650), _S648.box_5, _S648.face_6, (_S652 + u32(1)) * _S651 + cluster_2);
        var _S657 : f32 = box_mean_1(&(_S650), _S648.box_5, _S648.face_6, (_S652 + u32(2)) * _S651 + cluster_2);
        var _S658 : f32 = box_mean_1(&(_S650), _S648.box_5, _S648.face_6, (_S652 + u32(3)) * _S651 + cluster_2);
        var _S659 : f32 = cluster_visibility_0(_S647, _S649, cluster_2);
        base_1 = with_added_0(base_1, of_family_0(cluster_2 < (_S651 / u32(2)), _S659 * clustered_diffuse_0(_S647, _S649, _S653, vec3<f32>(_S656, _S657, _S658)), _S659 * cluster_attenuation_0(_S647, _S648, _S649, cluster_2) * density_0, _S653 * _S659), 1.0f);
        cluster_2 = cluster_2 + u32(1);
    }
    return base_1;
}

fn with_shares_0( _S660 : u32,  _S661 : Components_0,  _S662 : Yarns_0) -> Components_0
{
    var result_7 : Components_0;
    var _S663 : f32 = min(_S661.hole_0 * _S662.shares_0.z, 1.0f);
    result_7.hole_0 = _S663;
    var _S664 : f32 = _S662.shares_0.x;
    result_7.diffuse_warp_0 = _S661.diffuse_warp_0 * _S664;
    var _S665 : f32 = _S662.shares_0.y;
    result_7.diffuse_weft_0 = _S661.diffuse_weft_0 * _S665;
    result_7.specular_warp_0 = _S661.specular_warp_0 * _S664;
    result_7.specular_weft_0 = _S661.specular_weft_0 * _S665;
    result_7.light_visibility_1 = _S661.light_visibility_1 * select(1.0f, (1.0f - _S663) / max(1.0f - _S661.hole_0, 9.99999997475242708e-07f), (fabrics_0[_S660].is_irregular_0) != u32(0));
    return result_7;
}

fn as_seen_0( _S666 : u32,  _S667 : ClusteredView_0,  _S668 : Components_0) -> Components_0
{
    var whole_1 : Components_0 = _S668;
    whole_1.hole_0 = _S667.even_hole_0;
    return with_shares_0(_S666, whole_1, _S667.yarns_0);
}

fn diffuse_kept_0( _S669 : u32,  _S670 : vec3<f32>,  _S671 : vec3<f32>) -> f32
{
    return (1.0f - fabrics_0[_S669].grazing_loss_0 * fourth_power_0(max(1.0f - abs(_S670.z), 0.0f))) * (1.0f - fabrics_0[_S669].grazing_loss_0 * fourth_power_0(max(1.0f - abs(_S671.z), 0.0f)));
}

fn highlight_rise_0( _S672 : u32,  _S673 : vec3<f32>,  _S674 : vec3<f32>) -> f32
{
    var _S675 : f32 = 1.0f - sqrt(clamp(0.5f * dot(_S673, _S674) + 0.5f, 9.99999993922529029e-09f, 1.0f));
    return fabrics_0[_S672].grazing_gain_0 * fourth_power_0(_S675) * _S675;
}

fn towards_grazing_0( _S676 : u32,  _S677 : Albedos_0,  _S678 : vec3<f32>,  _S679 : vec3<f32>) -> Albedos_0
{
    var _S680 : f32 = diffuse_kept_0(_S676, _S678, _S679);
    var result_8 : Albedos_0 = _S677;
    var _S681 : vec3<f32> = vec3<f32>(_S680);
    result_8.diffuse_reflect_0 = result_8.diffuse_reflect_0 * _S681;
    result_8.diffuse_transmit_0 = result_8.diffuse_transmit_0 * _S681;
    result_8.specular_reflect_0 = result_8.specular_reflect_0 + vec3<f32>(highlight_rise_0(_S676, _S678, _S679));
    return result_8;
}

fn shaded_0( _S682 : u32,  _S683 : Components_0,  _S684 : FamilyAlbedos_0,  _S685 : vec3<f32>,  _S686 : vec3<f32>,  _S687 : bool) -> vec3<f32>
{
    var _S688 : Albedos_0 = towards_grazing_0(_S682, _S684.warp_3, _S685, _S686);
    var _S689 : Albedos_0 = towards_grazing_0(_S682, _S684.weft_3, _S685, _S686);
    if(_S687)
    {
        return _S688.diffuse_transmit_0 * vec3<f32>(_S683.diffuse_warp_0) + _S689.diffuse_transmit_0 * vec3<f32>(_S683.diffuse_weft_0) + _S688.specular_transmit_0 * vec3<f32>(_S683.specular_warp_0) + _S689.specular_transmit_0 * vec3<f32>(_S683.specular_weft_0);
    }
    return _S688.diffuse_reflect_0 * vec3<f32>(_S683.diffuse_warp_0) + _S689.diffuse_reflect_0 * vec3<f32>(_S683.diffuse_weft_0) + _S688.specular_reflect_0 * vec3<f32>(_S683.specular_warp_0) + _S689.specular_reflect_0 * vec3<f32>(_S683.specular_weft_0);
}

fn under_sheen_0( _S690 : u32,  _S691 : ClusteredView_0,  _S692 : vec3<f32>,  _S693 : f32,  _S694 : vec3<f32>) -> vec3<f32>
{
    var _S695 : f32 = fabrics_0[_S690].sheen_strength_0;
    if((fabrics_0[_S690].sheen_strength_0) <= 0.0f)
    {
        return _S692;
    }
    var _S696 : vec2<f32> = sheen_with_transmittance_0(to_face_frame_0(_S694, _S691.base_0.back_6), _S691.base_0.view_3, _S695, fabrics_0[_S690].sheen_roughness_0);
    return vec3<f32>(_S696.y) * _S692 + vec3<f32>((_S693 * _S696.x));
}

fn clustered_base_value_0( _S697 : u32,  _S698 : ClusteredView_0,  _S699 : vec3<f32>) -> vec3<f32>
{
    var _S700 : BaseTaps_0 = base_taps_0(_S698.base_0, _S699);
    var _S701 : Components_0 = as_seen_0(_S697, _S698, clustered_base_0(_S697, _S698.base_0, _S700));
    return under_sheen_0(_S697, _S698, shaded_0(_S697, _S701, _S698.albedos_6, _S699, _S698.view_7, _S700.transmits_1) + bounced_value_0(_S698.bounced_2, _S699, _S698.view_7) * vec3<f32>(diffuse_kept_0(_S697, _S699, _S698.view_7)), _S701.light_visibility_1 + _S698.hole_1, _S699);
}

struct TexelTerms_0
{
     own_2 : Components_0,
     known_0 : Components_0,
};

fn coefficient_0( _S702 : u32,  _S703 : u32,  _S704 : u32) -> f32
{
    var _S705 : i32 = i32(table_byte_0(fabrics_0[_S702].clustered_0.coefficients_0, _S703 * (fabrics_0[_S702].clustered_0.rank_0 + u32(3)) + _S704));
    return f32(select(_S705, _S705 - i32(256), _S705 > i32(127)));
}

fn at_texel_0( _S706 : u32,  _S707 : ViewedBase_0,  _S708 : u32,  _S709 : BaseTaps_0) -> TexelTerms_0
{
    var _S710 : Clustered_std430_0 = fabrics_0[_S706].clustered_0;
    var _S711 : u32 = fabrics_0[_S706].clustered_0.columns_0 * fabrics_0[_S706].clustered_0.rows_0;
    var _S712 : u32 = _S707.face_6 * _S711 + _S708;
    var _S713 : u32 = table_byte_0(fabrics_0[_S706].clustered_0.labels_0, _S712);
    var terms_2 : TexelTerms_0;
    var _S714 : Components_0 = no_components_0();
    terms_2.own_2 = _S714;
    terms_2.known_0 = _S714;
    if(_S713 >= (fabrics_0[_S706].clustered_0.clusters_0))
    {
        return terms_2;
    }
    var _S715 : f32 = cluster_density_0(_S706, _S707, _S709, _S713, u32(0));
    var number_9 : u32 = u32(1);
    var density_2 : f32 = _S715;
    for(;;)
    {
        if(number_9 <= (_S710.rank_0))
        {
        }
        else
        {
            break;
        }
        var density_3 : f32 = density_2 + coefficient_0(_S706, _S712, number_9 - u32(1)) * cluster_density_0(_S706, _S707, _S709, _S713, number_9);
        number_9 = number_9 + u32(1);
        density_2 = density_3;
    }
    var _S716 : f32 = cluster_attenuation_0(_S706, _S707, _S709, _S713) * density_2;
    var _S717 : f32 = clustered_cosine_0(_S709, vec3<f32>(coefficient_0(_S706, _S712, _S710.rank_0), coefficient_0(_S706, _S712, _S710.rank_0 + u32(1)), coefficient_0(_S706, _S712, _S710.rank_0 + u32(2))));
    var _S718 : f32 = abs(_S709.facing_0.z);
    var _S719 : f32 = gaussian_visibility_0(_S710.texels_2 + (select(_S707.face_6, u32(1) - _S707.face_6, _S709.transmits_1) * _S711 + _S708) * u32(12), vec3<f32>(_S709.facing_0.xy, _S718));
    var _S720 : f32 = 0.31830987334251404f * (1.0f - fabrics_0[_S706].diffuse_blend_0) * _S718;
    var _S721 : f32 = cluster_visibility_0(_S706, _S709, _S713);
    var _S722 : bool = _S713 < (_S710.clusters_0 / u32(2));
    var _S723 : f32 = 0.31830987334251404f * fabrics_0[_S706].diffuse_blend_0;
    terms_2.own_2 = of_family_0(_S722, _S719 * (_S720 + _S723 * max(_S717, 0.0f)), _S719 * _S716, _S719);
    terms_2.known_0 = of_family_0(_S722, _S721 * (_S720 + _S723 * _S717), _S721 * _S716, _S721);
    return terms_2;
}

fn texel_albedos_0( _S724 : u32,  _S725 : ClusteredView_0,  _S726 : u32) -> Albedos_0
{
    var _S727 : u32 = _S725.base_0.face_6 * fabrics_0[_S724].clustered_0.columns_0 * fabrics_0[_S724].clustered_0.rows_0 + _S726;
    var _S728 : bool = (table_byte_0(fabrics_0[_S724].clustered_0.labels_0, _S727)) < (fabrics_0[_S724].clustered_0.clusters_0 / u32(2));
    var _S729 : u32 = select(fabrics_0[_S724].weft_0, fabrics_0[_S724].warp_0, _S728);
    var _S730 : u32 = fabrics_0[_S724].clustered_0.texels_2 + _S727 * u32(12) + u32(9);
    var _S731 : Albedos_0 = table_albedos_0(families_0[_S729].albedo_table_0 + min(u32(table_number_0(_S730)) + u32(1024) * u32(table_number_0(_S730 + u32(1))), u32(families_0[_S729].count_0) - u32(1)) * families_0[_S729].albedo_stride_0);
    if((fabrics_0[_S724].is_irregular_0) == u32(0))
    {
        return _S731;
    }
    return toned_0(_S724, _S729, _S731, select_vector_0(_S728, _S725.yarns_0.warp_1, _S725.yarns_0.weft_1));
}

fn clustered_residual_0( _S732 : u32,  _S733 : ClusteredView_0,  _S734 : u32,  _S735 : vec3<f32>,  _S736 : vec3<f32>) -> vec3<f32>
{
    var _S737 : BaseTaps_0 = base_taps_0(_S733.base_0, _S736);
    var _S738 : TexelTerms_0 = at_texel_0(_S732, _S733.base_0, _S734, _S737);
    var own_3 : FamilyAlbedos_0;
    var _S739 : Albedos_0 = tinted_0(texel_albedos_0(_S732, _S733, _S734), _S735);
    own_3.warp_3 = _S739;
    own_3.weft_3 = _S739;
    var _S740 : Components_0 = as_seen_0(_S732, _S733, _S738.own_2);
    var _S741 : Components_0 = as_seen_0(_S732, _S733, _S738.known_0);
    return under_sheen_0(_S732, _S733, shaded_0(_S732, _S740, own_3, _S736, _S733.view_7, _S737.transmits_1) - shaded_0(_S732, _S741, _S733.albedos_6, _S736, _S733.view_7, _S737.transmits_1), _S740.light_visibility_1 - _S741.light_visibility_1, _S736);
}

fn passed_by_sheen_0( _S742 : u32,  _S743 : f32,  _S744 : vec3<f32>) -> f32
{
    var _S745 : f32 = fabrics_0[_S742].sheen_strength_0;
    if((fabrics_0[_S742].sheen_strength_0) <= 0.0f)
    {
        return _S743;
    }
    return _S743 * (1.0f - _S745 * sheen_lobe_0(abs(_S744.z), fabrics_0[_S742].sheen_roughness_0).z);
}

fn light_of_clustered_0( _S746 : u32,  _S747 : VisiblePoint_0,  _S748 : vec2<u32>,  _S749 : vec3<f32>) -> vec4<f32>
{
    var footprint_1 : Footprint_0;
    footprint_1.dx_0 = _S747.draft_dx_0;
    footprint_1.dy_0 = _S747.draft_dy_0;
    footprint_1.centre_0 = irregular_place_0(_S746, _S747.draft_0, Footprint_spread_side_0(footprint_1));
    var _S750 : vec3<f32> = to_local_0(_S747, _S747.view_0);
    var _S751 : Clustered_std430_0 = fabrics_0[_S746].clustered_0;
    var _S752 : u32 = mixed_0(mixed_0(_S748.x + u32(65536) * _S748.y) + frame_record_0.pass_number_0 * u32(2654435769));
    var _S753 : ClusteredView_0 = clustered_view_0(_S746, footprint_1, _S750, _S749, _S752);
    var _S754 : vec3<f32> = vec3<f32>(0.0f);
    var term_1 : u32 = u32(0);
    var radiance_1 : vec3<f32> = _S754;
    for(;;)
    {
        if(term_1 <= (_S751.samples_1))
        {
        }
        else
        {
            break;
        }
        var texel_0 : u32;
        if(term_1 > u32(0))
        {
            texel_0 = residual_texel_0(_S746, _S753, _S752, term_1 - u32(1));
        }
        else
        {
            texel_0 = u32(0);
        }
        var number_10 : u32 = u32(0);
        var radiance_2 : vec3<f32> = radiance_1;
        for(;;)
        {
            if(number_10 < (light_sample_count_0()))
            {
            }
            else
            {
                break;
            }
            var _S755 : f32 = visibility_at_0(number_10, _S748);
            if(_S755 <= 0.0f)
            {
                number_10 = number_10 + u32(1);
                continue;
            }
            var _S756 : LightSample_0 = light_sample_0(number_10, _S748, _S747.position_4);
            var _S757 : vec3<f32> = to_local_0(_S747, _S756.towards_1);
            var value_2 : vec3<f32>;
            if(term_1 == u32(0))
            {
                value_2 = clustered_base_value_0(_S746, _S753, _S757);
            }
            else
            {
                value_2 = clustered_residual_0(_S746, _S753, texel_0, _S749, _S757) / vec3<f32>(f32(_S751.samples_1));
            }
            radiance_2 = radiance_2 + vec3<f32>(_S755) * _S756.irradiance_1 * value_2;
            number_10 = number_10 + u32(1);
        }
        term_1 = term_1 + u32(1);
        radiance_1 = radiance_2;
    }
    return vec4<f32>(radiance_1, 1.0f - passed_by_sheen_0(_S746, _S753.hole_1, _S750));
}

@compute
@workgroup_size(8, 8, 1)
fn shade_clustered(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S758 : u32 = id_0.x;
    var _S759 : bool;
    if(_S758 >= (frame_record_0.width_0))
    {
        _S759 = true;
    }
    else
    {
        _S759 = (id_0.y) >= (frame_record_0.height_0);
    }
    if(_S759)
    {
        return;
    }
    var _S760 : u32 = id_0.y * frame_record_0.width_0 + _S758;
    var _S761 : u32 = layers_0[_S760].face_0;
    if((layers_0[_S760].face_0) == u32(0))
    {
        return;
    }
    var _S762 : u32 = _S761 - u32(1);
    var _S763 : u32 = fabric_of_0(_S762);
    var _S764 : vec2<u32> = id_0.xy;
    var _S765 : VisiblePoint_0 = visible_point_0(_S763, _S762, _S764);
    accumulate_0(_S760, light_of_clustered_0(_S763, _S765, _S764, filtered_albedo_0(_S763, _S765)));
    return;
}

