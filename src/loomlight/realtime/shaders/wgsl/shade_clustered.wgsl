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
    @align(4) hairiness_0 : f32,
};

@binding(1) @group(0) var<storage, read> families_0 : array<Family_std430_0>;

@binding(2) @group(0) var<storage, read> words_0 : array<u32>;

@binding(6) @group(0) var<storage, read_write> visibilities_0 : array<f32>;

@binding(7) @group(0) var<storage, read_write> radiance_0 : array<vec4<f32>>;

fn select_vector_0( condition_0 : bool,  yes_0 : vec2<f32>,  no_0 : vec2<f32>) -> vec2<f32>
{
    var chosen_0 : vec2<f32>;
    chosen_0[i32(0)] = select(no_0[i32(0)], yes_0[i32(0)], condition_0);
    chosen_0[i32(1)] = select(no_0[i32(1)], yes_0[i32(1)], condition_0);
    return chosen_0;
}

fn rsqrt_0( x_0 : f32) -> f32
{
    return 1.0f / sqrt(x_0);
}

fn select_vector_1( condition_1 : bool,  yes_1 : vec3<f32>,  no_1 : vec3<f32>) -> vec3<f32>
{
    var chosen_1 : vec3<f32>;
    chosen_1[i32(0)] = select(no_1[i32(0)], yes_1[i32(0)], condition_1);
    chosen_1[i32(1)] = select(no_1[i32(1)], yes_1[i32(1)], condition_1);
    chosen_1[i32(2)] = select(no_1[i32(2)], yes_1[i32(2)], condition_1);
    return chosen_1;
}

fn select_vector_2( condition_2 : bool,  yes_2 : vec4<u32>,  no_2 : vec4<u32>) -> vec4<u32>
{
    var chosen_2 : vec4<u32>;
    chosen_2[i32(0)] = select(no_2[i32(0)], yes_2[i32(0)], condition_2);
    chosen_2[i32(1)] = select(no_2[i32(1)], yes_2[i32(1)], condition_2);
    chosen_2[i32(2)] = select(no_2[i32(2)], yes_2[i32(2)], condition_2);
    chosen_2[i32(3)] = select(no_2[i32(3)], yes_2[i32(3)], condition_2);
    return chosen_2;
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

fn mixed_0( number_0 : u32) -> u32
{
    var bits_0 : u32 = ((number_0 ^ (((number_0 >> (u32(16))))))) * u32(2246822507);
    var bits_1 : u32 = ((bits_0 ^ (((bits_0 >> (u32(13))))))) * u32(3266489909);
    return (bits_1 ^ (((bits_1 >> (u32(16))))));
}

fn uniform_of_0( seed_1 : u32,  dimension_0 : u32) -> f32
{
    return f32(((mixed_0(seed_1 + (dimension_0 + u32(1)) * u32(2654435769))) >> (u32(8)))) * 5.9604644775390625e-08f;
}

fn to_face_frame_0( direction_1 : vec3<f32>,  back_2 : bool) -> vec3<f32>
{
    var _S31 : f32 = direction_1.z;
    return vec3<f32>(direction_1.xy, select(_S31, - _S31, back_2));
}

struct TexelBox_0
{
     corner_1 : vec2<f32>,
     size_1 : vec2<f32>,
     first_2 : vec2<u32>,
     extent_0 : vec2<f32>,
     last_0 : vec2<u32>,
     turns_0 : vec2<f32>,
};

struct Footprint_0
{
     centre_0 : vec2<f32>,
     dx_0 : vec2<f32>,
     dy_0 : vec2<f32>,
};

fn texel_box_0( tables_0 : ptr<function, Clustered_std430_0>,  footprint_0 : Footprint_0,  offset_1 : vec2<f32>,  place_1 : f32) -> TexelBox_0
{
    var _S32 : f32 = footprint_0.dx_0.x;
    var _S33 : f32 = footprint_0.dy_0.x;
    var _S34 : f32 = sqrt(_S32 * _S32 + _S33 * _S33);
    var _S35 : f32 = footprint_0.dx_0.y;
    var _S36 : f32 = footprint_0.dy_0.y;
    var _S37 : f32 = sqrt(_S35 * _S35 + _S36 * _S36);
    var _S38 : vec2<f32> = vec2<f32>(_S34, _S37);
    var _S39 : f32 = (_S32 * _S35 + _S33 * _S36) / max(_S34 * _S37, 1.00000000317107685e-30f);
    var _S40 : f32 = abs(_S39);
    var _S41 : f32 = place_1 * sqrt(min(_S40, 1.0f));
    var _S42 : vec2<f32> = _S38 * vec2<f32>(_S41, select(_S41, - _S41, _S39 < 0.0f));
    var _S43 : vec2<f32> = vec2<f32>((*tables_0).texel_width_0, (*tables_0).texel_height_0);
    var _S44 : u32 = (*tables_0).columns_0;
    var _S45 : u32 = (*tables_0).rows_0;
    var _S46 : vec2<f32> = vec2<f32>(f32((*tables_0).columns_0), f32((*tables_0).rows_0));
    var box_0 : TexelBox_0;
    var _S47 : vec2<f32> = _S38 * vec2<f32>(sqrt(max(1.0f - _S40, 0.0f)));
    box_0.size_1 = _S47;
    var _S48 : vec2<f32> = vec2<f32>(0.5f);
    var _S49 : vec2<f32> = _S48 * _S47;
    var _S50 : vec2<f32> = footprint_0.centre_0 + _S42 - _S49;
    box_0.corner_1 = _S50;
    var _S51 : vec2<f32> = max(round(_S47 / _S43), vec2<f32>(1.0f));
    box_0.extent_0 = _S51;
    var _S52 : vec2<f32> = round((_S50 + _S49 + offset_1) / _S43 - _S48 * _S51);
    var _S53 : vec2<f32> = vec2<f32>(0.0f);
    var _S54 : vec2<f32> = max(_S52 - floor(_S52 / _S46) * _S46, _S53);
    var _S55 : vec2<u32> = vec2<u32>(min(u32(_S54.x), (*tables_0).columns_0 - u32(1)), min(u32(_S54.y), (*tables_0).rows_0 - u32(1)));
    box_0.first_2 = _S55;
    var _S56 : vec2<f32> = floor(_S51 / _S46);
    box_0.turns_0 = _S56;
    var _S57 : vec2<f32> = max(_S51 - _S56 * _S46, _S53);
    var _S58 : vec2<u32> = _S55 + vec2<u32>(u32(_S57.x), u32(_S57.y));
    box_0.last_0 = _S58;
    if((_S58.x) >= ((*tables_0).columns_0))
    {
        box_0.last_0[i32(0)] = box_0.last_0[i32(0)] - _S44;
        box_0.turns_0[i32(0)] = box_0.turns_0[i32(0)] + 1.0f;
    }
    if((box_0.last_0.y) >= _S45)
    {
        box_0.last_0[i32(1)] = box_0.last_0[i32(1)] - _S45;
        box_0.turns_0[i32(1)] = box_0.turns_0[i32(1)] + 1.0f;
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
    var _S59 : f32 = sqrt(max(1.0f - direction_2.z, 0.0f));
    var _S60 : f32 = direction_2.x;
    var _S61 : f32 = abs(_S60);
    var _S62 : f32 = direction_2.y;
    var _S63 : f32 = abs(_S62);
    var _S64 : bool = _S61 >= _S63;
    var _S65 : f32 = _S59 * (arc_tangent_of_ratio_0(min(_S61, _S63) / max(max(_S61, _S63), 9.999999960041972e-13f)) * 1.27323949337005615f);
    var _S66 : f32 = f32(bins_2);
    var _S67 : vec2<f32> = clamp((vec2<f32>(select(1.0f, -1.0f, _S60 < 0.0f) * select(_S65, _S59, _S64), select(1.0f, -1.0f, _S62 < 0.0f) * select(_S59, _S65, _S64)) + vec2<f32>(1.0f)) * vec2<f32>((0.5f * _S66)) - vec2<f32>(0.5f), vec2<f32>(0.0f), vec2<f32>((_S66 - 1.0f)));
    var _S68 : f32 = _S67.x;
    var _S69 : u32 = bins_2 - u32(2);
    var _S70 : u32 = min(u32(_S68), _S69);
    var _S71 : f32 = _S67.y;
    var _S72 : u32 = min(u32(_S71), _S69);
    var _S73 : f32 = _S68 - f32(_S70);
    var _S74 : f32 = _S71 - f32(_S72);
    var taps_0 : BinTaps_0;
    taps_0.corner_2 = _S72 * bins_2 + _S70;
    taps_0.bins_1 = bins_2;
    var _S75 : f32 = 1.0f - _S73;
    var _S76 : f32 = 1.0f - _S74;
    taps_0.weights_0 = vec4<f32>(_S75 * _S76, _S73 * _S76, _S75 * _S74, _S73 * _S74);
    return taps_0;
}

fn table_number_0( index_1 : u32) -> f32
{
    return (bitcast<f32>((words_0[index_1])));
}

fn BinTaps_read_0( this_0 : BinTaps_0,  table_0 : u32,  first_3 : u32,  stride_0 : u32,  offset_2 : u32) -> f32
{
    var _S77 : u32 = table_0 + (first_3 + this_0.corner_2) * stride_0 + offset_2;
    return table_number_0(_S77) * this_0.weights_0.x + table_number_0(_S77 + stride_0) * this_0.weights_0.y + table_number_0(_S77 + this_0.bins_1 * stride_0) * this_0.weights_0.z + table_number_0(_S77 + (this_0.bins_1 + u32(1)) * stride_0) * this_0.weights_0.w;
}

fn summed_0( tables_1 : ptr<function, Clustered_std430_0>,  first_4 : u32,  column_0 : u32,  row_0 : u32) -> i32
{
    return i32(words_0[first_4 + (row_0 * ((*tables_1).columns_0 + u32(1)) + column_0) * (*tables_1).channels_0]);
}

fn box_mean_0( tables_2 : ptr<function, Clustered_std430_0>,  box_1 : TexelBox_0,  face_2 : u32,  channel_0 : u32) -> f32
{
    var _S78 : u32 = (*tables_2).columns_0;
    var _S79 : u32 = (*tables_2).rows_0;
    var _S80 : u32 = (*tables_2).sums_0 + face_2 * ((*tables_2).columns_0 + u32(1)) * ((*tables_2).rows_0 + u32(1)) * (*tables_2).channels_0 + channel_0;
    var _S81 : u32 = box_1.last_0.x;
    var _S82 : u32 = box_1.first_2.y;
    var _S83 : i32 = summed_0(&((*tables_2)), _S80, _S81, _S82);
    var _S84 : u32 = box_1.first_2.x;
    var _S85 : i32 = summed_0(&((*tables_2)), _S80, _S84, _S82);
    var _S86 : i32 = _S83 - _S85;
    var _S87 : u32 = box_1.last_0.y;
    var _S88 : i32 = summed_0(&((*tables_2)), _S80, _S81, _S87);
    var _S89 : i32 = summed_0(&((*tables_2)), _S80, _S84, _S87);
    var total_0 : f32 = f32(_S88 - _S89 - _S86);
    var _S90 : f32 = box_1.turns_0.x;
    var _S91 : bool = _S90 > 0.0f;
    var total_1 : f32;
    if(_S91)
    {
        var _S92 : i32 = summed_0(&((*tables_2)), _S80, _S78, _S87);
        var _S93 : i32 = summed_0(&((*tables_2)), _S80, _S78, _S82);
        total_1 = total_0 + _S90 * f32(_S92 - _S93);
    }
    else
    {
        total_1 = total_0;
    }
    var _S94 : f32 = box_1.turns_0.y;
    var _S95 : bool = _S94 > 0.0f;
    if(_S95)
    {
        var _S96 : i32 = summed_0(&((*tables_2)), _S80, _S81, _S79);
        var _S97 : i32 = summed_0(&((*tables_2)), _S80, _S84, _S79);
        total_1 = total_1 + _S94 * f32(_S96 - _S97);
    }
    if((_S91 & (_S95)))
    {
        var _S98 : f32 = _S90 * _S94;
        var _S99 : i32 = summed_0(&((*tables_2)), _S80, _S78, _S79);
        total_1 = total_1 + _S98 * f32(_S99);
    }
    return total_1 / (box_1.extent_0.x * box_1.extent_0.y);
}

fn box_mean_1( tables_3 : ptr<function, Clustered_std430_0>,  box_2 : TexelBox_0,  face_3 : u32,  channel_1 : u32) -> f32
{
    var _S100 : u32 = (*tables_3).columns_0;
    var _S101 : u32 = (*tables_3).rows_0;
    var _S102 : u32 = (*tables_3).sums_0 + face_3 * ((*tables_3).columns_0 + u32(1)) * ((*tables_3).rows_0 + u32(1)) * (*tables_3).channels_0 + channel_1;
    var _S103 : u32 = box_2.last_0.x;
    var _S104 : u32 = box_2.first_2.y;
    var _S105 : i32 = summed_0(&((*tables_3)), _S102, _S103, _S104);
    var _S106 : u32 = box_2.first_2.x;
    var _S107 : i32 = summed_0(&((*tables_3)), _S102, _S106, _S104);
    var _S108 : i32 = _S105 - _S107;
    var _S109 : u32 = box_2.last_0.y;
    var _S110 : i32 = summed_0(&((*tables_3)), _S102, _S103, _S109);
    var _S111 : i32 = summed_0(&((*tables_3)), _S102, _S106, _S109);
    var total_2 : f32 = f32(_S110 - _S111 - _S108);
    var _S112 : f32 = box_2.turns_0.x;
    var _S113 : bool = _S112 > 0.0f;
    var total_3 : f32;
    if(_S113)
    {
        var _S114 : i32 = summed_0(&((*tables_3)), _S102, _S100, _S109);
        var _S115 : i32 = summed_0(&((*tables_3)), _S102, _S100, _S104);
        total_3 = total_2 + _S112 * f32(_S114 - _S115);
    }
    else
    {
        total_3 = total_2;
    }
    var _S116 : f32 = box_2.turns_0.y;
    var _S117 : bool = _S116 > 0.0f;
    if(_S117)
    {
        var _S118 : i32 = summed_0(&((*tables_3)), _S102, _S103, _S101);
        var _S119 : i32 = summed_0(&((*tables_3)), _S102, _S106, _S101);
        total_3 = total_3 + _S116 * f32(_S118 - _S119);
    }
    if((_S113 & (_S117)))
    {
        var _S120 : f32 = _S112 * _S116;
        var _S121 : i32 = summed_0(&((*tables_3)), _S102, _S100, _S101);
        total_3 = total_3 + _S120 * f32(_S121);
    }
    return total_3 / (box_2.extent_0.x * box_2.extent_0.y);
}

fn box_mean_2( tables_4 : ptr<function, Clustered_std430_0>,  box_3 : TexelBox_0,  face_4 : u32,  channel_2 : u32) -> f32
{
    var _S122 : u32 = (*tables_4).columns_0;
    var _S123 : u32 = (*tables_4).rows_0;
    var _S124 : u32 = (*tables_4).sums_0 + face_4 * ((*tables_4).columns_0 + u32(1)) * ((*tables_4).rows_0 + u32(1)) * (*tables_4).channels_0 + channel_2;
    var _S125 : u32 = box_3.last_0.x;
    var _S126 : u32 = box_3.first_2.y;
    var _S127 : i32 = summed_0(&((*tables_4)), _S124, _S125, _S126);
    var _S128 : u32 = box_3.first_2.x;
    var _S129 : i32 = summed_0(&((*tables_4)), _S124, _S128, _S126);
    var _S130 : i32 = _S127 - _S129;
    var _S131 : u32 = box_3.last_0.y;
    var _S132 : i32 = summed_0(&((*tables_4)), _S124, _S125, _S131);
    var _S133 : i32 = summed_0(&((*tables_4)), _S124, _S128, _S131);
    var total_4 : f32 = f32(_S132 - _S133 - _S130);
    var _S134 : f32 = box_3.turns_0.x;
    var _S135 : bool = _S134 > 0.0f;
    var total_5 : f32;
    if(_S135)
    {
        var _S136 : i32 = summed_0(&((*tables_4)), _S124, _S122, _S131);
        var _S137 : i32 = summed_0(&((*tables_4)), _S124, _S122, _S126);
        total_5 = total_4 + _S134 * f32(_S136 - _S137);
    }
    else
    {
        total_5 = total_4;
    }
    var _S138 : f32 = box_3.turns_0.y;
    var _S139 : bool = _S138 > 0.0f;
    if(_S139)
    {
        var _S140 : i32 = summed_0(&((*tables_4)), _S124, _S125, _S123);
        var _S141 : i32 = summed_0(&((*tables_4)), _S124, _S128, _S123);
        total_5 = total_5 + _S138 * f32(_S140 - _S141);
    }
    if((_S135 & (_S139)))
    {
        var _S142 : f32 = _S134 * _S138;
        var _S143 : i32 = summed_0(&((*tables_4)), _S124, _S122, _S123);
        total_5 = total_5 + _S142 * f32(_S143);
    }
    return total_5 / (box_3.extent_0.x * box_3.extent_0.y);
}

fn parallax_offset_0( tables_5 : ptr<function, Clustered_std430_0>,  below_0 : TexelBox_0,  face_5 : u32,  view_1 : vec3<f32>) -> vec2<f32>
{
    var _S144 : f32 = view_1.z;
    var _S145 : f32 = max(1.0f - _S144 * _S144, 9.999999960041972e-13f);
    var _S146 : f32 = max(_S144, 0.60000002384185791f);
    var _S147 : f32 = sqrt((1.0f - _S146 * _S146) / _S145) / _S146;
    var _S148 : f32 = (_S146 - 0.60000002384185791f) * 2.5000002384185791f;
    var _S149 : vec2<f32> = view_1.xy;
    var _S150 : BinTaps_0 = bin_taps_0(vec3<f32>(_S149 * vec2<f32>(sqrt(max(1.0f - _S148 * _S148, 0.0f) / _S145)), _S148), u32(16));
    var _S151 : u32 = face_5 * u32(256);
    var _S152 : u32 = (*tables_5).channels_0 - u32(4);
    var _S153 : u32 = (*tables_5).heights_0;
    var _S154 : f32 = BinTaps_read_0(_S150, (*tables_5).heights_0, _S151, u32(5), u32(0));
    var number_1 : u32 = u32(0);
    var height_2 : f32 = _S154;
    for(;;)
    {
        if(number_1 < u32(4))
        {
        }
        else
        {
            break;
        }
        var _S155 : f32 = box_mean_2(&((*tables_5)), below_0, face_5, _S152 + number_1);
        var height_3 : f32 = height_2 + _S155 * BinTaps_read_0(_S150, _S153, _S151, u32(5), u32(1) + number_1);
        number_1 = number_1 + u32(1);
        height_2 = height_3;
    }
    return _S149 * vec2<f32>((_S147 * height_2));
}

fn turns_and_remainder_0( family_0 : u32,  index_2 : f32) -> vec2<f32>
{
    var _S156 : f32 = floor(fma(index_2, families_0[family_0].inverse_count_0, families_0[family_0].half_inverse_count_0));
    return vec2<f32>(_S156, fma(- _S156, families_0[family_0].count_0, index_2));
}

struct Cell_0
{
     thread_1 : u32,
     across_0 : f32,
     half_width_1 : f32,
     below_1 : f32,
     above_0 : f32,
};

fn locate_alike_0( family_1 : u32,  position_1 : f32) -> Cell_0
{
    var _S157 : f32 = floor(position_1 * families_0[family_1].inverse_size_0);
    var cell_2 : Cell_0;
    var _S158 : f32 = fma(- _S157, families_0[family_1].size_0, position_1);
    cell_2.below_1 = _S158;
    cell_2.above_0 = families_0[family_1].size_0 - _S158;
    cell_2.across_0 = _S158 - 0.5f * families_0[family_1].size_0;
    cell_2.half_width_1 = families_0[family_1].half_width_0;
    cell_2.thread_1 = u32(clamp(turns_and_remainder_0(family_1, _S157).y, 0.0f, families_0[family_1].count_0 - 1.0f));
    return cell_2;
}

fn locate_varied_0( family_2 : u32,  position_2 : f32) -> Cell_0
{
    var turns_1 : f32 = (position_2 - families_0[family_2].start_0) * families_0[family_2].inverse_period_0;
    var turns_2 : f32 = turns_1 - floor(turns_1);
    var _S159 : f32 = turns_2 * families_0[family_2].period_0;
    var thread_2 : u32 = words_0[families_0[family_2].first_thread_table_0 + u32(clamp(turns_2 * families_0[family_2].bins_0, 0.0f, families_0[family_2].bins_0 - 1.0f))];
    var _S160 : u32 = min(thread_2 + select(u32(0), u32(1), _S159 >= (table_number_0(families_0[family_2].place_table_0 + thread_2 * u32(4) + u32(1)))), u32(families_0[family_2].count_0) - u32(1));
    var _S161 : u32 = families_0[family_2].place_table_0 + _S160 * u32(4);
    var cell_3 : Cell_0;
    cell_3.thread_1 = _S160;
    cell_3.below_1 = _S159 - table_number_0(_S161);
    cell_3.above_0 = table_number_0(_S161 + u32(1)) - _S159;
    cell_3.across_0 = _S159 - table_number_0(_S161 + u32(2));
    cell_3.half_width_1 = table_number_0(_S161 + u32(3));
    return cell_3;
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
     thread_3 : u32,
     turns_3 : f32,
     cell_4 : f32,
     visible_0 : f32,
     width_2 : f32,
     gap_0 : f32,
};

fn bound_at_0( family_4 : u32,  position_4 : f32) -> Bound_0
{
    var _S162 : Cell_0 = locate_0(family_4, position_4);
    var _S163 : f32 = table_number_0(families_0[family_4].before_0 + u32(2) * _S162.thread_1 + u32(1));
    var bound_0 : Bound_0;
    bound_0.thread_3 = _S162.thread_1;
    bound_0.turns_3 = round((position_4 - families_0[family_4].start_0 - _S163 - _S162.below_1) * families_0[family_4].inverse_period_0);
    bound_0.cell_4 = _S162.below_1;
    var _S164 : f32 = 2.0f * _S162.half_width_1;
    bound_0.width_2 = _S164;
    bound_0.visible_0 = clamp((_S162.across_0 + _S162.half_width_1) / _S164, 0.0f, 1.0f);
    bound_0.gap_0 = min(_S162.below_1, _S162.below_1 - _S162.across_0 - _S162.half_width_1) + max(_S162.across_0 - _S162.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
     low_0 : Bound_0,
     high_0 : Bound_0,
};

fn stretch_of_0( family_5 : u32,  centre_1 : f32,  size_2 : f32) -> Stretch_0
{
    var _S165 : f32 = centre_1 - floor((centre_1 - families_0[family_5].start_0) * families_0[family_5].inverse_period_0) * families_0[family_5].period_0;
    var _S166 : f32 = 0.5f * max(size_2, families_0[family_5].smallest_box_0);
    var stretch_0 : Stretch_0;
    stretch_0.low_0 = bound_at_0(family_5, _S165 - _S166);
    stretch_0.high_0 = bound_at_0(family_5, _S165 + _S166);
    return stretch_0;
}

fn table_colour_0( index_3 : u32) -> vec3<f32>
{
    return vec3<f32>(table_number_0(index_3), table_number_0(index_3 + u32(1)), table_number_0(index_3 + u32(2)));
}

struct Albedos_0
{
     diffuse_reflect_0 : vec3<f32>,
     diffuse_transmit_0 : vec3<f32>,
     specular_reflect_0 : vec3<f32>,
     specular_transmit_0 : vec3<f32>,
};

fn table_albedos_0( row_1 : u32) -> Albedos_0
{
    var albedos_0 : Albedos_0;
    albedos_0.diffuse_reflect_0 = table_colour_0(row_1);
    albedos_0.diffuse_transmit_0 = table_colour_0(row_1 + u32(3));
    albedos_0.specular_reflect_0 = table_colour_0(row_1 + u32(6));
    albedos_0.specular_transmit_0 = table_colour_0(row_1 + u32(9));
    return albedos_0;
}

fn Stretch_turns_0( this_1 : Stretch_0) -> f32
{
    return this_1.high_0.turns_3 - this_1.low_0.turns_3;
}

fn lengths_0( family_6 : u32,  stretch_1 : Stretch_0) -> vec3<f32>
{
    var _S167 : f32 = Stretch_turns_0(stretch_1);
    var _S168 : u32 = families_0[family_6].before_0 + u32(2) * stretch_1.low_0.thread_3;
    var _S169 : u32 = families_0[family_6].before_0 + u32(2) * stretch_1.high_0.thread_3;
    var _S170 : f32 = table_number_0(_S169) - table_number_0(_S168);
    var _S171 : f32 = table_number_0(_S169 + u32(1)) - table_number_0(_S168 + u32(1));
    return vec3<f32>(_S170 + stretch_1.high_0.visible_0 * stretch_1.high_0.width_2 - stretch_1.low_0.visible_0 * stretch_1.low_0.width_2 + _S167 * families_0[family_6].visible_total_0, _S171 - _S170 + stretch_1.high_0.gap_0 - stretch_1.low_0.gap_0 + _S167 * (families_0[family_6].period_0 - families_0[family_6].visible_total_0), _S171 + stretch_1.high_0.cell_4 - stretch_1.low_0.cell_4 + _S167 * families_0[family_6].period_0);
}

fn integrals_along_0( family_7 : u32,  stretch_2 : Stretch_0,  quantity_0 : u32) -> vec2<f32>
{
    var _S172 : u32 = u32(3) * families_0[family_7].quantities_0;
    var _S173 : u32 = families_0[family_7].colour_threads_0 + _S172 * stretch_2.low_0.thread_3 + quantity_0;
    var _S174 : u32 = families_0[family_7].colour_threads_0 + _S172 * stretch_2.high_0.thread_3 + quantity_0;
    var _S175 : u32 = families_0[family_7].colour_threads_0 + _S172 * u32(families_0[family_7].count_0) + quantity_0;
    var _S176 : f32 = table_number_0(_S173);
    var _S177 : f32 = table_number_0(_S174);
    var _S178 : f32 = Stretch_turns_0(stretch_2);
    var _S179 : u32 = u32(2) * families_0[family_7].quantities_0;
    return vec2<f32>(table_number_0(_S174 + families_0[family_7].quantities_0) - table_number_0(_S173 + families_0[family_7].quantities_0) + _S177 * stretch_2.high_0.visible_0 * stretch_2.high_0.width_2 - _S176 * stretch_2.low_0.visible_0 * stretch_2.low_0.width_2 + _S178 * table_number_0(_S175 + families_0[family_7].quantities_0), table_number_0(_S174 + _S179) - table_number_0(_S173 + _S179) + _S177 * stretch_2.high_0.cell_4 - _S176 * stretch_2.low_0.cell_4 + _S178 * table_number_0(_S175 + _S179));
}

fn Stretch_wraps_0( this_2 : Stretch_0) -> bool
{
    return (this_2.high_0.thread_3) < (this_2.low_0.thread_3);
}

fn Stretch_differences_0( this_3 : Stretch_0,  entries_0 : vec4<u32>,  whole_0 : u32) -> vec4<u32>
{
    var _S180 : u32 = entries_0.z;
    var _S181 : u32 = entries_0.x;
    return vec4<u32>(_S180 - _S181 + select(u32(0), whole_0, Stretch_wraps_0(this_3)), entries_0.w - _S180, entries_0.y - _S181, whole_0);
}

fn row_differences_0( across_1 : Stretch_0,  row_2 : u32,  count_1 : u32,  quantities_1 : u32) -> vec4<u32>
{
    var _S182 : u32 = row_2 + across_1.low_0.thread_3 * quantities_1;
    var _S183 : u32 = row_2 + across_1.high_0.thread_3 * quantities_1;
    return Stretch_differences_0(across_1, vec4<u32>(words_0[_S182], words_0[_S182 + quantities_1], words_0[_S183], words_0[_S183 + quantities_1]), words_0[row_2 + count_1 * quantities_1]);
}

fn Stretch_weights_0( this_4 : Stretch_0) -> vec4<f32>
{
    return vec4<f32>(1.0f, this_4.high_0.visible_0, - this_4.low_0.visible_0, Stretch_turns_0(this_4) - select(0.0f, 1.0f, Stretch_wraps_0(this_4)));
}

fn integral_on_top_0( family_8 : u32,  across_2 : Stretch_0,  along_0 : Stretch_0,  crossing_count_0 : u32,  quantity_1 : u32) -> f32
{
    var _S184 : u32 = u32(families_0[family_8].count_0);
    var _S185 : u32 = (_S184 + u32(1)) * families_0[family_8].quantities_0;
    var _S186 : u32 = families_0[family_8].colour_areas_0 + quantity_1;
    var _S187 : vec4<u32> = row_differences_0(across_2, _S186 + along_0.low_0.thread_3 * _S185, _S184, families_0[family_8].quantities_0);
    var _S188 : vec4<u32> = row_differences_0(across_2, _S186 + along_0.high_0.thread_3 * _S185, _S184, families_0[family_8].quantities_0);
    var _S189 : vec4<u32> = row_differences_0(across_2, _S186 + crossing_count_0 * _S185, _S184, families_0[family_8].quantities_0);
    var _S190 : vec4<f32> = Stretch_weights_0(across_2);
    return dot(vec4<f32>(dot(vec4<f32>(vec4<i32>(_S188 - _S187 + select_vector_2(Stretch_wraps_0(along_0), _S189, vec4<u32>(vec4<i32>(i32(0)))))), _S190), dot(vec4<f32>(vec4<i32>(row_differences_0(across_2, _S186 + (along_0.high_0.thread_3 + u32(1)) * _S185, _S184, families_0[family_8].quantities_0) - _S188)), _S190), dot(vec4<f32>(vec4<i32>(row_differences_0(across_2, _S186 + (along_0.low_0.thread_3 + u32(1)) * _S185, _S184, families_0[family_8].quantities_0) - _S187)), _S190), dot(vec4<f32>(vec4<i32>(_S189)), _S190)), Stretch_weights_0(along_0)) * families_0[family_8].area_unit_0;
}

fn with_added_albedos_0( albedos_1 : Albedos_0,  weight_0 : f32,  row_3 : u32) -> Albedos_0
{
    var _S191 : Albedos_0 = table_albedos_0(row_3);
    var sum_0 : Albedos_0;
    var _S192 : vec3<f32> = vec3<f32>(weight_0);
    sum_0.diffuse_reflect_0 = albedos_1.diffuse_reflect_0 + _S192 * _S191.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_1.diffuse_transmit_0 + _S192 * _S191.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_1.specular_reflect_0 + _S192 * _S191.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_1.specular_transmit_0 + _S192 * _S191.specular_transmit_0;
    return sum_0;
}

fn mean_albedos_0( family_9 : u32,  crossing_0 : u32,  own_0 : Stretch_0,  other_0 : Stretch_0,  back_3 : bool) -> Albedos_0
{
    var albedos_2 : Albedos_0 = table_albedos_0(families_0[family_9].colour_mean_0);
    if((families_0[family_9].quantities_0) == u32(1))
    {
        return albedos_2;
    }
    var _S193 : vec3<f32> = lengths_0(crossing_0, other_0);
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
        var _S194 : vec2<f32> = integrals_along_0(family_9, own_0, quantity_2);
        var _S195 : f32 = integral_on_top_0(family_9, own_0, other_0, u32(families_0[crossing_0].count_0), quantity_2);
        var _S196 : f32 = _S194.x;
        var _S197 : f32 = _S196 * _S193.x;
        var _S198 : f32 = select(_S195, _S197 - _S195, back_3);
        var _S199 : bool = quantity_2 == u32(0);
        if(_S199)
        {
            is_exposed_0 = _S198 > (16.0f * families_0[family_9].area_unit_0 * min(_S197 / families_0[family_9].crossing_area_0, 1.0f) + 0.00000999999974738f * _S197);
        }
        var _S200 : f32 = _S196 * _S193.y + select(0.0f, _S198, is_exposed_0) + 0.000244140625f * _S193.z * _S194.y;
        if(_S199)
        {
            weight_1 = 1.0f / max(_S200, 9.99999968265522539e-21f);
        }
        else
        {
            albedos_2 = with_added_albedos_0(albedos_2, _S200 * weight_1, families_0[family_9].colour_axes_0 + u32(12) * (quantity_2 - u32(1)));
        }
        quantity_2 = quantity_2 + u32(1);
    }
    albedos_2.diffuse_reflect_0 = saturate(albedos_2.diffuse_reflect_0);
    albedos_2.diffuse_transmit_0 = saturate(albedos_2.diffuse_transmit_0);
    albedos_2.specular_reflect_0 = saturate(albedos_2.specular_reflect_0);
    albedos_2.specular_transmit_0 = saturate(albedos_2.specular_transmit_0);
    return albedos_2;
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
     warp_1 : vec3<f32>,
     weft_1 : vec3<f32>,
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

fn face_radiance_0( sends_0 : FaceSends_0,  open_of_other_0 : f32,  passed_0 : vec3<f32>,  from_other_0 : vec3<f32>) -> FaceRadiance_0
{
    var _S201 : vec3<f32> = vec3<f32>((1.0f - open_of_other_0)) * passed_0;
    var found_0 : FaceRadiance_0;
    var _S202 : vec3<f32> = sends_0.sky_warp_0 + _S201 * sends_0.crossing_warp_0;
    found_0.warp_1 = _S202;
    var _S203 : vec3<f32> = sends_0.sky_weft_0 + _S201 * sends_0.crossing_weft_0;
    found_0.weft_1 = _S203;
    found_0.mean_0 = vec3<f32>(sends_0.blocks_warp_0) * _S202 + vec3<f32>(sends_0.blocks_weft_0) * _S203;
    found_0.leaked_0 = from_other_0;
    return found_0;
}

fn view_terms_0( view_2 : vec3<f32>,  terms_0 : ptr<function, array<f32, i32(6)>>)
{
    var _S204 : f32 = 1.0f - view_2.z;
    var _S205 : f32 = _S204 * _S204;
    (*terms_0)[i32(0)] = 1.0f;
    var _S206 : f32 = view_2.x;
    var _S207 : f32 = _S206 * _S206;
    var _S208 : f32 = view_2.y;
    var _S209 : f32 = _S208 * _S208;
    (*terms_0)[i32(1)] = sqrt(max(_S207 + _S209, 9.999999960041972e-13f));
    (*terms_0)[i32(2)] = _S205;
    (*terms_0)[i32(3)] = _S205 * _S205;
    (*terms_0)[i32(4)] = _S207 - _S209;
    (*terms_0)[i32(5)] = 0.0f;
    return;
}

struct Bounced_0
{
     reflected_0 : vec3<f32>,
     transmitted_0 : vec3<f32>,
};

struct Blocked_0
{
     by_warp_0 : f32,
     by_weft_0 : f32,
     far_0 : f32,
};

struct Scattered_0
{
     back_4 : vec3<f32>,
     through_0 : vec3<f32>,
};

struct Interior_0
{
     warp_2 : vec3<f32>,
     weft_2 : vec3<f32>,
     leaked_1 : vec3<f32>,
     far_1 : vec3<f32>,
     far_leaked_0 : vec3<f32>,
};

fn bounced_by_0( blocked_0 : Blocked_0,  yarn_0 : Scattered_0,  interior_0 : Interior_0) -> Bounced_0
{
    var _S210 : vec3<f32> = vec3<f32>((blocked_0.by_warp_0 + blocked_0.by_weft_0)) * interior_0.leaked_1;
    var _S211 : vec3<f32> = vec3<f32>(blocked_0.far_0) * yarn_0.through_0;
    var bounced_0 : Bounced_0;
    bounced_0.reflected_0 = yarn_0.back_4 * (vec3<f32>(blocked_0.by_warp_0) * interior_0.warp_2 + vec3<f32>(blocked_0.by_weft_0) * interior_0.weft_2) + _S211 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S211 * interior_0.far_1 + yarn_0.back_4 * _S210;
    return bounced_0;
}

fn texel_along_0( share_1 : f32,  first_5 : u32,  extent_1 : f32,  count_2 : u32) -> u32
{
    var _S212 : f32 = min(floor(share_1 * extent_1), extent_1 - 1.0f);
    var _S213 : f32 = f32(count_2);
    var _S214 : u32 = first_5 + min(u32(max(_S212 - floor(_S212 / _S213) * _S213, 0.0f)), count_2 - u32(1));
    return select(_S214, _S214 - count_2, _S214 >= count_2);
}

fn texel_of_0( tables_6 : ptr<function, Clustered_std430_0>,  box_4 : TexelBox_0,  share_2 : vec2<f32>) -> u32
{
    return texel_along_0(share_2.y, box_4.first_2.y, box_4.extent_0.y, (*tables_6).rows_0) * (*tables_6).columns_0 + texel_along_0(share_2.x, box_4.first_2.x, box_4.extent_0.x, (*tables_6).columns_0);
}

fn uniform_hash_0( thread_4 : u32,  cell_5 : u32,  stream_1 : u32) -> f32
{
    return (f32(((hash_bits_0(hash_key_0(thread_4, stream_1), cell_5)) >> (u32(9)))) + 0.5f) * 1.1920928955078125e-07f;
}

fn pixel_sequence_0( pixel_0 : vec2<u32>,  index_4 : u32,  stream_2 : u32) -> vec2<f32>
{
    var _S215 : u32 = pixel_0.x;
    var _S216 : u32 = pixel_0.y;
    return fract(vec2<f32>(uniform_hash_0(_S215, _S216, stream_2), uniform_hash_0(_S215, _S216, stream_2 + u32(1))) + vec2<f32>(f32((index_4 & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
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

fn choose_0( table_1 : u32,  count_3 : u32,  number_2 : f32) -> Choice_0
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
        var _S217 : u32 = (low_1 + high_1) / u32(2);
        if((scene_number_0(table_1 + _S217)) <= number_2)
        {
            low_1 = _S217;
        }
        else
        {
            high_1 = _S217;
        }
    }
    var _S218 : u32 = table_1 + low_1;
    var _S219 : f32 = scene_number_0(_S218);
    var _S220 : f32 = scene_number_0(_S218 + u32(1));
    var choice_0 : Choice_0;
    choice_0.index_6 = low_1;
    choice_0.remainder_0 = saturate((number_2 - _S219) / max(_S220 - _S219, 9.999999960041972e-13f));
    return choice_0;
}

fn mean_1( colour_0 : vec3<f32>) -> f32
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

fn sine_cosine_0( x_7 : f32) -> vec2<f32>
{
    var _S221 : f32 = floor(x_7 * 0.63661974668502808f + 0.5f);
    var _S222 : f32 = x_7 - _S221 * 1.5703125f - _S221 * 0.00048375129699707f - _S221 * 7.54979012640433211e-08f;
    var _S223 : f32 = _S222 * _S222;
    var _S224 : f32 = ((-0.00019515295571182f * _S223 + 0.00833216123282909f) * _S223 - 0.16666655242443085f) * _S223 * _S222 + _S222;
    var _S225 : f32 = ((0.00002443315679557f * _S223 - 0.00138873164542019f) * _S223 + 0.04166664555668831f) * _S223 * _S223 - 0.5f * _S223 + 1.0f;
    var _S226 : u32 = (u32(i32(_S221)) & (u32(3)));
    var _S227 : vec2<f32> = select_vector_0(((_S226 & (u32(1)))) != u32(0), vec2<f32>(_S225, _S224), vec2<f32>(_S224, _S225));
    var _S228 : f32 = _S227.x;
    var _S229 : f32 = _S227.y;
    return vec2<f32>(select(_S228, - _S228, ((_S226 & (u32(2)))) != u32(0)), select(_S229, - _S229, (((_S226 + u32(1)) & (u32(2)))) != u32(0)));
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

fn scene_light_0( first_6 : u32) -> Light_0
{
    var record_1 : Light_0;
    record_1.is_point_0 = scene_words_0[first_6];
    record_1.x_8 = (bitcast<f32>((scene_words_0[first_6 + u32(1)])));
    record_1.y_2 = (bitcast<f32>((scene_words_0[first_6 + u32(2)])));
    record_1.z_1 = (bitcast<f32>((scene_words_0[first_6 + u32(3)])));
    record_1.red_0 = (bitcast<f32>((scene_words_0[first_6 + u32(4)])));
    record_1.green_0 = (bitcast<f32>((scene_words_0[first_6 + u32(5)])));
    record_1.blue_0 = (bitcast<f32>((scene_words_0[first_6 + u32(6)])));
    return record_1;
}

struct BaseTaps_0
{
     facing_0 : vec3<f32>,
     transmits_1 : bool,
     around_0 : BinTaps_0,
     first_7 : u32,
     half_vector_0 : BinTaps_0,
};

struct ViewedBase_0
{
     view_3 : vec3<f32>,
     back_5 : bool,
     face_6 : u32,
     box_5 : TexelBox_0,
};

fn base_taps_0( seen_0 : ViewedBase_0,  light_1 : vec3<f32>) -> BaseTaps_0
{
    var taps_1 : BaseTaps_0;
    var _S230 : vec3<f32> = to_face_frame_0(light_1, seen_0.back_5);
    taps_1.facing_0 = _S230;
    var _S231 : f32 = _S230.z;
    var _S232 : bool = _S231 < 0.0f;
    taps_1.transmits_1 = _S232;
    taps_1.around_0 = bin_taps_0(vec3<f32>(_S230.xy, abs(_S231)), u32(32));
    taps_1.first_7 = (seen_0.face_6 * u32(2) + select(u32(0), u32(1), _S232)) * u32(1024);
    var _S233 : vec3<f32> = _S230 + seen_0.view_3;
    var half_vector_1 : vec3<f32> = _S233 * vec3<f32>((1.0f / sqrt(max(square_0(_S233), 9.999999960041972e-13f))));
    taps_1.half_vector_0 = bin_taps_0(select_vector_1((half_vector_1.z) < 0.0f, (vec3<f32>(0) - half_vector_1), half_vector_1), u32(32));
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
    var _S234 : f32 = 0.0078740157186985f * dot(normal_1, taps_2.facing_0);
    return select(_S234, - _S234, taps_2.transmits_1);
}

fn projected_area_1( direction_3 : vec3<f32>,  tangent_0 : vec3<f32>,  roughness_1 : f32) -> f32
{
    var _S235 : f32 = dot(direction_3, tangent_0);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S235 * _S235 + 1.0f, roughness_1 * roughness_1));
}

fn of_family_0( is_warp_0 : bool,  diffuse_0 : f32,  specular_0 : f32,  light_visibility_2 : f32) -> Components_0
{
    var result_1 : Components_0 = no_components_0();
    result_1.diffuse_warp_0 = select(0.0f, diffuse_0, is_warp_0);
    result_1.diffuse_weft_0 = select(diffuse_0, 0.0f, is_warp_0);
    result_1.specular_warp_0 = select(0.0f, specular_0, is_warp_0);
    result_1.specular_weft_0 = select(specular_0, 0.0f, is_warp_0);
    result_1.light_visibility_1 = light_visibility_2;
    return result_1;
}

fn with_added_0( sums_1 : Components_0,  more_0 : Components_0,  weight_2 : f32) -> Components_0
{
    var result_2 : Components_0;
    result_2.diffuse_warp_0 = sums_1.diffuse_warp_0 + weight_2 * more_0.diffuse_warp_0;
    result_2.diffuse_weft_0 = sums_1.diffuse_weft_0 + weight_2 * more_0.diffuse_weft_0;
    result_2.specular_warp_0 = sums_1.specular_warp_0 + weight_2 * more_0.specular_warp_0;
    result_2.specular_weft_0 = sums_1.specular_weft_0 + weight_2 * more_0.specular_weft_0;
    result_2.light_visibility_1 = sums_1.light_visibility_1 + weight_2 * more_0.light_visibility_1;
    result_2.hole_0 = sums_1.hole_0 + weight_2 * more_0.hole_0;
    return result_2;
}

struct FamilyAlbedos_0
{
     warp_3 : Albedos_0,
     weft_3 : Albedos_0,
};

fn shaded_0( components_0 : Components_0,  albedos_4 : FamilyAlbedos_0,  transmits_2 : bool) -> vec3<f32>
{
    if(transmits_2)
    {
        return albedos_4.warp_3.diffuse_transmit_0 * vec3<f32>(components_0.diffuse_warp_0) + albedos_4.weft_3.diffuse_transmit_0 * vec3<f32>(components_0.diffuse_weft_0) + albedos_4.warp_3.specular_transmit_0 * vec3<f32>(components_0.specular_warp_0) + albedos_4.weft_3.specular_transmit_0 * vec3<f32>(components_0.specular_weft_0);
    }
    return albedos_4.warp_3.diffuse_reflect_0 * vec3<f32>(components_0.diffuse_warp_0) + albedos_4.weft_3.diffuse_reflect_0 * vec3<f32>(components_0.diffuse_weft_0) + albedos_4.warp_3.specular_reflect_0 * vec3<f32>(components_0.specular_warp_0) + albedos_4.weft_3.specular_reflect_0 * vec3<f32>(components_0.specular_weft_0);
}

fn bounced_value_0( bounced_1 : Bounced_0,  light_2 : vec3<f32>,  view_4 : vec3<f32>) -> vec3<f32>
{
    var _S236 : f32 = light_2.z;
    return select_vector_1((_S236 * view_4.z) < 0.0f, bounced_1.transmitted_0, bounced_1.reflected_0) * vec3<f32>((abs(_S236) * 0.31830987334251404f));
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
    var _S237 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S238 : f32 = 2.0f * sqrt(_S237) - 1.0f;
    var _S239 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_2, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S238, _S239), 0.00999999977648258f, 1.0f), clamp((1.0f - _S237) * sheen_shear_0(_S238, _S239), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S238, _S239), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_3 : vec3<f32>,  view_5 : vec3<f32>,  scale_0 : f32,  shear_0 : f32) -> f32
{
    var _S240 : f32 = light_3.z;
    if(((_S240 <= 0.0f) | (((view_5.z) <= 0.0f))))
    {
        return 0.0f;
    }
    var _S241 : vec2<f32> = view_5.xy;
    var _S242 : f32 = dot(_S241, _S241);
    var _S243 : vec2<f32> = select_vector_0(_S242 > 9.99999968265522539e-21f, _S241 * vec2<f32>(rsqrt_0(max(_S242, 9.99999968265522539e-21f))), vec2<f32>(1.0f, 0.0f));
    var _S244 : f32 = scale_0 * dot(light_3.xy, _S243) + shear_0 * _S240;
    var _S245 : f32 = scale_0 * (light_3.y * _S243.x - light_3.x * _S243.y);
    var _S246 : f32 = _S244 * _S244 + _S245 * _S245 + _S240 * _S240;
    return 0.31830987334251404f * scale_0 * scale_0 * _S240 / max(_S246 * _S246, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_4 : vec3<f32>,  view_6 : vec3<f32>,  strength_0 : f32,  roughness_3 : f32) -> vec2<f32>
{
    var _S247 : vec3<f32> = sheen_lobe_0(view_6.z, roughness_3);
    var _S248 : f32 = strength_0 * _S247.z;
    return vec2<f32>(_S248 * transformed_cosine_0(light_4, view_6, _S247.x, _S247.y), 1.0f - _S248);
}

fn table_byte_0( table_2 : u32,  index_7 : u32) -> u32
{
    return (((words_0[table_2 + index_7 / u32(4)] >> ((u32(8) * ((index_7 & (u32(3)))))))) & (u32(255)));
}

fn gaussian_visibility_0( row_4 : u32,  towards_0 : vec3<f32>) -> f32
{
    var _S249 : f32 = dot(towards_0, vec3<f32>(table_number_0(row_4 + u32(3)), table_number_0(row_4 + u32(4)), table_number_0(row_4 + u32(5))));
    var _S250 : f32 = dot(towards_0, vec3<f32>(table_number_0(row_4 + u32(6)), table_number_0(row_4 + u32(7)), table_number_0(row_4 + u32(8))));
    return min(max(dot(towards_0, vec3<f32>(table_number_0(row_4), table_number_0(row_4 + u32(1)), table_number_0(row_4 + u32(2)))), 0.0f) * exponential_0(- (_S249 * _S249 + _S250 * _S250)), 1.0f);
}

fn accumulate_0( index_8 : u32,  light_5 : vec4<f32>)
{
    var _S251 : f32 = layers_0[index_8].share_0;
    radiance_0[index_8] = radiance_0[index_8] + vec4<f32>(layers_0[index_8].share_0) * light_5;
    layers_0[index_8].share_0 = _S251 * (1.0f - light_5.w);
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

fn uneven_shift_0( _S252 : u32,  _S253 : u32,  _S254 : u32,  _S255 : vec2<f32>) -> f32
{
    var _S256 : f32 = families_0[_S254].period_0 / families_0[_S254].count_0;
    var _S257 : u32 = hash_key_0(_S253, ((fabrics_0[_S252].seed_0) ^ (u32(625341585))));
    var _S258 : vec2<f32> = vec2<f32>(_S255.x, _S255.y / 4.0f) / vec2<f32>(_S256);
    return 0.20000000298023224f * sqrt(families_0[_S254].slub_0) * _S256 * (uneven_octave_0(_S257, _S258) * 0.66666668653488159f + uneven_octave_0(_S257 + u32(1), vec2<f32>(2.0f) * _S258 + vec2<f32>(0.5f, 0.0f)) / 3.0f);
}

fn uneven_place_0( _S259 : u32,  _S260 : vec2<f32>) -> vec2<f32>
{
    return select_vector_0((fabrics_0[_S259].has_detail_0) == u32(0), _S260, _S260 + vec2<f32>(uneven_shift_0(_S259, u32(0), fabrics_0[_S259].warp_0, _S260), uneven_shift_0(_S259, u32(1), fabrics_0[_S259].weft_0, _S260.yx)));
}

fn face_point_0( _S261 : u32,  _S262 : u32,  _S263 : f32,  _S264 : f32) -> VisiblePoint_0
{
    var _S265 : u32 = u32(3) * _S262;
    var _S266 : Vertex_0 = vertex_at_0(_S265);
    var _S267 : Vertex_0 = vertex_at_0(_S265 + u32(1));
    var _S268 : Vertex_0 = vertex_at_0(_S265 + u32(2));
    var _S269 : vec3<f32> = position_of_0(_S266);
    var _S270 : vec3<f32> = position_of_0(_S267) - _S269;
    var _S271 : vec3<f32> = position_of_0(_S268) - _S269;
    var _S272 : f32 = _S267.u_0 - _S266.u_0;
    var _S273 : f32 = _S267.v_0 - _S266.v_0;
    var _S274 : vec2<f32> = vec2<f32>(_S272, _S273);
    var _S275 : f32 = _S268.u_0 - _S266.u_0;
    var _S276 : f32 = _S268.v_0 - _S266.v_0;
    var _S277 : vec2<f32> = vec2<f32>(_S275, _S276);
    var _S278 : vec3<f32> = vec3<f32>(select(1.0f, -1.0f, (_S272 * _S276 - _S273 * _S275) < 0.0f));
    var _S279 : vec3<f32> = _S278 * (vec3<f32>(_S276) * _S270 - vec3<f32>(_S273) * _S271);
    var _S280 : vec3<f32> = _S278 * (vec3<f32>(_S272) * _S271 - vec3<f32>(_S275) * _S270);
    var point_1 : VisiblePoint_0;
    var _S281 : vec3<f32> = vec3<f32>(_S263);
    var _S282 : vec3<f32> = vec3<f32>(_S264);
    var _S283 : vec3<f32> = normalize(vec3<f32>((1.0f - _S263 - _S264)) * normal_of_0(_S266) + _S281 * normal_of_0(_S267) + _S282 * normal_of_0(_S268));
    point_1.normal_0 = _S283;
    var _S284 : vec3<f32> = normalize(_S279 - _S283 * vec3<f32>(dot(_S283, _S279)));
    point_1.axis_x_0 = _S284;
    point_1.axis_y_0 = cross(_S283, _S284);
    var _S285 : vec3<f32> = normalize(cross(_S270, _S271));
    point_1.face_normal_0 = select_vector_1((dot(_S285, _S283)) < 0.0f, (vec3<f32>(0) - _S285), _S285);
    point_1.position_0 = _S269 + _S281 * _S270 + _S282 * _S271;
    point_1.view_0 = _S283;
    var _S286 : vec2<f32> = vec2<f32>(_S266.u_0, _S266.v_0) + vec2<f32>(_S263) * _S274 + vec2<f32>(_S264) * _S277;
    point_1.uv_1 = _S286;
    var _S287 : bool = (dot(cross(_S279, _S280), _S283)) < 0.0f;
    var _S288 : vec2<f32> = vec2<f32>(fabrics_0[_S261].uv_width_0, select(fabrics_0[_S261].uv_height_0, - fabrics_0[_S261].uv_height_0, _S287));
    point_1.draft_per_uv_0 = _S288;
    point_1.draft_0 = uneven_place_0(_S261, _S286 * _S288 + vec2<f32>(0.0f, select(0.0f, fabrics_0[_S261].uv_height_0, _S287)));
    var _S289 : vec2<f32> = vec2<f32>(0.0f);
    point_1.draft_dx_0 = _S289;
    point_1.draft_dy_0 = _S289;
    return point_1;
}

fn visible_point_0( _S290 : u32,  _S291 : u32,  _S292 : vec2<u32>) -> VisiblePoint_0
{
    var _S293 : u32 = u32(3) * _S291;
    var _S294 : Vertex_0 = vertex_at_0(_S293);
    var _S295 : Vertex_0 = vertex_at_0(_S293 + u32(1));
    var _S296 : Vertex_0 = vertex_at_0(_S293 + u32(2));
    var _S297 : vec3<f32> = position_of_0(_S294);
    var _S298 : vec3<f32> = position_of_0(_S295) - _S297;
    var _S299 : vec3<f32> = position_of_0(_S296) - _S297;
    var _S300 : vec3<f32> = cross(_S298, _S299);
    var _S301 : f32 = f32(frame_record_0.width_0);
    var _S302 : vec3<f32> = camera_right_0() * vec3<f32>((2.0f / _S301));
    var _S303 : f32 = f32(frame_record_0.height_0);
    var _S304 : vec3<f32> = camera_up_0() * vec3<f32>((-2.0f / _S303));
    var _S305 : vec3<f32> = camera_forward_0() + vec3<f32>((f32(_S292.x) + 0.5f - 0.5f * _S301)) * _S302 + vec3<f32>((f32(_S292.y) + 0.5f - 0.5f * _S303)) * _S304;
    var _S306 : f32 = dot(_S305, _S300);
    var _S307 : f32 = 1.0f / select(1.00000000317107685e-30f, _S306, (abs(_S306)) > 1.00000000317107685e-30f);
    var _S308 : vec3<f32> = _S297 - camera_origin_0();
    var _S309 : vec3<f32> = vec3<f32>((dot(_S308, _S300) * _S307));
    var _S310 : vec3<f32> = _S305 * _S309 - _S308;
    var _S311 : vec3<f32> = _S309 * (_S302 - _S305 * vec3<f32>((dot(_S302, _S300) * _S307)));
    var _S312 : vec3<f32> = _S309 * (_S304 - _S305 * vec3<f32>((dot(_S304, _S300) * _S307)));
    var _S313 : vec3<f32> = vec3<f32>((1.0f / max(square_0(_S300), 1.00000000317107685e-30f)));
    var _S314 : vec3<f32> = cross(_S299, _S300) * _S313;
    var _S315 : vec3<f32> = cross(_S300, _S298) * _S313;
    var _S316 : vec2<f32> = vec2<f32>(_S295.u_0 - _S294.u_0, _S295.v_0 - _S294.v_0);
    var _S317 : vec2<f32> = vec2<f32>(_S296.u_0 - _S294.u_0, _S296.v_0 - _S294.v_0);
    var point_2 : VisiblePoint_0 = face_point_0(_S290, _S291, dot(_S310, _S314), dot(_S310, _S315));
    point_2.position_0 = _S297 + _S310;
    point_2.view_0 = (vec3<f32>(0) - normalize(_S305));
    point_2.draft_dx_0 = (vec2<f32>(dot(_S311, _S314)) * _S316 + vec2<f32>(dot(_S311, _S315)) * _S317) * point_2.draft_per_uv_0;
    point_2.draft_dy_0 = (vec2<f32>(dot(_S312, _S314)) * _S316 + vec2<f32>(dot(_S312, _S315)) * _S317) * point_2.draft_per_uv_0;
    return point_2;
}

fn filtered_albedo_0( _S318 : u32,  _S319 : VisiblePoint_0) -> vec3<f32>
{
    var _S320 : u32 = fabrics_0[_S318].albedo_map_levels_0;
    if((fabrics_0[_S318].albedo_map_levels_0) == u32(0))
    {
        return vec3<f32>(1.0f);
    }
    var _S321 : vec2<f32> = vec2<f32>(fabrics_0[_S318].uv_width_0, fabrics_0[_S318].uv_height_0);
    var _S322 : vec2<f32> = _S319.draft_dx_0 / _S321;
    var _S323 : vec2<f32> = _S319.draft_dy_0 / _S321;
    var _S324 : u32 = _S320 - u32(1);
    var _S325 : u32 = (u32(1) << (_S324));
    var _S326 : f32 = clamp(0.5f * binary_logarithm_0(max(abs(_S322.x * _S323.y - _S322.y * _S323.x), 9.99999968265522539e-21f) * (square_1(f32(_S325)) / 3.0f)), 0.0f, f32(_S320) - 1.0f);
    var _S327 : u32 = min(u32(_S326), max(_S320, u32(2)) - u32(2));
    var _S328 : u32 = min(_S327 + u32(1), _S324);
    var _S329 : u32 = (u32(1) << ((u32(2) * _S320)));
    return mix(map_level_0(fabrics_0[_S318].albedo_map_0 + (_S329 - ((_S329 >> ((u32(2) * _S327))))) / u32(3), (_S325 >> (_S327)), _S319.uv_1), map_level_0(fabrics_0[_S318].albedo_map_0 + (_S329 - ((_S329 >> ((u32(2) * _S328))))) / u32(3), (_S325 >> (_S328)), _S319.uv_1), vec3<f32>(((exponential_0(1.38629436492919922f * (_S326 - f32(_S327))) - 1.0f) / 3.0f)));
}

struct ClusteredView_0
{
     base_0 : ViewedBase_0,
     albedos_5 : FamilyAlbedos_0,
     bounced_2 : Bounced_0,
     view_7 : vec3<f32>,
};

fn viewed_base_0( _S330 : u32,  _S331 : Footprint_0,  _S332 : vec3<f32>,  _S333 : f32) -> ViewedBase_0
{
    var seen_1 : ViewedBase_0;
    var _S334 : bool = (_S332.z) < 0.0f;
    seen_1.back_5 = _S334;
    var _S335 : vec3<f32> = to_face_frame_0(_S332, _S334);
    seen_1.view_3 = _S335;
    var _S336 : u32 = select(u32(0), u32(1), _S334);
    seen_1.face_6 = _S336;
    var _S337 : Clustered_std430_0 = fabrics_0[_S330].clustered_0;
    var _S338 : f32 = _S333 - 0.5f;
    var _S339 : TexelBox_0 = texel_box_0(&(_S337), _S331, vec2<f32>(0.0f), _S338);
    var _S340 : vec2<f32> = parallax_offset_0(&(_S337), _S339, _S336, _S335);
    var _S341 : TexelBox_0 = texel_box_0(&(_S337), _S331, _S340, _S338);
    seen_1.box_5 = _S341;
    return seen_1;
}

fn albedos_over_0( _S342 : u32,  _S343 : Footprint_0,  _S344 : bool) -> FamilyAlbedos_0
{
    var _S345 : vec2<f32> = _S343.dx_0;
    var _S346 : vec2<f32> = _S343.dy_0;
    var _S347 : vec2<f32> = sqrt(_S345 * _S345 + _S346 * _S346);
    var _S348 : Stretch_0 = stretch_of_0(fabrics_0[_S342].warp_0, _S343.centre_0.x, _S347.x);
    var _S349 : Stretch_0 = stretch_of_0(fabrics_0[_S342].weft_0, _S343.centre_0.y, _S347.y);
    var albedos_6 : FamilyAlbedos_0;
    albedos_6.warp_3 = mean_albedos_0(fabrics_0[_S342].warp_0, fabrics_0[_S342].weft_0, _S348, _S349, _S344);
    albedos_6.weft_3 = mean_albedos_0(fabrics_0[_S342].weft_0, fabrics_0[_S342].warp_0, _S349, _S348, _S344);
    return albedos_6;
}

fn openness_number_0( _S350 : u32,  _S351 : u32) -> f32
{
    return table_number_0(fabrics_0[_S350].openness_0 + _S351);
}

fn scattered_by_0( _S352 : u32,  _S353 : Albedos_0,  _S354 : u32,  _S355 : vec3<f32>) -> Scattered_0
{
    var _S356 : u32 = u32(159) + u32(2) * _S354;
    var yarn_1 : Scattered_0;
    yarn_1.back_4 = _S355 * _S353.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S352, _S356)) * _S353.specular_reflect_0;
    yarn_1.through_0 = _S355 * _S353.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S352, _S356 + u32(1))) * _S353.specular_transmit_0;
    return yarn_1;
}

fn sent_0( _S357 : u32,  _S358 : u32,  _S359 : vec3<f32>,  _S360 : vec3<f32>,  _S361 : vec3<f32>,  _S362 : vec3<f32>,  _S363 : ptr<function, vec3<f32>>,  _S364 : ptr<function, vec3<f32>>)
{
    var _S365 : u32 = u32(146) + u32(4) * _S358;
    var _S366 : f32 = openness_number_0(_S357, _S365 + u32(1));
    var _S367 : f32 = openness_number_0(_S357, _S365 + u32(2));
    var _S368 : vec3<f32> = vec3<f32>(1.0f);
    var _S369 : vec3<f32> = _S368 - _S361 * vec3<f32>(openness_number_0(_S357, _S365));
    var _S370 : vec3<f32> = _S368 - _S362 * vec3<f32>(openness_number_0(_S357, _S365 + u32(3)));
    var _S371 : vec3<f32> = _S368 / (_S369 * _S370 - _S361 * _S362 * vec3<f32>((_S366 * _S367)));
    (*_S363) = (_S359 * _S370 + _S361 * vec3<f32>(_S366) * _S360) * _S371;
    (*_S364) = (_S360 * _S369 + _S362 * vec3<f32>(_S367) * _S359) * _S371;
    return;
}

fn face_sends_0( _S372 : u32,  _S373 : u32,  _S374 : Scattered_0,  _S375 : Scattered_0) -> FaceSends_0
{
    var _S376 : u32 = u32(2) * _S373;
    var _S377 : u32 = u32(142) + _S376;
    var _S378 : f32 = openness_number_0(_S372, _S377);
    var _S379 : f32 = openness_number_0(_S372, _S377 + u32(1));
    var _S380 : vec3<f32> = vec3<f32>((1.0f - _S378)) * _S374.back_4;
    var _S381 : vec3<f32> = vec3<f32>((1.0f - _S379)) * _S375.back_4;
    var sends_1 : FaceSends_0;
    var _S382 : u32 = u32(154) + _S376;
    var _S383 : f32 = openness_number_0(_S372, _S382);
    sends_1.blocks_warp_0 = _S383;
    var _S384 : f32 = openness_number_0(_S372, _S382 + u32(1));
    sends_1.blocks_weft_0 = _S384;
    sends_1.open_0 = _S383 * _S378 + _S384 * _S379;
    var _S385 : vec3<f32> = vec3<f32>(_S378) * _S374.back_4;
    var _S386 : vec3<f32> = vec3<f32>(_S379) * _S375.back_4;
    var _S387 : vec3<f32> = sends_1.sky_warp_0;
    var _S388 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S372, _S373, _S385, _S386, _S380, _S381, &(_S387), &(_S388));
    sends_1.sky_warp_0 = _S387;
    sends_1.sky_weft_0 = _S388;
    var _S389 : vec3<f32> = sends_1.crossing_warp_0;
    var _S390 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S372, _S373, _S374.through_0, _S375.through_0, _S380, _S381, &(_S389), &(_S390));
    sends_1.crossing_warp_0 = _S389;
    sends_1.crossing_weft_0 = _S390;
    return sends_1;
}

fn interior_of_0( _S391 : u32,  _S392 : vec3<f32>,  _S393 : bool) -> Interior_0
{
    var _S394 : Scattered_0 = scattered_by_0(_S391, table_albedos_0(families_0[fabrics_0[_S391].warp_0].colour_mean_0), u32(0), _S392);
    var _S395 : Scattered_0 = scattered_by_0(_S391, table_albedos_0(families_0[fabrics_0[_S391].weft_0].colour_mean_0), u32(1), _S392);
    var _S396 : FaceSends_0 = face_sends_0(_S391, select(u32(0), u32(1), _S393), _S394, _S395);
    var _S397 : FaceSends_0 = face_sends_0(_S391, select(u32(1), u32(0), _S393), _S394, _S395);
    var _S398 : vec3<f32> = vec3<f32>(_S396.blocks_warp_0);
    var _S399 : vec3<f32> = vec3<f32>(_S396.blocks_weft_0);
    var _S400 : vec3<f32> = _S398 * _S396.crossing_warp_0 + _S399 * _S396.crossing_weft_0;
    var _S401 : vec3<f32> = vec3<f32>(_S397.blocks_warp_0);
    var _S402 : vec3<f32> = vec3<f32>(_S397.blocks_weft_0);
    var _S403 : vec3<f32> = _S401 * _S397.crossing_warp_0 + _S402 * _S397.crossing_weft_0;
    var _S404 : f32 = 1.0f - _S396.open_0;
    var _S405 : f32 = 1.0f - _S397.open_0;
    var _S406 : vec3<f32> = vec3<f32>(1.0f);
    var _S407 : vec3<f32> = _S406 / (_S406 - _S400 * _S403 * vec3<f32>((_S404 * _S405)));
    var _S408 : vec3<f32> = _S403 * (vec3<f32>(_S396.open_0) + vec3<f32>(_S404) * (_S398 * _S396.sky_warp_0 + _S399 * _S396.sky_weft_0)) * _S407;
    var _S409 : vec3<f32> = _S400 * (vec3<f32>(_S397.open_0) + vec3<f32>(_S405) * (_S401 * _S397.sky_warp_0 + _S402 * _S397.sky_weft_0)) * _S407;
    var _S410 : FaceRadiance_0 = face_radiance_0(_S396, _S397.open_0, _S408, _S409);
    var _S411 : FaceRadiance_0 = face_radiance_0(_S397, _S396.open_0, _S409, _S408);
    var interior_1 : Interior_0;
    interior_1.warp_2 = _S410.warp_1;
    interior_1.weft_2 = _S410.weft_1;
    interior_1.leaked_1 = _S410.leaked_0;
    interior_1.far_1 = _S411.mean_0;
    interior_1.far_leaked_0 = _S411.leaked_0;
    return interior_1;
}

fn blocked_of_terms_0( _S412 : u32,  _S413 : u32,  _S414 : array<f32, i32(6)>,  _S415 : u32) -> Blocked_0
{
    var shares_0 : array<f32, i32(3)>;
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
        shares_0[share_3] = 0.0f;
        var term_0 : u32 = u32(0);
        for(;;)
        {
            if(term_0 < _S415)
            {
            }
            else
            {
                break;
            }
            shares_0[share_3] = shares_0[share_3] + openness_number_0(_S412, _S413 + share_3 * _S415 + term_0) * _S414[term_0];
            term_0 = term_0 + u32(1);
        }
        shares_0[share_3] = saturate(shares_0[share_3]);
        share_3 = share_3 + u32(1);
    }
    var blocked_1 : Blocked_0;
    blocked_1.by_warp_0 = shares_0[i32(0)] * shares_0[i32(2)];
    blocked_1.by_weft_0 = shares_0[i32(0)] * (1.0f - shares_0[i32(2)]);
    blocked_1.far_0 = shares_0[i32(1)];
    return blocked_1;
}

fn blocked_from_0( _S416 : u32,  _S417 : vec3<f32>,  _S418 : bool,  _S419 : bool) -> Blocked_0
{
    var terms_1 : array<f32, i32(6)>;
    view_terms_0(_S417, &(terms_1));
    return blocked_of_terms_0(_S416, (select(u32(0), u32(2), _S419) + select(u32(1), u32(0), _S418)) * u32(15), terms_1, u32(5));
}

fn family_share_0( _S420 : u32,  _S421 : u32,  _S422 : f32) -> vec2<f32>
{
    var _S423 : bool = _S421 < (fabrics_0[_S420].clustered_0.clusters_0 / u32(2));
    return vec2<f32>(select(0.0f, _S422, _S423), select(_S422, 0.0f, _S423));
}

fn clustered_shown_0( _S424 : u32,  _S425 : ViewedBase_0) -> vec2<f32>
{
    var _S426 : Clustered_std430_0 = fabrics_0[_S424].clustered_0;
    var _S427 : u32 = _S426.clusters_0;
    var _S428 : vec2<f32> = vec2<f32>(0.0f);
    var cluster_0 : u32 = u32(0);
    var shown_0 : vec2<f32> = _S428;
    for(;;)
    {
        if(cluster_0 < _S427)
        {
        }
        else
        {
            break;
        }
        var _S429 : f32 = box_mean_0(&(_S426), _S425.box_5, _S425.face_6, cluster_0);
        var shown_1 : vec2<f32> = shown_0 + family_share_0(_S424, cluster_0, _S429);
        cluster_0 = cluster_0 + u32(1);
        shown_0 = shown_1;
    }
    return shown_0;
}

fn clustered_view_0( _S430 : u32,  _S431 : Footprint_0,  _S432 : vec3<f32>,  _S433 : vec3<f32>,  _S434 : u32) -> ClusteredView_0
{
    var seen_2 : ClusteredView_0;
    seen_2.base_0 = viewed_base_0(_S430, _S431, _S432, uniform_of_0(_S434, u32(0)));
    seen_2.view_7 = _S432;
    var _S435 : FamilyAlbedos_0 = albedos_over_0(_S430, _S431, seen_2.base_0.back_5);
    seen_2.albedos_5.warp_3 = tinted_0(_S435.warp_3, _S433);
    seen_2.albedos_5.weft_3 = tinted_0(_S435.weft_3, _S433);
    var _S436 : vec3<f32> = vec3<f32>(0.0f);
    seen_2.bounced_2.reflected_0 = _S436;
    seen_2.bounced_2.transmitted_0 = _S436;
    if((fabrics_0[_S430].openness_0) == u32(4294967295))
    {
        return seen_2;
    }
    var _S437 : Interior_0 = interior_of_0(_S430, _S433, seen_2.base_0.back_5);
    var _S438 : Bounced_0 = bounced_by_0(blocked_from_0(_S430, seen_2.base_0.view_3, true, seen_2.base_0.back_5), scattered_by_0(_S430, _S435.warp_3, u32(0), _S433), _S437);
    var _S439 : Bounced_0 = bounced_by_0(blocked_from_0(_S430, seen_2.base_0.view_3, false, seen_2.base_0.back_5), scattered_by_0(_S430, _S435.weft_3, u32(1), _S433), _S437);
    var _S440 : vec2<f32> = clustered_shown_0(_S430, seen_2.base_0);
    var _S441 : vec3<f32> = vec3<f32>(_S440.x);
    var _S442 : vec3<f32> = vec3<f32>(_S440.y);
    seen_2.bounced_2.reflected_0 = _S441 * _S438.reflected_0 + _S442 * _S439.reflected_0;
    seen_2.bounced_2.transmitted_0 = _S441 * _S438.transmitted_0 + _S442 * _S439.transmitted_0;
    return seen_2;
}

fn clustered_hole_0( _S443 : u32,  _S444 : ViewedBase_0) -> f32
{
    var cluster_1 : u32 = u32(0);
    var covered_0 : f32 = 0.0f;
    for(;;)
    {
        var _S445 : Clustered_std430_0 = fabrics_0[_S443].clustered_0;
        if(cluster_1 < (_S445.clusters_0))
        {
        }
        else
        {
            break;
        }
        var _S446 : f32 = box_mean_1(&(_S445), _S444.box_5, _S444.face_6, cluster_1);
        var covered_1 : f32 = covered_0 + _S446;
        cluster_1 = cluster_1 + u32(1);
        covered_0 = covered_1;
    }
    return clamp(1.0f - covered_0, 0.0f, 1.0f);
}

fn residual_texel_0( _S447 : u32,  _S448 : ClusteredView_0,  _S449 : u32,  _S450 : u32) -> u32
{
    var _S451 : u32 = _S449 + _S450 * u32(1663821227);
    var _S452 : Clustered_std430_0 = fabrics_0[_S447].clustered_0;
    var _S453 : u32 = texel_of_0(&(_S452), _S448.base_0.box_5, vec2<f32>(uniform_of_0(_S451, u32(1)), uniform_of_0(_S451, u32(2))));
    return _S453;
}

fn light_sample_count_0() -> u32
{
    return frame_record_0.lights_0 + frame_record_0.environment_samples_0;
}

fn visibility_at_0( _S454 : u32,  _S455 : vec2<u32>) -> f32
{
    if((frame_record_0.casts_shadows_0) == u32(0))
    {
        return 1.0f;
    }
    return visibilities_0[(_S454 * frame_record_0.height_0 + _S455.y) * frame_record_0.width_0 + _S455.x];
}

struct LightSample_0
{
     towards_1 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_0 : f32,
};

fn environment_texel_0( _S456 : u32,  _S457 : u32) -> vec3<f32>
{
    var _S458 : u32 = frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + frame_record_0.environment_rows_0 * (frame_record_0.environment_columns_0 + u32(1)) + u32(3) * (_S456 * frame_record_0.environment_columns_0 + _S457);
    return vec3<f32>(scene_number_0(_S458), scene_number_0(_S458 + u32(1)), scene_number_0(_S458 + u32(2)));
}

fn sample_environment_0( _S459 : vec2<f32>,  _S460 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S461 : u32 = frame_record_0.environment_rows_0;
    var _S462 : Choice_0 = choose_0(frame_record_0.environment_table_0, frame_record_0.environment_rows_0, _S459.y);
    var _S463 : u32 = frame_record_0.environment_columns_0;
    var _S464 : Choice_0 = choose_0(frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + _S462.index_6 * (frame_record_0.environment_columns_0 + u32(1)), frame_record_0.environment_columns_0, _S459.x);
    var _S465 : vec3<f32> = environment_texel_0(_S462.index_6, _S464.index_6);
    (*_S460) = _S465 * vec3<f32>((frame_record_0.environment_total_0 / max(mean_1(_S465), 9.99999968265522539e-21f)));
    var _S466 : f32 = 3.14159274101257324f / f32(_S461);
    var _S467 : f32 = mix(sine_cosine_0(f32(_S462.index_6) * _S466).y, sine_cosine_0(f32(_S462.index_6 + u32(1)) * _S466).y, _S462.remainder_0);
    var _S468 : f32 = sqrt(max(1.0f - _S467 * _S467, 0.0f));
    var _S469 : vec2<f32> = sine_cosine_0((f32(_S464.index_6) + _S464.remainder_0) * (6.28318548202514648f / f32(_S463)));
    var _S470 : f32 = _S468 * _S469.x;
    var _S471 : f32 = - _S468 * _S469.y;
    return vec3<f32>(frame_record_0.environment_cosine_0 * _S470 + frame_record_0.environment_sine_0 * _S471, _S467, frame_record_0.environment_cosine_0 * _S471 - frame_record_0.environment_sine_0 * _S470);
}

fn light_sample_0( _S472 : u32,  _S473 : vec2<u32>,  _S474 : vec3<f32>) -> LightSample_0
{
    var sample_0 : LightSample_0;
    sample_0.distance_0 = 1.00000001504746622e+30f;
    var _S475 : u32 = frame_record_0.lights_0;
    if(_S472 >= (frame_record_0.lights_0))
    {
        var weight_3 : vec3<f32>;
        var _S476 : vec3<f32> = sample_environment_0(pixel_sequence_0(_S473, frame_record_0.pass_number_0 * frame_record_0.environment_samples_0 + (_S472 - _S475), u32(3)), &(weight_3));
        sample_0.towards_1 = _S476;
        sample_0.irradiance_1 = weight_3 / vec3<f32>(f32(frame_record_0.environment_samples_0));
        return sample_0;
    }
    var _S477 : Light_0 = scene_light_0(frame_record_0.light_records_0 + u32(7) * _S472);
    sample_0.irradiance_1 = vec3<f32>(_S477.red_0, _S477.green_0, _S477.blue_0);
    sample_0.towards_1 = vec3<f32>(_S477.x_8, _S477.y_2, _S477.z_1);
    if((_S477.is_point_0) != u32(0))
    {
        var _S478 : vec3<f32> = sample_0.towards_1 - _S474;
        var _S479 : f32 = max(square_0(_S478), 9.999999960041972e-13f);
        sample_0.distance_0 = sqrt(_S479);
        sample_0.irradiance_1 = sample_0.irradiance_1 / vec3<f32>(_S479);
        sample_0.towards_1 = normalize(_S478);
    }
    return sample_0;
}

fn cluster_density_0( _S480 : u32,  _S481 : ViewedBase_0,  _S482 : BaseTaps_0,  _S483 : u32,  _S484 : u32) -> f32
{
    return BinTaps_read_0(_S482.half_vector_0, fabrics_0[_S480].clustered_0.basis_0, _S481.face_6 * u32(1024), fabrics_0[_S480].clustered_0.clusters_0 * (u32(1) + fabrics_0[_S480].clustered_0.rank_0), _S484 * fabrics_0[_S480].clustered_0.clusters_0 + _S483);
}

fn cluster_visibility_0( _S485 : u32,  _S486 : BaseTaps_0,  _S487 : u32) -> f32
{
    return BinTaps_read_0(_S486.around_0, fabrics_0[_S485].clustered_0.light_0, _S486.first_7, fabrics_0[_S485].clustered_0.clusters_0, _S487);
}

fn clustered_diffuse_0( _S488 : u32,  _S489 : BaseTaps_0,  _S490 : f32,  _S491 : vec3<f32>) -> f32
{
    return 0.31830987334251404f * ((1.0f - fabrics_0[_S488].diffuse_blend_0) * abs(_S489.facing_0.z) * _S490 + fabrics_0[_S488].diffuse_blend_0 * clustered_cosine_0(_S489, _S491));
}

fn cluster_attenuation_0( _S492 : u32,  _S493 : ViewedBase_0,  _S494 : BaseTaps_0,  _S495 : u32) -> f32
{
    var _S496 : u32 = fabrics_0[_S492].clustered_0.moments_1 + (_S493.face_6 * fabrics_0[_S492].clustered_0.clusters_0 + _S495) * u32(8);
    var _S497 : vec3<f32> = vec3<f32>(table_number_0(_S496), table_number_0(_S496 + u32(1)), table_number_0(_S496 + u32(2)));
    var _S498 : vec3<f32> = vec3<f32>(table_number_0(_S496 + u32(3)), table_number_0(_S496 + u32(4)), table_number_0(_S496 + u32(5)));
    var _S499 : f32 = table_number_0(_S496 + u32(7));
    var _S500 : f32 = fabrics_0[_S492].optical_depth_0;
    var _S501 : f32 = dot(_S494.facing_0, _S497);
    var _S502 : f32 = max(dot(_S493.view_3, _S497), 0.10000000149011612f);
    var _S503 : f32 = projected_area_1(_S494.facing_0, _S498, _S499) / max(select(_S501, - _S501, _S494.transmits_1), 0.10000000149011612f);
    var _S504 : f32 = projected_area_1(_S493.view_3, _S498, _S499) / _S502;
    if(!_S494.transmits_1)
    {
        var _S505 : f32 = _S503 + _S504;
        return 0.25f * (1.0f - exponential_0(- _S500 * _S505)) / (_S505 * _S502);
    }
    var _S506 : f32 = max(_S500 * abs(_S503 - _S504), 0.00100000004749745f);
    return 0.25f * _S500 * exponential_0(- _S500 * min(_S503, _S504)) * (1.0f - exponential_0(- _S506)) / (_S506 * _S502);
}

fn clustered_base_0( _S507 : u32,  _S508 : ViewedBase_0,  _S509 : BaseTaps_0) -> Components_0
{
    var _S510 : Clustered_std430_0 = fabrics_0[_S507].clustered_0;
    var _S511 : u32 = _S510.clusters_0;
    var _S512 : u32 = _S510.rank_0;
    var base_1 : Components_0 = no_components_0();
    var cluster_2 : u32 = u32(0);
    for(;;)
    {
        if(cluster_2 < _S511)
        {
        }
        else
        {
            break;
        }
        var _S513 : f32 = box_mean_1(&(_S510), _S508.box_5, _S508.face_6, cluster_2);
        if(_S513 <= 0.0f)
        {
            cluster_2 = cluster_2 + u32(1);
            continue;
        }
        var _S514 : f32 = _S513 * cluster_density_0(_S507, _S508, _S509, cluster_2, u32(0));
        var number_3 : u32 = u32(1);
        var density_0 : f32 = _S514;
        for(;;)
        {
            if(number_3 <= _S512)
            {
            }
            else
            {
                break;
            }
            var _S515 : f32 = box_mean_1(&(_S510), _S508.box_5, _S508.face_6, number_3 * _S511 + cluster_2);
            var density_1 : f32 = density_0 + _S515 * cluster_density_0(_S507, _S508, _S509, cluster_2, number_3);
            number_3 = number_3 + u32(1);
            density_0 = density_1;
        }
        var _S516 : f32 = box_mean_1(&(_S510), _S508.box_5, _S508.face_6, (_S512 + u32(1)) * _S511 + cluster_2);
        var _S517 : f32 = box_mean_1(&(_S510), _S508.box_5, _S508.face_6, (_S512 + u32(2)) * _S511 + cluster_2);
        var _S518 : f32 = box_mean_1(&(_S510), _S508.box_5, _S508.face_6, (_S512 + u32(3)) * _S511 + cluster_2);
        var _S519 : f32 = cluster_visibility_0(_S507, _S509, cluster_2);
        base_1 = with_added_0(base_1, of_family_0(cluster_2 < (_S511 / u32(2)), _S519 * clustered_diffuse_0(_S507, _S509, _S513, vec3<f32>(_S516, _S517, _S518)), _S519 * cluster_attenuation_0(_S507, _S508, _S509, cluster_2) * density_0, _S513 * _S519), 1.0f);
        cluster_2 = cluster_2 + u32(1);
    }
    return base_1;
}

fn under_sheen_0( _S520 : u32,  _S521 : ClusteredView_0,  _S522 : vec3<f32>,  _S523 : f32,  _S524 : vec3<f32>) -> vec3<f32>
{
    var _S525 : f32 = fabrics_0[_S520].sheen_strength_0;
    if((fabrics_0[_S520].sheen_strength_0) <= 0.0f)
    {
        return _S522;
    }
    var _S526 : vec2<f32> = sheen_with_transmittance_0(to_face_frame_0(_S524, _S521.base_0.back_5), _S521.base_0.view_3, _S525, fabrics_0[_S520].sheen_roughness_0);
    return vec3<f32>(_S526.y) * _S522 + vec3<f32>((_S523 * _S526.x));
}

fn clustered_base_value_0( _S527 : u32,  _S528 : ClusteredView_0,  _S529 : f32,  _S530 : vec3<f32>) -> vec3<f32>
{
    var _S531 : BaseTaps_0 = base_taps_0(_S528.base_0, _S530);
    var _S532 : Components_0 = clustered_base_0(_S527, _S528.base_0, _S531);
    return under_sheen_0(_S527, _S528, shaded_0(_S532, _S528.albedos_5, _S531.transmits_1) + bounced_value_0(_S528.bounced_2, _S530, _S528.view_7), _S532.light_visibility_1 + _S529, _S530);
}

struct TexelTerms_0
{
     own_1 : Components_0,
     known_0 : Components_0,
};

fn coefficient_0( _S533 : u32,  _S534 : u32,  _S535 : u32) -> f32
{
    var _S536 : i32 = i32(table_byte_0(fabrics_0[_S533].clustered_0.coefficients_0, _S534 * (fabrics_0[_S533].clustered_0.rank_0 + u32(3)) + _S535));
    return f32(select(_S536, _S536 - i32(256), _S536 > i32(127)));
}

fn at_texel_0( _S537 : u32,  _S538 : ViewedBase_0,  _S539 : u32,  _S540 : BaseTaps_0) -> TexelTerms_0
{
    var _S541 : Clustered_std430_0 = fabrics_0[_S537].clustered_0;
    var _S542 : u32 = fabrics_0[_S537].clustered_0.columns_0 * fabrics_0[_S537].clustered_0.rows_0;
    var _S543 : u32 = _S538.face_6 * _S542 + _S539;
    var _S544 : u32 = table_byte_0(fabrics_0[_S537].clustered_0.labels_0, _S543);
    var terms_2 : TexelTerms_0;
    var _S545 : Components_0 = no_components_0();
    terms_2.own_1 = _S545;
    terms_2.known_0 = _S545;
    if(_S544 >= (fabrics_0[_S537].clustered_0.clusters_0))
    {
        return terms_2;
    }
    var _S546 : f32 = cluster_density_0(_S537, _S538, _S540, _S544, u32(0));
    var number_4 : u32 = u32(1);
    var density_2 : f32 = _S546;
    for(;;)
    {
        if(number_4 <= (_S541.rank_0))
        {
        }
        else
        {
            break;
        }
        var density_3 : f32 = density_2 + coefficient_0(_S537, _S543, number_4 - u32(1)) * cluster_density_0(_S537, _S538, _S540, _S544, number_4);
        number_4 = number_4 + u32(1);
        density_2 = density_3;
    }
    var _S547 : f32 = cluster_attenuation_0(_S537, _S538, _S540, _S544) * density_2;
    var _S548 : f32 = clustered_cosine_0(_S540, vec3<f32>(coefficient_0(_S537, _S543, _S541.rank_0), coefficient_0(_S537, _S543, _S541.rank_0 + u32(1)), coefficient_0(_S537, _S543, _S541.rank_0 + u32(2))));
    var _S549 : f32 = abs(_S540.facing_0.z);
    var _S550 : f32 = gaussian_visibility_0(_S541.texels_2 + (select(_S538.face_6, u32(1) - _S538.face_6, _S540.transmits_1) * _S542 + _S539) * u32(12), vec3<f32>(_S540.facing_0.xy, _S549));
    var _S551 : f32 = 0.31830987334251404f * (1.0f - fabrics_0[_S537].diffuse_blend_0) * _S549;
    var _S552 : f32 = cluster_visibility_0(_S537, _S540, _S544);
    var _S553 : bool = _S544 < (_S541.clusters_0 / u32(2));
    var _S554 : f32 = 0.31830987334251404f * fabrics_0[_S537].diffuse_blend_0;
    terms_2.own_1 = of_family_0(_S553, _S550 * (_S551 + _S554 * max(_S548, 0.0f)), _S550 * _S547, _S550);
    terms_2.known_0 = of_family_0(_S553, _S552 * (_S551 + _S554 * _S548), _S552 * _S547, _S552);
    return terms_2;
}

fn texel_albedos_0( _S555 : u32,  _S556 : ViewedBase_0,  _S557 : u32) -> Albedos_0
{
    var _S558 : u32 = _S556.face_6 * fabrics_0[_S555].clustered_0.columns_0 * fabrics_0[_S555].clustered_0.rows_0 + _S557;
    var _S559 : u32 = select(fabrics_0[_S555].weft_0, fabrics_0[_S555].warp_0, (table_byte_0(fabrics_0[_S555].clustered_0.labels_0, _S558)) < (fabrics_0[_S555].clustered_0.clusters_0 / u32(2)));
    var _S560 : u32 = fabrics_0[_S555].clustered_0.texels_2 + _S558 * u32(12) + u32(9);
    return table_albedos_0(families_0[_S559].albedo_table_0 + min(u32(table_number_0(_S560)) + u32(1024) * u32(table_number_0(_S560 + u32(1))), u32(families_0[_S559].count_0) - u32(1)) * families_0[_S559].albedo_stride_0);
}

fn clustered_residual_0( _S561 : u32,  _S562 : ClusteredView_0,  _S563 : u32,  _S564 : vec3<f32>,  _S565 : vec3<f32>) -> vec3<f32>
{
    var _S566 : BaseTaps_0 = base_taps_0(_S562.base_0, _S565);
    var _S567 : TexelTerms_0 = at_texel_0(_S561, _S562.base_0, _S563, _S566);
    var own_2 : FamilyAlbedos_0;
    var _S568 : Albedos_0 = tinted_0(texel_albedos_0(_S561, _S562.base_0, _S563), _S564);
    own_2.warp_3 = _S568;
    own_2.weft_3 = _S568;
    return under_sheen_0(_S561, _S562, shaded_0(_S567.own_1, own_2, _S566.transmits_1) - shaded_0(_S567.known_0, _S562.albedos_5, _S566.transmits_1), _S567.own_1.light_visibility_1 - _S567.known_0.light_visibility_1, _S565);
}

fn passed_by_sheen_0( _S569 : u32,  _S570 : f32,  _S571 : vec3<f32>) -> f32
{
    var _S572 : f32 = fabrics_0[_S569].sheen_strength_0;
    if((fabrics_0[_S569].sheen_strength_0) <= 0.0f)
    {
        return _S570;
    }
    return _S570 * (1.0f - _S572 * sheen_lobe_0(abs(_S571.z), fabrics_0[_S569].sheen_roughness_0).z);
}

fn light_of_clustered_0( _S573 : u32,  _S574 : VisiblePoint_0,  _S575 : vec2<u32>,  _S576 : vec3<f32>) -> vec4<f32>
{
    var footprint_1 : Footprint_0;
    footprint_1.centre_0 = _S574.draft_0;
    footprint_1.dx_0 = _S574.draft_dx_0;
    footprint_1.dy_0 = _S574.draft_dy_0;
    var _S577 : vec3<f32> = to_local_0(_S574, _S574.view_0);
    var _S578 : Clustered_std430_0 = fabrics_0[_S573].clustered_0;
    var _S579 : u32 = mixed_0(mixed_0(_S575.x + u32(65536) * _S575.y) + frame_record_0.pass_number_0 * u32(2654435769));
    var _S580 : ClusteredView_0 = clustered_view_0(_S573, footprint_1, _S577, _S576, _S579);
    var _S581 : f32 = clustered_hole_0(_S573, _S580.base_0);
    var _S582 : vec3<f32> = vec3<f32>(0.0f);
    var term_1 : u32 = u32(0);
    var radiance_1 : vec3<f32> = _S582;
    for(;;)
    {
        if(term_1 <= (_S578.samples_1))
        {
        }
        else
        {
            break;
        }
        var texel_0 : u32;
        if(term_1 > u32(0))
        {
            texel_0 = residual_texel_0(_S573, _S580, _S579, term_1 - u32(1));
        }
        else
        {
            texel_0 = u32(0);
        }
        var number_5 : u32 = u32(0);
        var radiance_2 : vec3<f32> = radiance_1;
        for(;;)
        {
            if(number_5 < (light_sample_count_0()))
            {
            }
            else
            {
                break;
            }
            var _S583 : f32 = visibility_at_0(number_5, _S575);
            if(_S583 <= 0.0f)
            {
                number_5 = number_5 + u32(1);
                continue;
            }
            var _S584 : LightSample_0 = light_sample_0(number_5, _S575, _S574.position_0);
            var _S585 : vec3<f32> = to_local_0(_S574, _S584.towards_1);
            var value_1 : vec3<f32>;
            if(term_1 == u32(0))
            {
                value_1 = clustered_base_value_0(_S573, _S580, _S581, _S585);
            }
            else
            {
                value_1 = clustered_residual_0(_S573, _S580, texel_0, _S576, _S585) / vec3<f32>(f32(_S578.samples_1));
            }
            radiance_2 = radiance_2 + vec3<f32>(_S583) * _S584.irradiance_1 * value_1;
            number_5 = number_5 + u32(1);
        }
        term_1 = term_1 + u32(1);
        radiance_1 = radiance_2;
    }
    return vec4<f32>(radiance_1, 1.0f - passed_by_sheen_0(_S573, _S581, _S577));
}

@compute
@workgroup_size(8, 8, 1)
fn shade_clustered(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S586 : u32 = id_0.x;
    var _S587 : bool;
    if(_S586 >= (frame_record_0.width_0))
    {
        _S587 = true;
    }
    else
    {
        _S587 = (id_0.y) >= (frame_record_0.height_0);
    }
    if(_S587)
    {
        return;
    }
    var _S588 : u32 = id_0.y * frame_record_0.width_0 + _S586;
    var _S589 : u32 = layers_0[_S588].face_0;
    if((layers_0[_S588].face_0) == u32(0))
    {
        return;
    }
    var _S590 : u32 = _S589 - u32(1);
    var _S591 : u32 = fabric_of_0(_S590);
    var _S592 : vec2<u32> = id_0.xy;
    var _S593 : VisiblePoint_0 = visible_point_0(_S591, _S590, _S592);
    accumulate_0(_S588, light_of_clustered_0(_S591, _S593, _S592, filtered_albedo_0(_S591, _S593)));
    return;
}

