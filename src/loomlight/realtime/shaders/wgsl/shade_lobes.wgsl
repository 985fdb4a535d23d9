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

var<private> TAP_OFFSETS_0 : array<vec2<f32>, i32(9)> = array<vec2<f32>, i32(9)>( vec2<f32>(-0.3333333432674408f, -0.3333333432674408f), vec2<f32>(-0.3333333432674408f, 0.0f), vec2<f32>(-0.3333333432674408f, 0.3333333432674408f), vec2<f32>(0.0f, -0.3333333432674408f), vec2<f32>(0.0f, 0.0f), vec2<f32>(0.0f, 0.3333333432674408f), vec2<f32>(0.3333333432674408f, -0.3333333432674408f), vec2<f32>(0.3333333432674408f, 0.0f), vec2<f32>(0.3333333432674408f, 0.3333333432674408f) );
var<private> PYRAMID_RADII_0 : array<f32, i32(4)> = array<f32, i32(4)>( 1.0f, 2.0f, 4.0f, 8.0f );
var<private> POINT_OFFSETS_0 : array<vec2<f32>, i32(8)> = array<vec2<f32>, i32(8)>( vec2<f32>(0.0f, 0.0f), vec2<f32>(-0.23010000586509705f, 0.35670000314712524f), vec2<f32>(0.36809998750686646f, -0.22939999401569366f), vec2<f32>(-0.28040000796318054f, -0.34400001168251038f), vec2<f32>(0.3465999960899353f, 0.28859999775886536f), vec2<f32>(-0.36349999904632568f, 0.0511000007390976f), vec2<f32>(0.09929999709129333f, -0.35699999332427979f), vec2<f32>(0.10710000246763229f, 0.32879999279975891f) );
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

fn uniform_hash_0( thread_3 : u32,  cell_5 : u32,  stream_1 : u32) -> f32
{
    return (f32(((hash_bits_0(hash_key_0(thread_3, stream_1), cell_5)) >> (u32(9)))) + 0.5f) * 1.1920928955078125e-07f;
}

fn pixel_sequence_0( pixel_0 : vec2<u32>,  index_3 : u32,  stream_2 : u32) -> vec2<f32>
{
    var _S52 : u32 = pixel_0.x;
    var _S53 : u32 = pixel_0.y;
    return fract(vec2<f32>(uniform_hash_0(_S52, _S53, stream_2), uniform_hash_0(_S52, _S53, stream_2 + u32(1))) + vec2<f32>(f32((index_3 & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
}

fn scene_number_0( index_4 : u32) -> f32
{
    return (bitcast<f32>((scene_words_0[index_4])));
}

struct Choice_0
{
     index_5 : u32,
     remainder_0 : f32,
};

fn choose_0( table_0 : u32,  count_1 : u32,  number_1 : f32) -> Choice_0
{
    var high_0 : u32 = count_1;
    var low_0 : u32 = u32(0);
    for(;;)
    {
        if((high_0 - low_0) > u32(1))
        {
        }
        else
        {
            break;
        }
        var _S54 : u32 = (low_0 + high_0) / u32(2);
        if((scene_number_0(table_0 + _S54)) <= number_1)
        {
            low_0 = _S54;
        }
        else
        {
            high_0 = _S54;
        }
    }
    var _S55 : u32 = table_0 + low_0;
    var _S56 : f32 = scene_number_0(_S55);
    var _S57 : f32 = scene_number_0(_S55 + u32(1));
    var choice_0 : Choice_0;
    choice_0.index_5 = low_0;
    choice_0.remainder_0 = saturate((number_1 - _S56) / max(_S57 - _S56, 9.999999960041972e-13f));
    return choice_0;
}

fn mean_0( colour_0 : vec3<f32>) -> f32
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

fn sine_cosine_0( x_6 : f32) -> vec2<f32>
{
    var _S58 : f32 = floor(x_6 * 0.63661974668502808f + 0.5f);
    var _S59 : f32 = x_6 - _S58 * 1.5703125f - _S58 * 0.00048375129699707f - _S58 * 7.54979012640433211e-08f;
    var _S60 : f32 = _S59 * _S59;
    var _S61 : f32 = ((-0.00019515295571182f * _S60 + 0.00833216123282909f) * _S60 - 0.16666655242443085f) * _S60 * _S59 + _S59;
    var _S62 : f32 = ((0.00002443315679557f * _S60 - 0.00138873164542019f) * _S60 + 0.04166664555668831f) * _S60 * _S60 - 0.5f * _S60 + 1.0f;
    var _S63 : u32 = (u32(i32(_S58)) & (u32(3)));
    var _S64 : vec2<f32> = select_vector_0(((_S63 & (u32(1)))) != u32(0), vec2<f32>(_S62, _S61), vec2<f32>(_S61, _S62));
    var _S65 : f32 = _S64.x;
    var _S66 : f32 = _S64.y;
    return vec2<f32>(select(_S65, - _S65, ((_S63 & (u32(2)))) != u32(0)), select(_S66, - _S66, (((_S63 + u32(1)) & (u32(2)))) != u32(0)));
}

struct Light_0
{
     is_point_0 : u32,
     x_7 : f32,
     y_1 : f32,
     z_1 : f32,
     red_0 : f32,
     green_0 : f32,
     blue_0 : f32,
};

fn scene_light_0( first_2 : u32) -> Light_0
{
    var record_1 : Light_0;
    record_1.is_point_0 = scene_words_0[first_2];
    record_1.x_7 = (bitcast<f32>((scene_words_0[first_2 + u32(1)])));
    record_1.y_1 = (bitcast<f32>((scene_words_0[first_2 + u32(2)])));
    record_1.z_1 = (bitcast<f32>((scene_words_0[first_2 + u32(3)])));
    record_1.red_0 = (bitcast<f32>((scene_words_0[first_2 + u32(4)])));
    record_1.green_0 = (bitcast<f32>((scene_words_0[first_2 + u32(5)])));
    record_1.blue_0 = (bitcast<f32>((scene_words_0[first_2 + u32(6)])));
    return record_1;
}

fn to_face_frame_0( direction_1 : vec3<f32>,  back_2 : bool) -> vec3<f32>
{
    var _S67 : f32 = direction_1.z;
    return vec3<f32>(direction_1.xy, select(_S67, - _S67, back_2));
}

struct SurfacePoint_0
{
     hole_0 : bool,
     is_warp_0 : bool,
     warp_thread_0 : u32,
     weft_thread_0 : u32,
     height_2 : f32,
     normal_1 : vec3<f32>,
     tangent_0 : vec3<f32>,
     across_1 : f32,
     fibre_across_0 : f32,
     fibre_along_0 : f32,
     x_8 : f32,
     y_2 : f32,
     shown_share_0 : f32,
};

fn SurfacePoint_x24init_0( hole_1 : bool,  is_warp_1 : bool,  warp_thread_1 : u32,  weft_thread_1 : u32,  height_3 : f32,  normal_2 : vec3<f32>,  tangent_1 : vec3<f32>,  across_2 : f32,  fibre_across_1 : f32,  fibre_along_1 : f32,  x_9 : f32,  y_3 : f32,  shown_share_1 : f32) -> SurfacePoint_0
{
    var _S68 : SurfacePoint_0;
    _S68.hole_0 = hole_1;
    _S68.is_warp_0 = is_warp_1;
    _S68.warp_thread_0 = warp_thread_1;
    _S68.weft_thread_0 = weft_thread_1;
    _S68.height_2 = height_3;
    _S68.normal_1 = normal_2;
    _S68.tangent_0 = tangent_1;
    _S68.across_1 = across_2;
    _S68.fibre_across_0 = fibre_across_1;
    _S68.fibre_along_0 = fibre_along_1;
    _S68.x_8 = x_9;
    _S68.y_2 = y_3;
    _S68.shown_share_0 = shown_share_1;
    return _S68;
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

fn no_components_0() -> Components_0
{
    var nothing_0 : Components_0;
    nothing_0.diffuse_warp_0 = 0.0f;
    nothing_0.diffuse_weft_0 = 0.0f;
    nothing_0.specular_warp_0 = 0.0f;
    nothing_0.specular_weft_0 = 0.0f;
    nothing_0.light_visibility_1 = 0.0f;
    nothing_0.hole_2 = 0.0f;
    return nothing_0;
}

struct Blocked_0
{
     by_warp_0 : f32,
     by_weft_0 : f32,
     far_0 : f32,
};

fn no_blocked_0() -> Blocked_0
{
    var nothing_1 : Blocked_0;
    nothing_1.by_warp_0 = 0.0f;
    nothing_1.by_weft_0 = 0.0f;
    nothing_1.far_0 = 0.0f;
    return nothing_1;
}

struct CloseUp_0
{
     weight_0 : f32,
     warp_1 : Blocked_0,
     weft_1 : Blocked_0,
};

fn no_close_up_0() -> CloseUp_0
{
    var nothing_2 : CloseUp_0;
    nothing_2.weight_0 = 0.0f;
    var _S69 : Blocked_0 = no_blocked_0();
    nothing_2.warp_1 = _S69;
    nothing_2.weft_1 = _S69;
    return nothing_2;
}

struct SearchQuality_0
{
     steps_per_thread_0 : f32,
     steps_per_relief_0 : f32,
     shadow_share_0 : f32,
     refinements_0 : u32,
};

fn quality_of_0( threads_1 : f32) -> SearchQuality_0
{
    var _S70 : f32 = clamp((-3.0f - binary_logarithm_0(max(threads_1, 9.99999971718068537e-10f))) / 2.0f, 0.0f, 1.0f);
    var quality_0 : SearchQuality_0;
    var _S71 : f32 = mix(2.5f, 5.0f, _S70);
    quality_0.steps_per_thread_0 = _S71;
    quality_0.steps_per_relief_0 = _S71;
    quality_0.shadow_share_0 = mix(1.60000002384185791f, 1.0f, _S70);
    quality_0.refinements_0 = u32(mix(1.0f, 2.0f, _S70) + 0.5f);
    return quality_0;
}

struct Shown_0
{
     is_warp_2 : bool,
     hole_3 : bool,
     on_top_0 : bool,
     word_0 : u32,
};

struct Crossing_0
{
     warp_2 : Cell_0,
     weft_2 : Cell_0,
     warp_word_0 : u32,
     weft_word_0 : u32,
     warp_above_0 : bool,
};

fn shown_at_0( crossing_0 : Crossing_0,  back_3 : bool) -> Shown_0
{
    var _S72 : bool = (abs(crossing_0.warp_2.across_0)) < (crossing_0.warp_2.half_width_1);
    var shown_0 : Shown_0;
    var _S73 : bool = !((abs(crossing_0.weft_2.across_0)) < (crossing_0.weft_2.half_width_1));
    var _S74 : bool = (_S72 & (((_S73 | ((crossing_0.warp_above_0))))));
    shown_0.is_warp_2 = _S74;
    shown_0.hole_3 = ((!_S72) & (_S73));
    var _S75 : u32 = select(crossing_0.weft_word_0, crossing_0.warp_word_0, _S74);
    shown_0.word_0 = _S75;
    shown_0.on_top_0 = (((_S75 & (u32(1)))) == u32(1)) != back_3;
    return shown_0;
}

fn select_cell_0( is_first_0 : bool,  first_3 : Cell_0,  second_0 : Cell_0) -> Cell_0
{
    var cell_6 : Cell_0;
    cell_6.thread_1 = select(second_0.thread_1, first_3.thread_1, is_first_0);
    cell_6.across_0 = select(second_0.across_0, first_3.across_0, is_first_0);
    cell_6.half_width_1 = select(second_0.half_width_1, first_3.half_width_1, is_first_0);
    cell_6.below_0 = select(second_0.below_0, first_3.below_0, is_first_0);
    cell_6.above_0 = select(second_0.above_0, first_3.above_0, is_first_0);
    return cell_6;
}

fn boundary_0( family_9 : u32,  thread_4 : u32,  step_0 : i32) -> f32
{
    var _S76 : vec2<f32> = turns_and_remainder_0(family_9, f32(i32(thread_4) + step_0));
    return fma(_S76.x, families_0[family_9].period_0, table_number_0(families_0[family_9].place_table_0 + u32(_S76.y) * u32(4)));
}

fn span_0( family_10 : u32,  thread_5 : u32,  first_4 : i32,  last_0 : i32) -> f32
{
    if((families_0[family_10].is_alike_0) != u32(0))
    {
        return f32(last_0 - first_4) * families_0[family_10].size_0;
    }
    return boundary_0(family_10, thread_5, last_0) - boundary_0(family_10, thread_5, first_4);
}

struct Bend_0
{
     sine_0 : f32,
     half_tangent_0 : f32,
     arc_0 : f32,
};

fn bend_of_0( family_11 : u32,  thread_6 : u32) -> Bend_0
{
    var _S77 : u32 = families_0[family_11].bend_table_0 + select(thread_6 * u32(4), u32(0), (families_0[family_11].is_alike_0) != u32(0));
    var bend_0 : Bend_0;
    bend_0.sine_0 = table_number_0(_S77);
    bend_0.half_tangent_0 = table_number_0(_S77 + u32(1));
    bend_0.arc_0 = table_number_0(_S77 + u32(2));
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

fn unpack_0( own_0 : u32,  other_0 : u32,  thread_7 : u32,  crossed_0 : Cell_0,  word_1 : u32) -> Run_0
{
    var _S78 : i32 = i32((((word_1 >> (u32(1)))) & (u32(127))));
    var _S79 : i32 = i32((((word_1 >> (u32(8)))) & (u32(127))));
    var _S80 : i32 = i32((((word_1 >> (u32(15)))) & (u32(63))));
    var _S81 : i32 = i32((((word_1 >> (u32(21)))) & (u32(63))));
    var run_0 : Run_0;
    var _S82 : bool = ((((word_1 >> (u32(27)))) & (u32(1)))) == u32(1);
    run_0.straight_0 = _S82;
    var _S83 : i32 = - _S78;
    var _S84 : f32 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_1, _S83, i32(0));
    run_0.from_start_0 = _S84;
    var _S85 : i32 = _S79 + i32(1);
    var _S86 : f32 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_1, i32(1), _S85);
    run_0.to_end_0 = _S86;
    var _S87 : bool = _S84 < _S86;
    run_0.near_start_0 = _S87;
    var _S88 : i32 = select(_S85, _S83 - _S80, _S87);
    var _S89 : i32 = select(_S85 + _S81, _S83, _S87);
    run_0.bend_1 = bend_of_0(own_0, thread_7);
    run_0.distance_0 = select(min(_S84, _S86), 1.0e+06f, _S82);
    run_0.reach_0 = min(0.5f * (_S84 + _S86), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_1, _S88, _S89), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S78 == i32(0);
    run_0.last_crossing_0 = _S79 == i32(0);
    return run_0;
}

struct Section_0
{
     across_3 : f32,
     drop_0 : f32,
     slope_0 : f32,
};

fn section_at_0( cell_7 : Cell_0) -> Section_0
{
    var _S90 : f32 = cell_7.half_width_1 * 1.0154266357421875f;
    var section_0 : Section_0;
    var _S91 : f32 = clamp(cell_7.across_0, - cell_7.half_width_1, cell_7.half_width_1);
    section_0.across_3 = _S91;
    var _S92 : f32 = _S90 * _S90 - square_1(_S91);
    var _S93 : f32 = rsqrt_0(_S92);
    section_0.drop_0 = _S90 - _S92 * _S93;
    section_0.slope_0 = - _S91 * _S93;
    return section_0;
}

fn edge_drop_0( family_12 : u32,  thread_8 : u32,  step_1 : i32) -> f32
{
    return table_number_0(families_0[family_12].bend_table_0 + select(u32(turns_and_remainder_0(family_12, f32(i32(thread_8) + step_1)).y) * u32(4), u32(0), (families_0[family_12].is_alike_0) != u32(0)) + u32(3));
}

fn dive_0( other_1 : u32,  shown_1 : Shown_0,  run_1 : Run_0,  crossed_1 : Cell_0) -> vec3<f32>
{
    var _S94 : bool = (crossed_1.below_0) < (crossed_1.above_0);
    var _S95 : f32 = min(crossed_1.below_0, crossed_1.above_0);
    var _S96 : f32 = select(crossed_1.above_0 + crossed_1.across_0, crossed_1.below_0 - crossed_1.across_0, _S94) - crossed_1.half_width_1;
    var _S97 : bool = select(run_1.last_crossing_0, run_1.first_crossing_0, _S94);
    var _S98 : f32;
    if(shown_1.on_top_0)
    {
        _S98 = 0.0f;
    }
    else
    {
        _S98 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_1, i32(0));
    }
    var _S99 : f32;
    if((shown_1.on_top_0) != _S97)
    {
        _S99 = 0.0f;
    }
    else
    {
        _S99 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_1, select(i32(1), i32(-1), _S94));
    }
    var _S100 : f32 = 2.0f * _S96;
    var _S101 : f32 = 1.0f / max(_S100, 9.999999960041972e-13f);
    var _S102 : f32 = clamp((_S96 - _S95) * _S101, 0.0f, 1.0f);
    var _S103 : f32 = clamp((0.44999998807907104f - _S100 / crossed_1.half_width_1) * 4.0000004768371582f, 0.0f, 1.0f);
    return vec3<f32>(_S98 + (_S99 - _S98) * (_S102 * _S102 * (3.0f - 2.0f * _S102)), (_S98 - _S99) * (6.0f * _S102 * (1.0f - _S102) * _S101) * select(-1.0f, 1.0f, _S94), _S103 * _S103 * (3.0f - 2.0f * _S103));
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
    var _S104 : f32 = direction_2.x;
    control_0.per_x_0 = 1.0f / max(abs(_S104), 9.99999971718068537e-10f);
    var _S105 : f32 = direction_2.y;
    control_0.per_y_0 = 1.0f / max(abs(_S105), 9.99999971718068537e-10f);
    control_0.right_0 = _S104 > 0.0f;
    control_0.up_0 = _S105 > 0.0f;
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

fn outline_distance_0( cell_8 : Cell_0,  shown_2 : Shown_0,  run_2 : Run_0,  lengthwise_0 : bool,  forwards_0 : bool) -> f32
{
    var _S106 : f32 = select(- cell_8.across_0, cell_8.across_0, forwards_0);
    var _S107 : f32 = select(cell_8.below_0, cell_8.above_0, forwards_0);
    var _S108 : f32 = - cell_8.half_width_1;
    var _S109 : bool = _S106 < _S108;
    var _S110 : bool = _S106 >= (cell_8.half_width_1);
    var _S111 : bool = (((lengthwise_0 & ((!select(run_2.first_crossing_0, run_2.last_crossing_0, forwards_0))))) & ((!shown_2.hole_3)));
    var _S112 : f32 = select(cell_8.half_width_1, _S108, _S109) - _S106;
    var _S113 : f32 = select(_S107, 2.0f * _S107 + _S106 - cell_8.half_width_1, ((shown_2.hole_3) | (((_S111 & ((!shown_2.on_top_0)))))));
    if((((_S111 & ((shown_2.on_top_0)))) & ((!((select(run_2.last_crossing_0, run_2.first_crossing_0, forwards_0) & (_S109)))))))
    {
        return select(run_2.from_start_0, run_2.to_end_0, forwards_0);
    }
    return select(_S112, _S113, _S110);
}

struct Probe_0
{
     height_4 : f32,
     hole_4 : bool,
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
    var _S114 : f32 = previous_1.rate_0 * step_4;
    var _S115 : f32 = rate_1 * step_4;
    if(((((((((!previous_1.known_0) | ((here_0.hole_4)))) | (((previous_1.yarn_0) != (here_0.yarn_1))))) | (((previous_1.rate_0) >= 0.0f)))) | ((rate_1 <= 0.0f))))
    {
        return -1.0f;
    }
    if((((3.0f * previous_1.clearance_0 + _S114) >= 0.0f) & (((3.0f * clearance_1 - _S115) >= 0.0f))))
    {
        return -1.0f;
    }
    var _S116 : f32 = clearance_1 - previous_1.clearance_0;
    var _S117 : f32 = 6.0f * _S116 - 4.0f * _S114 - 2.0f * _S115;
    var _S118 : f32 = -2.0f * _S114 / max(_S117 + sqrt(max(_S117 * _S117 - 4.0f * (3.0f * (_S114 + _S115 - 2.0f * _S116)) * _S114, 0.0f)), 9.99999968265522539e-21f);
    var _S119 : f32 = 1.0f - _S118;
    return select(-1.0f, _S119 * step_4, ((((_S118 > 0.01999999955296516f) & ((_S119 > 0.01999999955296516f)))) & ((((previous_1.clearance_0 * (2.0f * _S118 + 1.0f) + _S114 * _S118) * _S119 * _S119 + (clearance_1 * (2.0f * _S119 + 1.0f) - _S115 * _S119) * _S118 * _S118) < 0.0f))));
}

fn after_sample_0( clearance_2 : f32,  rate_2 : f32,  here_1 : Probe_0,  is_cell_exit_0 : bool) -> PreviousSample_0
{
    var previous_2 : PreviousSample_0;
    previous_2.clearance_0 = select(clearance_2, 1.0e+09f, here_1.hole_4);
    previous_2.rate_0 = rate_2;
    previous_2.yarn_0 = here_1.yarn_1;
    previous_2.known_0 = ((!here_1.hole_4) & ((!is_cell_exit_0)));
    return previous_2;
}

fn StepControl_to_cell_exit_0( this_1 : StepControl_0,  side_x_1 : f32,  side_y_1 : f32) -> f32
{
    return max(min(side_x_1 * this_1.per_x_0, side_y_1 * this_1.per_y_0), 0.0f) + this_1.epsilon_0;
}

fn StepControl_to_next_sample_0( this_2 : StepControl_0,  here_2 : Probe_0,  clearance_3 : f32,  rate_3 : f32) -> f32
{
    var _S120 : f32 = min(here_2.edge_x_0 * this_2.per_x_0, here_2.edge_y_0 * this_2.per_y_0);
    return min(this_2.step_2, select(max(_S120, 0.0f) + this_2.epsilon_0, _S120 - this_2.epsilon_0, ((((!here_2.hole_4) & (((rate_3 * _S120 + clearance_3) < 0.0f)))) & ((_S120 > (2.0f * this_2.epsilon_0))))));
}

struct ViewRay_0
{
     origin_0 : vec2<f32>,
     slope_1 : vec2<f32>,
};

fn ViewRay_at_0( this_3 : ViewRay_0,  height_5 : f32) -> vec2<f32>
{
    return this_3.origin_0 + this_3.slope_1 * vec2<f32>(height_5);
}

fn ViewRay_rate_0( this_4 : ViewRay_0,  here_3 : Probe_0) -> f32
{
    return here_3.slope_x_0 * this_4.slope_1.x + here_3.slope_y_0 * this_4.slope_1.y - 1.0f;
}

fn cubic_root_0( start_1 : f32,  end_0 : f32,  start_rate_0 : f32,  end_rate_0 : f32) -> f32
{
    var _S121 : f32 = end_0 - start_1;
    var _S122 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S121;
    var _S123 : f32 = 3.0f * _S121 - 2.0f * start_rate_0 - end_rate_0;
    var share_1 : f32 = start_1 / max(- _S121, 9.99999968265522539e-21f);
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
        var _S124 : f32 = clamp(share_1 - (((_S122 * share_1 + _S123) * share_1 + start_rate_0) * share_1 + start_1) / min((3.0f * _S122 * share_1 + 2.0f * _S123) * share_1 + start_rate_0, 0.10000000149011612f * _S121 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S125 : i32 = i_0 + i32(1);
        share_1 = _S124;
        i_0 = _S125;
    }
    return share_1;
}

fn between_0( above_1 : f32,  under_0 : f32,  above_gap_0 : f32,  under_gap_0 : f32) -> f32
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

fn fibre_direction_0( across_slope_0 : f32,  along_slope_0 : f32,  sine_1 : f32,  cosine_0 : f32) -> vec2<f32>
{
    var _S126 : f32 = along_slope_0 * along_slope_0 + 1.0f;
    var _S127 : f32 = rsqrt_0(_S126);
    var _S128 : f32 = sine_1 * _S127 * rsqrt_0(_S126 + across_slope_0 * across_slope_0);
    return vec2<f32>(- _S128 * _S126, _S128 * across_slope_0 * along_slope_0 + cosine_0 * _S127);
}

fn arc_sine_0( x_10 : f32) -> f32
{
    var _S129 : f32 = abs(x_10);
    var _S130 : bool = _S129 > 0.5f;
    var _S131 : f32 = select(_S129 * _S129, 0.5f * (1.0f - _S129), _S130);
    var _S132 : f32 = select(_S129, sqrt(max(_S131, 0.0f)), _S130);
    var _S133 : f32 = ((((0.04216320067644119f * _S131 + 0.02418131195008755f) * _S131 + 0.04547002539038658f) * _S131 + 0.07495300471782684f) * _S131 + 0.16666752099990845f) * _S131 * _S132 + _S132;
    var _S134 : f32 = select(_S133, 1.57079637050628662f - 2.0f * _S133, _S130);
    return select(_S134, - _S134, x_10 < 0.0f);
}

fn run_share_0( word_2 : u32) -> f32
{
    var _S135 : f32 = f32(((((word_2 >> (u32(1)))) & (u32(127)))) + ((((word_2 >> (u32(8)))) & (u32(127)))) + u32(1));
    return _S135 / (_S135 + 0.5f * f32(((((word_2 >> (u32(15)))) & (u32(63)))) + ((((word_2 >> (u32(21)))) & (u32(63))))));
}

fn angle_of_0( direction_3 : vec2<f32>) -> f32
{
    var _S136 : f32 = direction_3.x;
    var _S137 : f32 = arc_sine_0(_S136);
    var _S138 : bool = _S136 < 0.0f;
    var _S139 : f32 = select(3.14159274101257324f, -3.14159274101257324f, _S138);
    var _S140 : f32 = direction_3.y;
    return select(0.5f * _S139 - select(1.0f, -1.0f, _S138) * arc_sine_0(_S140), select(_S137, _S139 - _S137, _S140 < 0.0f), (abs(_S136)) < 0.69999998807907104f);
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
    var _S141 : Albedos_0;
    _S141.diffuse_reflect_0 = diffuse_reflect_1;
    _S141.diffuse_transmit_0 = diffuse_transmit_1;
    _S141.specular_reflect_0 = specular_reflect_1;
    _S141.specular_transmit_0 = specular_transmit_1;
    return _S141;
}

struct Hairs_0
{
     place_1 : vec2<f32>,
     below_1 : f32,
     back_4 : bool,
     size_3 : f32,
};

fn Hairs_x24init_0( place_2 : vec2<f32>,  below_2 : f32,  back_5 : bool,  size_4 : f32) -> Hairs_0
{
    var _S142 : Hairs_0;
    _S142.place_1 = place_2;
    _S142.below_1 = below_2;
    _S142.back_4 = back_5;
    _S142.size_3 = size_4;
    return _S142;
}

struct YarnPoint_0
{
     back_6 : bool,
     hole_5 : bool,
     is_warp_3 : bool,
     x_11 : f32,
     y_4 : f32,
     height_6 : f32,
     normal_3 : vec3<f32>,
     tangent_2 : vec3<f32>,
     surface_normal_0 : vec3<f32>,
     diffuse_gain_0 : f32,
     roughness_1 : f32,
     albedos_0 : Albedos_0,
     hairs_0 : Hairs_0,
     hair_cover_0 : f32,
};

fn YarnPoint_x24init_0( back_7 : bool,  hole_6 : bool,  is_warp_4 : bool,  x_12 : f32,  y_5 : f32,  height_7 : f32,  normal_4 : vec3<f32>,  tangent_3 : vec3<f32>,  surface_normal_1 : vec3<f32>,  diffuse_gain_1 : f32,  roughness_2 : f32,  albedos_1 : Albedos_0,  hairs_1 : Hairs_0,  hair_cover_1 : f32) -> YarnPoint_0
{
    var _S143 : YarnPoint_0;
    _S143.back_6 = back_7;
    _S143.hole_5 = hole_6;
    _S143.is_warp_3 = is_warp_4;
    _S143.x_11 = x_12;
    _S143.y_4 = y_5;
    _S143.height_6 = height_7;
    _S143.normal_3 = normal_4;
    _S143.tangent_2 = tangent_3;
    _S143.surface_normal_0 = surface_normal_1;
    _S143.diffuse_gain_0 = diffuse_gain_1;
    _S143.roughness_1 = roughness_2;
    _S143.albedos_0 = albedos_1;
    _S143.hairs_0 = hairs_1;
    _S143.hair_cover_0 = hair_cover_1;
    return _S143;
}

struct Hair_0
{
     cover_1 : f32,
     normal_5 : vec3<f32>,
     tangent_4 : vec3<f32>,
     is_warp_5 : bool,
     shade_0 : f32,
};

fn Hair_x24init_0( cover_2 : f32,  normal_6 : vec3<f32>,  tangent_5 : vec3<f32>,  is_warp_6 : bool,  shade_1 : f32) -> Hair_0
{
    var _S144 : Hair_0;
    _S144.cover_1 = cover_2;
    _S144.normal_5 = normal_6;
    _S144.tangent_4 = tangent_5;
    _S144.is_warp_5 = is_warp_6;
    _S144.shade_0 = shade_1;
    return _S144;
}

fn share_of_0( bits_0 : u32) -> f32
{
    return (f32((bits_0 & (u32(1023)))) + 0.5f) * 0.0009765625f;
}

fn ply_offset_0( family_13 : u32,  point_1 : SurfacePoint_0,  back_8 : bool) -> f32
{
    var _S145 : f32 = (point_1.fibre_across_0 * families_0[family_13].ply_cosine_0 + point_1.fibre_along_0 * select(families_0[family_13].ply_sine_0, - families_0[family_13].ply_sine_0, back_8)) * families_0[family_13].plies_per_mm_0;
    return 2.0f * (_S145 - floor(_S145)) - 1.0f;
}

fn signed_noise_0( bits_1 : u32) -> f32
{
    return (f32((bits_1 & (u32(65535)))) + 0.5f) * 0.000030517578125f - 1.0f;
}

fn smooth_share_0( share_2 : f32) -> f32
{
    return share_2 * share_2 * (3.0f - 2.0f * share_2);
}

fn wave_noise_0( key_4 : u32,  position_5 : f32) -> vec2<f32>
{
    var _S146 : f32 = floor(position_5);
    var _S147 : f32 = position_5 - _S146;
    var _S148 : u32 = u32(i32(_S146));
    var _S149 : f32 = signed_noise_0(hash_bits_0(key_4, _S148));
    var _S150 : f32 = signed_noise_0(hash_bits_0(key_4, _S148 + u32(1)));
    return vec2<f32>(mix(_S149, _S150, smooth_share_0(_S147)), 6.0f * _S147 * (1.0f - _S147) * (_S150 - _S149));
}

fn fibre_cell_0( across_4 : f32,  along_1 : f32,  width_2 : f32) -> vec3<f32>
{
    var _S151 : f32 = floor(across_4 / width_2);
    return vec3<f32>(_S151, along_1 / (width_2 * 40.0f) + 0.61799997091293335f * _S151, 2.0f * (across_4 / width_2 - _S151) - 1.0f);
}

fn cell_noise_0( key_5 : u32,  cell_9 : vec3<f32>) -> vec2<f32>
{
    var _S152 : f32 = cell_9.y;
    var _S153 : f32 = floor(_S152);
    var _S154 : u32 = u32(i32(cell_9.x)) * u32(65536) + u32(i32(_S153));
    var _S155 : u32 = hash_bits_0(key_5, _S154);
    var _S156 : u32 = hash_bits_0(key_5, _S154 + u32(1));
    return mix(vec2<f32>(signed_noise_0(_S155), signed_noise_0((_S155 >> (u32(16))))), vec2<f32>(signed_noise_0(_S156), signed_noise_0((_S156 >> (u32(16))))), vec2<f32>(smooth_share_0(_S152 - _S153)));
}

struct YarnFrame_0
{
     normal_7 : vec3<f32>,
     tangent_6 : vec3<f32>,
     loss_0 : f32,
     shade_2 : f32,
};

fn under_hair_0( frame_0 : YarnFrame_0,  hair_0 : Hair_0) -> YarnFrame_0
{
    var _S157 : vec3<f32> = select_vector_1((dot(frame_0.tangent_6, hair_0.tangent_4)) < 0.0f, (vec3<f32>(0) - hair_0.tangent_4), hair_0.tangent_4);
    var blended_0 : YarnFrame_0;
    var _S158 : vec3<f32> = vec3<f32>(hair_0.cover_1);
    var _S159 : vec3<f32> = normalize(mix(frame_0.normal_7, hair_0.normal_5, _S158));
    blended_0.normal_7 = _S159;
    var _S160 : vec3<f32> = mix(frame_0.tangent_6, _S157, _S158);
    var _S161 : vec3<f32> = _S160 - vec3<f32>(dot(_S160, _S159)) * _S159;
    blended_0.tangent_6 = _S161 * vec3<f32>(rsqrt_0(max(dot(_S161, _S161), 9.999999960041972e-13f)));
    blended_0.loss_0 = frame_0.loss_0 * (1.0f - hair_0.cover_1);
    blended_0.shade_2 = hair_0.shade_0;
    return blended_0;
}

fn diffuse_gain_2( frame_1 : YarnFrame_0,  blend_0 : f32) -> f32
{
    return min(0.85000002384185791f * blend_0 * frame_1.loss_0 + 1.0f + frame_1.shade_2, 1.0f / (0.5f * blend_0 * (frame_1.normal_7.z - 1.0f) + 1.0f));
}

fn diffuse_reflection_0( light_1 : vec3<f32>,  normal_8 : vec3<f32>,  blend_1 : f32) -> f32
{
    var _S162 : f32 = light_1.z;
    if(_S162 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S162, 0.0f), max(dot(light_1, normal_8), 0.0f), blend_1);
}

fn projected_area_1( direction_4 : vec3<f32>,  tangent_7 : vec3<f32>,  roughness_3 : f32) -> f32
{
    var _S163 : f32 = dot(direction_4, tangent_7);
    return sqrt(max((roughness_3 + 1.0f) * (roughness_3 - 1.0f) * _S163 * _S163 + 1.0f, roughness_3 * roughness_3));
}

fn mean_attenuation_0( depth_0 : f32) -> f32
{
    if(depth_0 < 0.10000000149011612f)
    {
        return (((depth_0 / 120.0f - 0.0416666679084301f) * depth_0 + 0.1666666716337204f) * depth_0 - 0.5f) * depth_0 + 1.0f;
    }
    return (1.0f - exponential_0(- depth_0)) / depth_0;
}

fn flake_density_0( squared_along_0 : f32,  roughness_4 : f32) -> f32
{
    var _S164 : f32 = roughness_4 * roughness_4;
    var _S165 : f32 = squared_along_0 * (1.0f - _S164) + _S164;
    return 0.31830987334251404f * _S164 * roughness_4 / (_S165 * _S165);
}

fn density_between_0( light_2 : vec3<f32>,  view_1 : vec3<f32>,  tangent_8 : vec3<f32>,  roughness_5 : f32) -> f32
{
    var _S166 : vec3<f32> = light_2 + view_1;
    var _S167 : f32 = dot(_S166, tangent_8);
    return flake_density_0(min(_S167 * _S167 / max(square_0(_S166), 9.999999960041972e-13f), 1.0f), roughness_5);
}

fn transmission_1( light_3 : vec3<f32>,  view_2 : vec3<f32>,  normal_9 : vec3<f32>,  tangent_9 : vec3<f32>,  roughness_6 : f32,  optical_depth_1 : f32) -> f32
{
    var _S168 : f32 = - dot(light_3, normal_9);
    var _S169 : f32 = dot(view_2, normal_9);
    if(((_S168 <= 0.0f) | ((_S169 <= 0.0f))))
    {
        return 0.0f;
    }
    var _S170 : f32 = 1.0f / max(_S169, 9.99999997475242708e-07f);
    var _S171 : f32 = projected_area_1(light_3, tangent_9, roughness_6) / max(_S168, 9.99999997475242708e-07f);
    var _S172 : f32 = projected_area_1(view_2, tangent_9, roughness_6) * _S170;
    return density_between_0(light_3, view_2, tangent_9, roughness_6) * 0.25f * optical_depth_1 * exponential_0(- optical_depth_1 * min(_S171, _S172)) * mean_attenuation_0(optical_depth_1 * abs(_S171 - _S172)) * _S170;
}

fn reflection_0( light_4 : vec3<f32>,  view_3 : vec3<f32>,  normal_10 : vec3<f32>,  tangent_10 : vec3<f32>,  roughness_7 : f32,  optical_depth_2 : f32) -> f32
{
    var _S173 : f32 = dot(light_4, normal_10);
    var _S174 : f32 = dot(view_3, normal_10);
    if(((_S173 <= 0.0f) | ((_S174 <= 0.0f))))
    {
        return 0.0f;
    }
    var _S175 : f32 = max(_S173, 9.99999997475242708e-07f);
    var _S176 : f32 = max(_S174, 9.99999997475242708e-07f);
    var _S177 : f32 = projected_area_1(light_4, tangent_10, roughness_7) * _S176 + projected_area_1(view_3, tangent_10, roughness_7) * _S175;
    var _S178 : f32 = optical_depth_2 * _S177 / (_S175 * _S176);
    return 0.25f * density_between_0(light_4, view_3, tangent_10, roughness_7) * (_S178 * mean_attenuation_0(_S178)) * _S175 / _S177;
}

fn with_added_0( sums_2 : Components_0,  more_0 : Components_0,  weight_1 : f32) -> Components_0
{
    var result_0 : Components_0;
    result_0.diffuse_warp_0 = sums_2.diffuse_warp_0 + weight_1 * more_0.diffuse_warp_0;
    result_0.diffuse_weft_0 = sums_2.diffuse_weft_0 + weight_1 * more_0.diffuse_weft_0;
    result_0.specular_warp_0 = sums_2.specular_warp_0 + weight_1 * more_0.specular_warp_0;
    result_0.specular_weft_0 = sums_2.specular_weft_0 + weight_1 * more_0.specular_weft_0;
    result_0.light_visibility_1 = sums_2.light_visibility_1 + weight_1 * more_0.light_visibility_1;
    result_0.hole_2 = sums_2.hole_2 + weight_1 * more_0.hole_2;
    return result_0;
}

fn scaled_0( blocked_0 : Blocked_0,  share_3 : f32) -> Blocked_0
{
    var result_1 : Blocked_0;
    result_1.by_warp_0 = share_3 * blocked_0.by_warp_0;
    result_1.by_weft_0 = share_3 * blocked_0.by_weft_0;
    result_1.far_0 = share_3 * blocked_0.far_0;
    return result_1;
}

fn wrapped_cell_0( position_6 : f32,  count_2 : f32) -> f32
{
    return min(floor((position_6 - floor(position_6)) * count_2), count_2 - 1.0f);
}

fn arc_tangent_quotient_0( x_13 : f32,  y_6 : f32) -> f32
{
    return ((((((0.0f * x_13 + 0.00809729471802711f) * x_13 + -0.0377517081797123f) * x_13 + 0.08475969731807709f) * x_13 + -0.13537675142288208f) * x_13 + 0.19895026087760925f) * x_13 + -0.33327975869178772f) * x_13 + 0.99999970197677612f;
}

fn arc_tangent_of_ratio_0( ratio_0 : f32) -> f32
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0f);
}

fn arc_tangent_0( y_7 : f32,  x_14 : f32) -> f32
{
    var _S179 : f32 = abs(x_14);
    var _S180 : f32 = abs(y_7);
    var angle_0 : f32 = arc_tangent_of_ratio_0(min(_S179, _S180) / max(max(_S179, _S180), 1.00000000317107685e-30f));
    var angle_1 : f32 = select(angle_0, 1.57079637050628662f - angle_0, _S180 > _S179);
    var angle_2 : f32 = select(angle_1, 3.14159274101257324f - angle_1, x_14 < 0.0f);
    return select(angle_2, - angle_2, y_7 < 0.0f);
}

struct NodeTaps_0
{
     nodes_0 : vec4<u32>,
     weights_0 : vec4<u32>,
     inverse_sum_0 : f32,
};

fn node_taps_of_0( direction_5 : vec3<f32>,  azimuths_0 : u32) -> NodeTaps_0
{
    var _S181 : f32 = arc_tangent_0(direction_5.y, direction_5.x) * (0.5f * f32(azimuths_0) * 0.31830987334251404f);
    var _S182 : f32 = floor(_S181);
    var _S183 : f32 = _S181 - _S182;
    var _S184 : f32 = sqrt(clamp((1.0f - abs(direction_5.z)) / 0.97000002861022949f, 0.0f, 1.0f));
    var _S185 : f32 = 7.0f * _S184 * sqrt(_S184);
    var _S186 : f32 = min(floor(_S185), 6.0f);
    var _S187 : f32 = _S185 - _S186;
    var _S188 : u32 = u32(i32(_S182) + i32(azimuths_0)) % azimuths_0;
    var _S189 : u32 = u32(_S186);
    var _S190 : u32 = _S188 * u32(8) + _S189;
    var _S191 : u32 = (_S188 + u32(1)) % azimuths_0;
    var _S192 : u32 = _S191 * u32(8) + _S189;
    var taps_0 : NodeTaps_0;
    taps_0.nodes_0 = vec4<u32>(_S190, _S190 + u32(1), _S192, _S192 + u32(1));
    var _S193 : f32 = 1.0f - _S183;
    var _S194 : f32 = 1.0f - _S187;
    var _S195 : vec4<u32> = vec4<u32>(vec4<f32>(_S193 * _S194, _S193 * _S187, _S183 * _S194, _S183 * _S187) * vec4<f32>(252.0f) + vec4<f32>(0.5f));
    taps_0.weights_0 = _S195;
    taps_0.inverse_sum_0 = 1.0f / f32(_S195.x + _S195.y + _S195.z + _S195.w);
    return taps_0;
}

fn node_taps_0( direction_6 : vec3<f32>) -> NodeTaps_0
{
    var _S196 : NodeTaps_0 = node_taps_of_0(direction_6, u32(32));
    return _S196;
}

fn half_vector_0( light_5 : vec3<f32>,  view_4 : vec3<f32>) -> vec3<f32>
{
    var _S197 : vec3<f32> = light_5 + view_4;
    return _S197 * vec3<f32>(rsqrt_0(max(square_0(_S197), 9.999999960041972e-13f)));
}

fn joint_terms_0( taps_1 : NodeTaps_0,  table_1 : u32,  ratio_1 : u32) -> vec4<f32>
{
    var _S198 : vec4<f32> = vec4<f32>(0.0f);
    var i_1 : u32 = u32(0);
    var sums_3 : vec4<f32> = _S198;
    for(;;)
    {
        if(i_1 < u32(4))
        {
        }
        else
        {
            break;
        }
        var _S199 : u32 = table_1 + u32(4) * taps_1.nodes_0[i_1] + u32(2) * ratio_1;
        var _S200 : vec2<u32> = vec2<u32>(words_0[_S199], words_0[_S199 + u32(1)]);
        var sums_4 : vec4<f32> = sums_3 + vec4<f32>(((vec4<i32>(vec2<i32>((_S200 << (vec2<u32>(u32(16))))), vec2<i32>(_S200)).xzyw) >> (vec4<u32>(u32(16))))) * vec4<f32>(f32(taps_1.weights_0[i_1]));
        i_1 = i_1 + u32(1);
        sums_3 = sums_4;
    }
    return sums_3 * vec4<f32>((taps_1.inverse_sum_0 / 4096.0f));
}

fn bytes_of_sums_0( even_0 : u32,  odd_0 : u32) -> vec4<f32>
{
    return vec4<f32>(f32((even_0 & (u32(65535)))), f32((odd_0 & (u32(65535)))), f32((even_0 >> (u32(16)))), f32((odd_0 >> (u32(16)))));
}

fn interpolate_0( taps_2 : NodeTaps_0,  packs_1 : vec4<u32>) -> vec4<f32>
{
    var _S201 : vec4<u32> = vec4<u32>(u32(16711935));
    var _S202 : vec4<u32> = ((packs_1 & (_S201))) * taps_2.weights_0;
    var _S203 : vec4<u32> = ((((packs_1 >> (vec4<u32>(u32(8))))) & (_S201))) * taps_2.weights_0;
    return bytes_of_sums_0(_S202.x + _S202.y + _S202.z + _S202.w, _S203.x + _S203.y + _S203.z + _S203.w) * vec4<f32>(taps_2.inverse_sum_0);
}

fn interpolate_table_0( taps_3 : NodeTaps_0,  table_2 : u32,  stride_0 : u32) -> vec4<f32>
{
    var _S204 : vec4<u32> = vec4<u32>(table_2) + taps_3.nodes_0 * vec4<u32>(stride_0);
    return interpolate_0(taps_3, vec4<u32>(words_0[_S204.x], words_0[_S204.y], words_0[_S204.z], words_0[_S204.w]));
}

struct Group_0
{
     normal_11 : vec3<f32>,
     weight_2 : f32,
     tangent_11 : vec3<f32>,
     variance_0 : vec3<f32>,
     covariance_0 : vec3<f32>,
     roughness_8 : f32,
};

fn group_at_0( row_1 : u32,  roughness_9 : f32) -> Group_0
{
    var group_0 : Group_0;
    group_0.normal_11 = vec3<f32>(table_number_0(row_1), table_number_0(row_1 + u32(1)), table_number_0(row_1 + u32(2)));
    group_0.weight_2 = table_number_0(row_1 + u32(3));
    var _S205 : vec3<f32> = vec3<f32>(table_number_0(row_1 + u32(4)), table_number_0(row_1 + u32(5)), table_number_0(row_1 + u32(6)));
    group_0.tangent_11 = _S205;
    var _S206 : f32 = table_number_0(row_1 + u32(7));
    var _S207 : f32 = table_number_0(row_1 + u32(8));
    group_0.variance_0 = vec3<f32>(_S206, _S207, 1.0f - square_0(_S205) - _S206 - _S207);
    group_0.covariance_0 = vec3<f32>(table_number_0(row_1 + u32(9)), table_number_0(row_1 + u32(10)), table_number_0(row_1 + u32(11)));
    group_0.roughness_8 = roughness_9;
    return group_0;
}

fn Group_variance_along_0( this_5 : Group_0,  direction_7 : vec3<f32>) -> f32
{
    var _S208 : f32 = direction_7.x;
    var _S209 : f32 = direction_7.y;
    var _S210 : f32 = direction_7.z;
    return max(dot(this_5.variance_0, direction_7 * direction_7) + 2.0f * dot(this_5.covariance_0, vec3<f32>(_S208 * _S209, _S208 * _S210, _S209 * _S210)), 0.0f);
}

fn mean_area_0( group_1 : Group_0,  direction_8 : vec3<f32>) -> f32
{
    var _S211 : f32 = dot(direction_8, group_1.tangent_11);
    var _S212 : f32 = group_1.roughness_8;
    var _S213 : f32 = _S212 * _S212;
    return sqrt(max((_S213 - 1.0f) * (_S211 * _S211 + Group_variance_along_0(group_1, direction_8)) + 1.0f, _S213));
}

fn mean_density_0( group_2 : Group_0,  half_0 : vec3<f32>) -> f32
{
    var _S214 : f32 = group_2.roughness_8;
    var _S215 : f32 = max(sqrt(max(1.0f - _S214 * _S214, 0.0f)) / group_2.roughness_8, 0.00100000004749745f);
    var _S216 : f32 = max(sqrt(3.0f * Group_variance_along_0(group_2, half_0)), group_2.roughness_8 * 0.01999999955296516f + 0.00009999999747379f);
    var _S217 : f32 = dot(half_0, group_2.tangent_11);
    var _S218 : f32 = _S215 * (_S217 - _S216);
    var _S219 : f32 = _S215 * (_S217 + _S216);
    var _S220 : f32 = _S218 * _S219;
    var _S221 : f32 = 2.0f * _S216 * _S215;
    return 0.15915493667125702f / group_2.roughness_8 * ((1.0f - _S220) / ((_S218 * _S218 + 1.0f) * (_S219 * _S219 + 1.0f)) + arc_tangent_0(_S221, 1.0f + _S220) / _S221);
}

fn layer_value_0( group_3 : Group_0,  half_1 : vec3<f32>,  light_6 : vec3<f32>,  view_5 : vec3<f32>,  optical_depth_3 : f32) -> f32
{
    var _S222 : bool = (light_6.z) < 0.0f;
    var _S223 : f32 = dot(light_6, group_3.normal_11);
    var _S224 : f32 = max(dot(view_5, group_3.normal_11), 0.01999999955296516f);
    var _S225 : f32 = mean_area_0(group_3, light_6) / max(select(_S223, - _S223, _S222), 0.01999999955296516f);
    var _S226 : f32 = mean_area_0(group_3, view_5) / _S224;
    var _S227 : f32 = optical_depth_3 * max(select(_S225 + _S226, abs(_S225 - _S226), _S222), 0.00100000004749745f);
    return 0.25f * mean_density_0(group_3, half_1) * select(1.0f - 0.34999999403953552f * (1.0f - square_0(group_3.normal_11)), 1.0f, _S222) * (optical_depth_3 * select(1.0f, exponential_0(- optical_depth_3 * min(_S225, _S226)), _S222) * (1.0f - exponential_0(- _S227)) / _S227 / _S224);
}

struct Yarns_0
{
     warp_3 : vec4<f32>,
     weft_3 : vec4<f32>,
     shares_0 : vec3<f32>,
};

fn Yarns_x24init_0( warp_4 : vec4<f32>,  weft_4 : vec4<f32>,  shares_1 : vec3<f32>) -> Yarns_0
{
    var _S228 : Yarns_0;
    _S228.warp_3 = warp_4;
    _S228.weft_3 = weft_4;
    _S228.shares_0 = shares_1;
    return _S228;
}

fn irregular_over_0( family_14 : u32,  key_6 : u32,  place_3 : f32,  width_3 : f32,  along_2 : f32,  length_0 : f32) -> vec4<f32>
{
    var _S229 : f32 = max(width_3, 0.0625f);
    var _S230 : f32 = min(_S229, 64.0f);
    var _S231 : f32 = max(length_0 / 2.0f, 1.0f);
    var _S232 : f32 = along_2 / 2.0f - 0.5f * _S231;
    var _S233 : f32 = 0.5f * _S230;
    var _S234 : vec2<f32> = floor(vec2<f32>(place_3 - _S233, place_3 + _S233) / vec2<f32>(64.0f));
    var _S235 : vec4<f32> = vec4<f32>(0.0f);
    var number_2 : u32 = u32(0);
    var sums_5 : vec4<f32> = _S235;
    for(;;)
    {
        if(number_2 < u32(6))
        {
        }
        else
        {
            break;
        }
        var _S236 : bool = number_2 >= u32(3);
        var _S237 : u32 = select(number_2, number_2 - u32(3), _S236);
        var _S238 : f32 = select(-1.0f, 1.0f, _S236);
        var _S239 : f32 = _S234.y;
        var _S240 : f32 = _S234.x;
        var _S241 : f32 = select(_S240, _S239, _S236);
        var _S242 : f32 = place_3 + _S238 * 0.5f * _S230 - 64.0f * _S241;
        var _S243 : f32 = clamp(floor(_S242), 0.0f, 63.0f);
        var _S244 : f32 = _S242 - _S243;
        var _S245 : f32 = select(select(64.0f, 0.0f, _S236), _S243 + f32(_S237), _S237 < u32(2));
        var _S246 : f32 = _S238 * select(select(select(0.0f, -1.0f, _S240 != _S239), _S244, _S237 == u32(1)), 1.0f - _S244, _S237 == u32(0));
        if(_S246 == 0.0f)
        {
            number_2 = number_2 + u32(1);
            continue;
        }
        var _S247 : u32 = hash_bits_0(key_6, u32(i32(_S241)));
        sums_5 = sums_5 + vec4<f32>(_S246) * irregular_integral_0(family_14, ((_S247 & (u32(127)))) + u32(_S245), _S232 + f32((_S247 >> (u32(22)))), _S231);
        number_2 = number_2 + u32(1);
    }
    return sums_5 * irregular_units_0(family_14) * vec4<f32>((sqrt(_S230 / _S229) / (_S230 * _S231)));
}

fn shown_of_covers_0( covers_0 : vec2<f32>,  warp_on_top_1 : f32) -> vec3<f32>
{
    var _S248 : f32 = covers_0.x;
    var _S249 : f32 = covers_0.y;
    return vec3<f32>(_S248 * (1.0f - _S249 * (1.0f - warp_on_top_1)), _S249 * (1.0f - _S248 * warp_on_top_1), (1.0f - _S248) * (1.0f - _S249));
}

struct Bound_0
{
     thread_9 : u32,
     turns_2 : f32,
     cell_10 : f32,
     visible_0 : f32,
     width_4 : f32,
     gap_0 : f32,
};

fn bound_at_0( family_15 : u32,  position_7 : f32) -> Bound_0
{
    var _S250 : Cell_0 = locate_0(family_15, position_7);
    var _S251 : f32 = table_number_0(families_0[family_15].before_0 + u32(2) * _S250.thread_1 + u32(1));
    var bound_0 : Bound_0;
    bound_0.thread_9 = _S250.thread_1;
    bound_0.turns_2 = round((position_7 - families_0[family_15].start_0 - _S251 - _S250.below_0) * families_0[family_15].inverse_period_0);
    bound_0.cell_10 = _S250.below_0;
    var _S252 : f32 = 2.0f * _S250.half_width_1;
    bound_0.width_4 = _S252;
    bound_0.visible_0 = clamp((_S250.across_0 + _S250.half_width_1) / _S252, 0.0f, 1.0f);
    bound_0.gap_0 = min(_S250.below_0, _S250.below_0 - _S250.across_0 - _S250.half_width_1) + max(_S250.across_0 - _S250.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
     low_1 : Bound_0,
     high_1 : Bound_0,
};

fn stretch_of_0( family_16 : u32,  centre_1 : f32,  size_5 : f32) -> Stretch_0
{
    var _S253 : f32 = centre_1 - floor((centre_1 - families_0[family_16].start_0) * families_0[family_16].inverse_period_0) * families_0[family_16].period_0;
    var _S254 : f32 = 0.5f * max(size_5, families_0[family_16].smallest_box_0);
    var stretch_0 : Stretch_0;
    stretch_0.low_1 = bound_at_0(family_16, _S253 - _S254);
    stretch_0.high_1 = bound_at_0(family_16, _S253 + _S254);
    return stretch_0;
}

fn table_colour_0( index_6 : u32) -> vec3<f32>
{
    return vec3<f32>(table_number_0(index_6), table_number_0(index_6 + u32(1)), table_number_0(index_6 + u32(2)));
}

fn table_albedos_0( row_2 : u32) -> Albedos_0
{
    var albedos_2 : Albedos_0;
    albedos_2.diffuse_reflect_0 = table_colour_0(row_2);
    albedos_2.diffuse_transmit_0 = table_colour_0(row_2 + u32(3));
    albedos_2.specular_reflect_0 = table_colour_0(row_2 + u32(6));
    albedos_2.specular_transmit_0 = table_colour_0(row_2 + u32(9));
    return albedos_2;
}

fn Stretch_turns_0( this_6 : Stretch_0) -> f32
{
    return this_6.high_1.turns_2 - this_6.low_1.turns_2;
}

fn lengths_0( family_17 : u32,  stretch_1 : Stretch_0) -> vec3<f32>
{
    var _S255 : f32 = Stretch_turns_0(stretch_1);
    var _S256 : u32 = families_0[family_17].before_0 + u32(2) * stretch_1.low_1.thread_9;
    var _S257 : u32 = families_0[family_17].before_0 + u32(2) * stretch_1.high_1.thread_9;
    var _S258 : f32 = table_number_0(_S257) - table_number_0(_S256);
    var _S259 : f32 = table_number_0(_S257 + u32(1)) - table_number_0(_S256 + u32(1));
    return vec3<f32>(_S258 + stretch_1.high_1.visible_0 * stretch_1.high_1.width_4 - stretch_1.low_1.visible_0 * stretch_1.low_1.width_4 + _S255 * families_0[family_17].visible_total_0, _S259 - _S258 + stretch_1.high_1.gap_0 - stretch_1.low_1.gap_0 + _S255 * (families_0[family_17].period_0 - families_0[family_17].visible_total_0), _S259 + stretch_1.high_1.cell_10 - stretch_1.low_1.cell_10 + _S255 * families_0[family_17].period_0);
}

fn integrals_along_0( family_18 : u32,  stretch_2 : Stretch_0,  quantity_0 : u32) -> vec2<f32>
{
    var _S260 : u32 = u32(3) * families_0[family_18].quantities_0;
    var _S261 : u32 = families_0[family_18].colour_threads_0 + _S260 * stretch_2.low_1.thread_9 + quantity_0;
    var _S262 : u32 = families_0[family_18].colour_threads_0 + _S260 * stretch_2.high_1.thread_9 + quantity_0;
    var _S263 : u32 = families_0[family_18].colour_threads_0 + _S260 * u32(families_0[family_18].count_0) + quantity_0;
    var _S264 : f32 = table_number_0(_S261);
    var _S265 : f32 = table_number_0(_S262);
    var _S266 : f32 = Stretch_turns_0(stretch_2);
    var _S267 : u32 = u32(2) * families_0[family_18].quantities_0;
    return vec2<f32>(table_number_0(_S262 + families_0[family_18].quantities_0) - table_number_0(_S261 + families_0[family_18].quantities_0) + _S265 * stretch_2.high_1.visible_0 * stretch_2.high_1.width_4 - _S264 * stretch_2.low_1.visible_0 * stretch_2.low_1.width_4 + _S266 * table_number_0(_S263 + families_0[family_18].quantities_0), table_number_0(_S262 + _S267) - table_number_0(_S261 + _S267) + _S265 * stretch_2.high_1.cell_10 - _S264 * stretch_2.low_1.cell_10 + _S266 * table_number_0(_S263 + _S267));
}

fn Stretch_wraps_0( this_7 : Stretch_0) -> bool
{
    return (this_7.high_1.thread_9) < (this_7.low_1.thread_9);
}

fn Stretch_differences_0( this_8 : Stretch_0,  entries_0 : vec4<u32>,  whole_0 : u32) -> vec4<u32>
{
    var _S268 : u32 = entries_0.z;
    var _S269 : u32 = entries_0.x;
    return vec4<u32>(_S268 - _S269 + select(u32(0), whole_0, Stretch_wraps_0(this_8)), entries_0.w - _S268, entries_0.y - _S269, whole_0);
}

fn row_differences_0( across_5 : Stretch_0,  row_3 : u32,  count_3 : u32,  quantities_1 : u32) -> vec4<u32>
{
    var _S270 : u32 = row_3 + across_5.low_1.thread_9 * quantities_1;
    var _S271 : u32 = row_3 + across_5.high_1.thread_9 * quantities_1;
    return Stretch_differences_0(across_5, vec4<u32>(words_0[_S270], words_0[_S270 + quantities_1], words_0[_S271], words_0[_S271 + quantities_1]), words_0[row_3 + count_3 * quantities_1]);
}

fn Stretch_weights_0( this_9 : Stretch_0) -> vec4<f32>
{
    return vec4<f32>(1.0f, this_9.high_1.visible_0, - this_9.low_1.visible_0, Stretch_turns_0(this_9) - select(0.0f, 1.0f, Stretch_wraps_0(this_9)));
}

fn integral_on_top_0( family_19 : u32,  across_6 : Stretch_0,  along_3 : Stretch_0,  crossing_count_0 : u32,  quantity_1 : u32) -> f32
{
    var _S272 : u32 = u32(families_0[family_19].count_0);
    var _S273 : u32 = (_S272 + u32(1)) * families_0[family_19].quantities_0;
    var _S274 : u32 = families_0[family_19].colour_areas_0 + quantity_1;
    var _S275 : vec4<u32> = row_differences_0(across_6, _S274 + along_3.low_1.thread_9 * _S273, _S272, families_0[family_19].quantities_0);
    var _S276 : vec4<u32> = row_differences_0(across_6, _S274 + along_3.high_1.thread_9 * _S273, _S272, families_0[family_19].quantities_0);
    var _S277 : vec4<u32> = row_differences_0(across_6, _S274 + crossing_count_0 * _S273, _S272, families_0[family_19].quantities_0);
    var _S278 : vec4<f32> = Stretch_weights_0(across_6);
    return dot(vec4<f32>(dot(vec4<f32>(vec4<i32>(_S276 - _S275 + select_vector_2(Stretch_wraps_0(along_3), _S277, vec4<u32>(vec4<i32>(i32(0)))))), _S278), dot(vec4<f32>(vec4<i32>(row_differences_0(across_6, _S274 + (along_3.high_1.thread_9 + u32(1)) * _S273, _S272, families_0[family_19].quantities_0) - _S276)), _S278), dot(vec4<f32>(vec4<i32>(row_differences_0(across_6, _S274 + (along_3.low_1.thread_9 + u32(1)) * _S273, _S272, families_0[family_19].quantities_0) - _S275)), _S278), dot(vec4<f32>(vec4<i32>(_S277)), _S278)), Stretch_weights_0(along_3)) * families_0[family_19].area_unit_0;
}

fn with_added_albedos_0( albedos_3 : Albedos_0,  weight_3 : f32,  row_4 : u32) -> Albedos_0
{
    var _S279 : Albedos_0 = table_albedos_0(row_4);
    var sum_0 : Albedos_0;
    var _S280 : vec3<f32> = vec3<f32>(weight_3);
    sum_0.diffuse_reflect_0 = albedos_3.diffuse_reflect_0 + _S280 * _S279.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_3.diffuse_transmit_0 + _S280 * _S279.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_3.specular_reflect_0 + _S280 * _S279.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_3.specular_transmit_0 + _S280 * _S279.specular_transmit_0;
    return sum_0;
}

fn mean_albedos_0( family_20 : u32,  crossing_1 : u32,  own_1 : Stretch_0,  other_2 : Stretch_0,  back_9 : bool) -> Albedos_0
{
    var albedos_4 : Albedos_0 = table_albedos_0(families_0[family_20].colour_mean_0);
    if((families_0[family_20].quantities_0) == u32(1))
    {
        return albedos_4;
    }
    var _S281 : vec3<f32> = lengths_0(crossing_1, other_2);
    var is_exposed_0 : bool = false;
    var weight_4 : f32 = 0.0f;
    var quantity_2 : u32 = u32(0);
    for(;;)
    {
        if(quantity_2 < (families_0[family_20].quantities_0))
        {
        }
        else
        {
            break;
        }
        var _S282 : vec2<f32> = integrals_along_0(family_20, own_1, quantity_2);
        var _S283 : f32 = integral_on_top_0(family_20, own_1, other_2, u32(families_0[crossing_1].count_0), quantity_2);
        var _S284 : f32 = _S282.x;
        var _S285 : f32 = _S284 * _S281.x;
        var _S286 : f32 = select(_S283, _S285 - _S283, back_9);
        var _S287 : bool = quantity_2 == u32(0);
        if(_S287)
        {
            is_exposed_0 = _S286 > (16.0f * families_0[family_20].area_unit_0 * min(_S285 / families_0[family_20].crossing_area_0, 1.0f) + 0.00000999999974738f * _S285);
        }
        var _S288 : f32 = _S284 * _S281.y + select(0.0f, _S286, is_exposed_0) + 0.000244140625f * _S281.z * _S282.y;
        if(_S287)
        {
            weight_4 = 1.0f / max(_S288, 9.99999968265522539e-21f);
        }
        else
        {
            albedos_4 = with_added_albedos_0(albedos_4, _S288 * weight_4, families_0[family_20].colour_axes_0 + u32(12) * (quantity_2 - u32(1)));
        }
        quantity_2 = quantity_2 + u32(1);
    }
    albedos_4.diffuse_reflect_0 = saturate(albedos_4.diffuse_reflect_0);
    albedos_4.diffuse_transmit_0 = saturate(albedos_4.diffuse_transmit_0);
    albedos_4.specular_reflect_0 = saturate(albedos_4.specular_reflect_0);
    albedos_4.specular_transmit_0 = saturate(albedos_4.specular_transmit_0);
    return albedos_4;
}

fn groove_0( depth_1 : f32,  offset_1 : f32) -> vec2<f32>
{
    return vec2<f32>(depth_1) * vec2<f32>(0.1111111119389534f - square_1(square_1(square_1(offset_1))), 0.1111111119389534f);
}

fn thread_gain_0( thread_10 : u32,  amount_0 : f32,  seed_1 : u32) -> f32
{
    return amount_0 * (2.0f * uniform_hash_0(thread_10, u32(0), (seed_1 ^ (u32(2135587861)))) - 1.0f) + 1.0f;
}

fn bounded_gain_0( gain_1 : f32,  albedo_1 : vec3<f32>,  room_0 : vec3<f32>) -> f32
{
    var _S289 : vec3<f32> = room_0 / max(albedo_1, vec3<f32>(9.99999997475242708e-07f));
    return min(gain_1, max(min(min(_S289.x, _S289.y), _S289.z), 0.0f));
}

fn flattened_0( largest_0 : f32,  albedo_2 : vec3<f32>,  room_1 : vec3<f32>) -> f32
{
    var _S290 : vec3<f32> = room_1 / max(albedo_2, vec3<f32>(9.99999997475242708e-07f)) - vec3<f32>(1.0f);
    return min(max(min(min(_S290.x, _S290.y), _S290.z), 0.0f) / max(largest_0, 9.99999997475242708e-07f), 1.0f);
}

fn fibre_gain_0( thread_11 : u32,  cell_11 : u32,  amount_1 : f32,  seed_2 : u32) -> f32
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_11, cell_11, (seed_2 ^ (u32(2654435769))))), 10.0f) - 1.0f) + 1.0f;
}

fn lerp_albedos_0( first_5 : Albedos_0,  second_1 : Albedos_0,  weight_5 : f32) -> Albedos_0
{
    var albedos_5 : Albedos_0;
    var _S291 : vec3<f32> = vec3<f32>(weight_5);
    albedos_5.diffuse_reflect_0 = mix(first_5.diffuse_reflect_0, second_1.diffuse_reflect_0, _S291);
    albedos_5.diffuse_transmit_0 = mix(first_5.diffuse_transmit_0, second_1.diffuse_transmit_0, _S291);
    albedos_5.specular_reflect_0 = mix(first_5.specular_reflect_0, second_1.specular_reflect_0, _S291);
    albedos_5.specular_transmit_0 = mix(first_5.specular_transmit_0, second_1.specular_transmit_0, _S291);
    return albedos_5;
}

fn tinted_0( albedos_6 : Albedos_0,  tint_0 : vec3<f32>) -> Albedos_0
{
    var result_2 : Albedos_0 = albedos_6;
    result_2.diffuse_reflect_0 = result_2.diffuse_reflect_0 * tint_0;
    result_2.diffuse_transmit_0 = result_2.diffuse_transmit_0 * tint_0;
    return result_2;
}

fn fourth_power_0( value_1 : f32) -> f32
{
    var _S292 : f32 = value_1 * value_1;
    return _S292 * _S292;
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
    var _S293 : vec3<f32> = vec3<f32>((1.0f - open_of_other_0)) * passed_0;
    var found_0 : FaceRadiance_0;
    var _S294 : vec3<f32> = sends_0.sky_warp_0 + _S293 * sends_0.crossing_warp_0;
    found_0.warp_5 = _S294;
    var _S295 : vec3<f32> = sends_0.sky_weft_0 + _S293 * sends_0.crossing_weft_0;
    found_0.weft_5 = _S295;
    found_0.mean_1 = vec3<f32>(sends_0.blocks_warp_0) * _S294 + vec3<f32>(sends_0.blocks_weft_0) * _S295;
    found_0.leaked_0 = from_other_0;
    return found_0;
}

fn view_terms_0( view_6 : vec3<f32>,  terms_0 : ptr<function, array<f32, i32(6)>>)
{
    var _S296 : f32 = 1.0f - view_6.z;
    var _S297 : f32 = _S296 * _S296;
    (*terms_0)[i32(0)] = 1.0f;
    var _S298 : f32 = view_6.x;
    var _S299 : f32 = _S298 * _S298;
    var _S300 : f32 = view_6.y;
    var _S301 : f32 = _S300 * _S300;
    (*terms_0)[i32(1)] = sqrt(max(_S299 + _S301, 9.999999960041972e-13f));
    (*terms_0)[i32(2)] = _S297;
    (*terms_0)[i32(3)] = _S297 * _S297;
    (*terms_0)[i32(4)] = _S299 - _S301;
    (*terms_0)[i32(5)] = 0.0f;
    return;
}

fn view_terms_1( view_7 : vec3<f32>,  terms_1 : ptr<function, array<f32, i32(6)>>)
{
    var _S302 : f32 = 1.0f - view_7.z;
    var _S303 : f32 = _S302 * _S302;
    (*terms_1)[i32(0)] = 1.0f;
    var _S304 : f32 = view_7.x;
    var _S305 : f32 = _S304 * _S304;
    var _S306 : f32 = view_7.y;
    var _S307 : f32 = _S306 * _S306;
    (*terms_1)[i32(1)] = sqrt(max(_S305 + _S307, 9.999999960041972e-13f));
    (*terms_1)[i32(2)] = _S303;
    (*terms_1)[i32(3)] = _S303 * _S303;
    (*terms_1)[i32(4)] = _S305 - _S307;
    (*terms_1)[i32(5)] = 0.0f;
    return;
}

struct Bounced_0
{
     reflected_0 : vec3<f32>,
     transmitted_0 : vec3<f32>,
};

struct Scattered_0
{
     back_10 : vec3<f32>,
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
    var _S308 : vec3<f32> = vec3<f32>((blocked_1.by_warp_0 + blocked_1.by_weft_0)) * interior_0.leaked_1;
    var _S309 : vec3<f32> = vec3<f32>(blocked_1.far_0) * yarn_2.through_0;
    var bounced_0 : Bounced_0;
    bounced_0.reflected_0 = yarn_2.back_10 * (vec3<f32>(blocked_1.by_warp_0) * interior_0.warp_6 + vec3<f32>(blocked_1.by_weft_0) * interior_0.weft_6) + _S309 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S309 * interior_0.far_1 + yarn_2.back_10 * _S308;
    return bounced_0;
}

fn sum_of_0( first_6 : Bounced_0,  second_2 : Bounced_0) -> Bounced_0
{
    var sum_1 : Bounced_0;
    sum_1.reflected_0 = first_6.reflected_0 + second_2.reflected_0;
    sum_1.transmitted_0 = first_6.transmitted_0 + second_2.transmitted_0;
    return sum_1;
}

fn bounced_value_0( bounced_1 : Bounced_0,  light_7 : vec3<f32>,  view_8 : vec3<f32>) -> vec3<f32>
{
    var _S310 : f32 = light_7.z;
    return select_vector_1((_S310 * view_8.z) < 0.0f, bounced_1.transmitted_0, bounced_1.reflected_0) * vec3<f32>((abs(_S310) * 0.31830987334251404f));
}

fn sheen_scale_0( x_15 : f32,  y_8 : f32) -> f32
{
    return (((((0.0f * x_15 + (((((-1.1402510404586792f * y_8 + 0.40672621130943298f) * y_8 + 1.65398800373077393f) * y_8 + -1.29730904102325439f) * y_8 + 0.30570998787879944f) * y_8 + -0.0220868494361639f)) * x_15 + (((((-0.21142719686031342f * y_8 + 1.05947399139404297f) * y_8 + -0.41116121411323547f) * y_8 + -0.93859231472015381f) * y_8 + 0.51606941223144531f) * y_8 + 0.05409301072359085f)) * x_15 + (((((1.22944498062133789f * y_8 + -0.45962560176849365f) * y_8 + -1.63861405849456787f) * y_8 + 1.33565104007720947f) * y_8 + -0.45725581049919128f) * y_8 + 0.08243165910243988f)) * x_15 + (((((0.39779931306838989f * y_8 + -1.18879103660583496f) * y_8 + 0.28251591324806213f) * y_8 + 1.168984055519104f) * y_8 + -0.76864629983901978f) * y_8 + 0.0091691892594099f)) * x_15 + (((((-0.26563560962677002f * y_8 + -0.19379159808158875f) * y_8 + 0.2677634060382843f) * y_8 + 0.00270519289188087f) * y_8 + 0.14349560439586639f) * y_8 + 0.10290180146694183f)) * x_15 + (((((-0.20701569318771362f * y_8 + 0.24526430666446686f) * y_8 + 0.19551840424537659f) * y_8 + 0.07586126774549484f) * y_8 + 0.38894739747047424f) * y_8 + 0.15043120086193085f);
}

fn sheen_shear_0( x_16 : f32,  y_9 : f32) -> f32
{
    return ((((0.0f * x_16 + (((((-0.10608240216970444f * y_9 + 1.99214303493499756f) * y_9 + -1.42255294322967529f) * y_9 + -1.09495604038238525f) * y_9 + 0.59180057048797607f) * y_9 + 0.06902855634689331f)) * x_16 + (((((-0.46220690011978149f * y_9 + -0.29113379120826721f) * y_9 + 1.39025199413299561f) * y_9 + 0.35589990019798279f) * y_9 + -1.17120099067687988f) * y_9 + 0.15940259397029877f)) * x_16 + (((((2.26068711280822754f * y_9 + -3.64728999137878418f) * y_9 + -0.72173482179641724f) * y_9 + 3.07659196853637695f) * y_9 + -0.6827620267868042f) * y_9 + -0.3039557933807373f)) * x_16 + (((((0.81201767921447754f * y_9 + 0.36014080047607422f) * y_9 + -1.72646903991699219f) * y_9 + -0.22630110383033752f) * y_9 + 0.89514690637588501f) * y_9 + -0.10397960245609283f)) * x_16 + (((((-0.37648698687553406f * y_9 + 1.10974001884460449f) * y_9 + 0.17824520170688629f) * y_9 + -1.04968702793121338f) * y_9 + 0.1461234986782074f) * y_9 + -0.00475129019469023f);
}

fn sheen_reflectance_0( x_17 : f32,  y_10 : f32) -> f32
{
    return ((((0.0f * x_17 + (((((12.95646953582763672f * y_10 + -21.38032913208007812f) * y_10 + -7.37853097915649414f) * y_10 + 34.55607986450195312f) * y_10 + -23.61347007751464844f) * y_10 + 5.00126314163208008f)) * x_17 + (((((10.91487026214599609f * y_10 + -6.08202791213989258f) * y_10 + -38.2036285400390625f) * y_10 + 53.3440399169921875f) * y_10 + -21.91996002197265625f) * y_10 + 2.01606011390686035f)) * x_17 + (((((-14.52206039428710938f * y_10 + 36.803619384765625f) * y_10 + -22.94047927856445312f) * y_10 + -10.07973003387451172f) * y_10 + 15.77003955841064453f) * y_10 + -4.92722177505493164f)) * x_17 + (((((-7.62505722045898438f * y_10 + 1.27310299873352051f) * y_10 + 31.19523048400878906f) * y_10 + -44.39989852905273438f) * y_10 + 26.44947052001953125f) * y_10 + -8.73507976531982422f)) * x_17 + (((((5.65633487701416016f * y_10 + -17.66820907592773438f) * y_10 + 24.65356063842773438f) * y_10 + -19.38941001892089844f) * y_10 + 11.06159019470214844f) * y_10 + -3.06573700904846191f);
}

fn sheen_lobe_0( cos_view_0 : f32,  roughness_10 : f32) -> vec3<f32>
{
    var _S311 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S312 : f32 = 2.0f * sqrt(_S311) - 1.0f;
    var _S313 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_10, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S312, _S313), 0.00999999977648258f, 1.0f), clamp((1.0f - _S311) * sheen_shear_0(_S312, _S313), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S312, _S313), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_8 : vec3<f32>,  view_9 : vec3<f32>,  scale_0 : f32,  shear_0 : f32) -> f32
{
    var _S314 : f32 = light_8.z;
    if(((_S314 <= 0.0f) | (((view_9.z) <= 0.0f))))
    {
        return 0.0f;
    }
    var _S315 : vec2<f32> = view_9.xy;
    var _S316 : f32 = dot(_S315, _S315);
    var _S317 : vec2<f32> = select_vector_0(_S316 > 9.99999968265522539e-21f, _S315 * vec2<f32>(rsqrt_0(max(_S316, 9.99999968265522539e-21f))), vec2<f32>(1.0f, 0.0f));
    var _S318 : f32 = scale_0 * dot(light_8.xy, _S317) + shear_0 * _S314;
    var _S319 : f32 = scale_0 * (light_8.y * _S317.x - light_8.x * _S317.y);
    var _S320 : f32 = _S318 * _S318 + _S319 * _S319 + _S314 * _S314;
    return 0.31830987334251404f * scale_0 * scale_0 * _S314 / max(_S320 * _S320, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_9 : vec3<f32>,  view_10 : vec3<f32>,  strength_0 : f32,  roughness_11 : f32) -> vec2<f32>
{
    var _S321 : vec3<f32> = sheen_lobe_0(view_10.z, roughness_11);
    var _S322 : f32 = strength_0 * _S321.z;
    return vec2<f32>(_S322 * transformed_cosine_0(light_9, view_10, _S321.x, _S321.y), 1.0f - _S322);
}

fn accumulate_0( index_7 : u32,  light_10 : vec4<f32>)
{
    var _S323 : f32 = layers_0[index_7].share_0;
    radiance_0[index_7] = radiance_0[index_7] + vec4<f32>(layers_0[index_7].share_0) * light_10;
    layers_0[index_7].share_0 = _S323 * (1.0f - light_10.w);
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

fn uneven_shift_0( _S324 : u32,  _S325 : u32,  _S326 : u32,  _S327 : vec2<f32>) -> f32
{
    var _S328 : f32 = families_0[_S326].period_0 / families_0[_S326].count_0;
    var _S329 : u32 = hash_key_0(_S325, ((fabrics_0[_S324].seed_0) ^ (u32(625341585))));
    var _S330 : vec2<f32> = vec2<f32>(_S327.x, _S327.y / 4.0f) / vec2<f32>(_S328);
    return 0.20000000298023224f * sqrt(families_0[_S326].slub_0) * _S328 * (uneven_octave_0(_S329, _S330) * 0.66666668653488159f + uneven_octave_0(_S329 + u32(1), vec2<f32>(2.0f) * _S330 + vec2<f32>(0.5f, 0.0f)) / 3.0f);
}

fn uneven_place_0( _S331 : u32,  _S332 : vec2<f32>) -> vec2<f32>
{
    return select_vector_0((fabrics_0[_S331].has_detail_0) == u32(0), _S332, _S332 + vec2<f32>(uneven_shift_0(_S331, u32(0), fabrics_0[_S331].warp_0, _S332), uneven_shift_0(_S331, u32(1), fabrics_0[_S331].weft_0, _S332.yx)));
}

fn face_point_0( _S333 : u32,  _S334 : u32,  _S335 : f32,  _S336 : f32) -> VisiblePoint_0
{
    var _S337 : u32 = u32(3) * _S334;
    var _S338 : Vertex_0 = vertex_at_0(_S337);
    var _S339 : Vertex_0 = vertex_at_0(_S337 + u32(1));
    var _S340 : Vertex_0 = vertex_at_0(_S337 + u32(2));
    var _S341 : vec3<f32> = position_of_0(_S338);
    var _S342 : vec3<f32> = position_of_0(_S339) - _S341;
    var _S343 : vec3<f32> = position_of_0(_S340) - _S341;
    var _S344 : f32 = _S339.u_0 - _S338.u_0;
    var _S345 : f32 = _S339.v_0 - _S338.v_0;
    var _S346 : vec2<f32> = vec2<f32>(_S344, _S345);
    var _S347 : f32 = _S340.u_0 - _S338.u_0;
    var _S348 : f32 = _S340.v_0 - _S338.v_0;
    var _S349 : vec2<f32> = vec2<f32>(_S347, _S348);
    var _S350 : vec3<f32> = vec3<f32>(select(1.0f, -1.0f, (_S344 * _S348 - _S345 * _S347) < 0.0f));
    var _S351 : vec3<f32> = _S350 * (vec3<f32>(_S348) * _S342 - vec3<f32>(_S345) * _S343);
    var _S352 : vec3<f32> = _S350 * (vec3<f32>(_S344) * _S343 - vec3<f32>(_S347) * _S342);
    var point_2 : VisiblePoint_0;
    var _S353 : vec3<f32> = vec3<f32>(_S335);
    var _S354 : vec3<f32> = vec3<f32>(_S336);
    var _S355 : vec3<f32> = normalize(vec3<f32>((1.0f - _S335 - _S336)) * normal_of_0(_S338) + _S353 * normal_of_0(_S339) + _S354 * normal_of_0(_S340));
    point_2.normal_0 = _S355;
    var _S356 : vec3<f32> = normalize(_S351 - _S355 * vec3<f32>(dot(_S355, _S351)));
    point_2.axis_x_0 = _S356;
    point_2.axis_y_0 = cross(_S355, _S356);
    var _S357 : vec3<f32> = normalize(cross(_S342, _S343));
    point_2.face_normal_0 = select_vector_1((dot(_S357, _S355)) < 0.0f, (vec3<f32>(0) - _S357), _S357);
    point_2.position_4 = _S341 + _S353 * _S342 + _S354 * _S343;
    point_2.view_0 = _S355;
    var _S358 : vec2<f32> = vec2<f32>(_S338.u_0, _S338.v_0) + vec2<f32>(_S335) * _S346 + vec2<f32>(_S336) * _S349;
    point_2.uv_1 = _S358;
    var _S359 : bool = (dot(cross(_S351, _S352), _S355)) < 0.0f;
    var _S360 : vec2<f32> = vec2<f32>(fabrics_0[_S333].uv_width_0, select(fabrics_0[_S333].uv_height_0, - fabrics_0[_S333].uv_height_0, _S359));
    point_2.draft_per_uv_0 = _S360;
    point_2.draft_0 = uneven_place_0(_S333, _S358 * _S360 + vec2<f32>(0.0f, select(0.0f, fabrics_0[_S333].uv_height_0, _S359)));
    var _S361 : vec2<f32> = vec2<f32>(0.0f);
    point_2.draft_dx_0 = _S361;
    point_2.draft_dy_0 = _S361;
    return point_2;
}

fn visible_point_0( _S362 : u32,  _S363 : u32,  _S364 : vec2<u32>) -> VisiblePoint_0
{
    var _S365 : u32 = u32(3) * _S363;
    var _S366 : Vertex_0 = vertex_at_0(_S365);
    var _S367 : Vertex_0 = vertex_at_0(_S365 + u32(1));
    var _S368 : Vertex_0 = vertex_at_0(_S365 + u32(2));
    var _S369 : vec3<f32> = position_of_0(_S366);
    var _S370 : vec3<f32> = position_of_0(_S367) - _S369;
    var _S371 : vec3<f32> = position_of_0(_S368) - _S369;
    var _S372 : vec3<f32> = cross(_S370, _S371);
    var _S373 : f32 = f32(frame_record_0.width_0);
    var _S374 : vec3<f32> = camera_right_0() * vec3<f32>((2.0f / _S373));
    var _S375 : f32 = f32(frame_record_0.height_0);
    var _S376 : vec3<f32> = camera_up_0() * vec3<f32>((-2.0f / _S375));
    var _S377 : vec3<f32> = camera_forward_0() + vec3<f32>((f32(_S364.x) + 0.5f - 0.5f * _S373)) * _S374 + vec3<f32>((f32(_S364.y) + 0.5f - 0.5f * _S375)) * _S376;
    var _S378 : f32 = dot(_S377, _S372);
    var _S379 : f32 = 1.0f / select(1.00000000317107685e-30f, _S378, (abs(_S378)) > 1.00000000317107685e-30f);
    var _S380 : vec3<f32> = _S369 - camera_origin_0();
    var _S381 : vec3<f32> = vec3<f32>((dot(_S380, _S372) * _S379));
    var _S382 : vec3<f32> = _S377 * _S381 - _S380;
    var _S383 : vec3<f32> = _S381 * (_S374 - _S377 * vec3<f32>((dot(_S374, _S372) * _S379)));
    var _S384 : vec3<f32> = _S381 * (_S376 - _S377 * vec3<f32>((dot(_S376, _S372) * _S379)));
    var _S385 : vec3<f32> = vec3<f32>((1.0f / max(square_0(_S372), 1.00000000317107685e-30f)));
    var _S386 : vec3<f32> = cross(_S371, _S372) * _S385;
    var _S387 : vec3<f32> = cross(_S372, _S370) * _S385;
    var _S388 : vec2<f32> = vec2<f32>(_S367.u_0 - _S366.u_0, _S367.v_0 - _S366.v_0);
    var _S389 : vec2<f32> = vec2<f32>(_S368.u_0 - _S366.u_0, _S368.v_0 - _S366.v_0);
    var point_3 : VisiblePoint_0 = face_point_0(_S362, _S363, dot(_S382, _S386), dot(_S382, _S387));
    point_3.position_4 = _S369 + _S382;
    point_3.view_0 = (vec3<f32>(0) - normalize(_S377));
    point_3.draft_dx_0 = (vec2<f32>(dot(_S383, _S386)) * _S388 + vec2<f32>(dot(_S383, _S387)) * _S389) * point_3.draft_per_uv_0;
    point_3.draft_dy_0 = (vec2<f32>(dot(_S384, _S386)) * _S388 + vec2<f32>(dot(_S384, _S387)) * _S389) * point_3.draft_per_uv_0;
    return point_3;
}

fn filtered_albedo_0( _S390 : u32,  _S391 : VisiblePoint_0) -> vec3<f32>
{
    var _S392 : u32 = fabrics_0[_S390].albedo_map_levels_0;
    if((fabrics_0[_S390].albedo_map_levels_0) == u32(0))
    {
        return vec3<f32>(1.0f);
    }
    var _S393 : vec2<f32> = vec2<f32>(fabrics_0[_S390].uv_width_0, fabrics_0[_S390].uv_height_0);
    var _S394 : vec2<f32> = _S391.draft_dx_0 / _S393;
    var _S395 : vec2<f32> = _S391.draft_dy_0 / _S393;
    var _S396 : u32 = _S392 - u32(1);
    var _S397 : u32 = (u32(1) << (_S396));
    var _S398 : f32 = clamp(0.5f * binary_logarithm_0(max(abs(_S394.x * _S395.y - _S394.y * _S395.x), 9.99999968265522539e-21f) * (square_1(f32(_S397)) / 3.0f)), 0.0f, f32(_S392) - 1.0f);
    var _S399 : u32 = min(u32(_S398), max(_S392, u32(2)) - u32(2));
    var _S400 : u32 = min(_S399 + u32(1), _S396);
    var _S401 : u32 = (u32(1) << ((u32(2) * _S392)));
    return mix(map_level_0(fabrics_0[_S390].albedo_map_0 + (_S401 - ((_S401 >> ((u32(2) * _S399))))) / u32(3), (_S397 >> (_S399)), _S391.uv_1), map_level_0(fabrics_0[_S390].albedo_map_0 + (_S401 - ((_S401 >> ((u32(2) * _S400))))) / u32(3), (_S397 >> (_S400)), _S391.uv_1), vec3<f32>(((exponential_0(1.38629436492919922f * (_S398 - f32(_S399))) - 1.0f) / 3.0f)));
}

fn irregular_key_0( _S402 : u32,  _S403 : u32) -> u32
{
    return hash_key_0(_S403, ((fabrics_0[_S402].seed_0) ^ (u32(1821285621))));
}

fn irregular_place_0( _S404 : u32,  _S405 : vec2<f32>,  _S406 : f32) -> vec2<f32>
{
    var _S407 : u32 = fabrics_0[_S404].warp_0;
    var _S408 : u32 = fabrics_0[_S404].weft_0;
    var _S409 : bool = (((fabrics_0[_S404].is_irregular_0) != u32(0)) & (((max(moved_share_0(fabrics_0[_S404].warp_0, _S406), moved_share_0(fabrics_0[_S404].weft_0, _S406))) > 0.0f)));
    var number_3 : u32 = u32(0);
    var moved_0 : vec2<f32> = _S405;
    for(;;)
    {
        if(number_3 < select(u32(0), u32(2), _S409))
        {
        }
        else
        {
            break;
        }
        var _S410 : bool = number_3 == u32(0);
        var _S411 : u32 = select(_S408, _S407, _S410);
        var _S412 : vec2<f32> = select_vector_0(_S410, _S405, _S405.yx);
        var _S413 : u32 = irregular_key_0(_S404, number_3);
        var _S414 : f32 = _S412.x;
        var _S415 : Cell_0 = locate_0(_S411, _S414);
        var _S416 : f32 = irregular_thread_0(_S411, _S414, _S415);
        var _S417 : f32 = select(1.0f, -1.0f, (_S415.across_0) < 0.0f);
        var _S418 : vec2<f32> = vec2<f32>(0.0f);
        var other_3 : vec2<f32> = _S418;
        var own_2 : vec2<f32> = _S418;
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
            var _S419 : vec2<f32> = irregular_at_0(_S411, _S413, _S416 + _S417 * f32(neighbour_0), _S412.y).xy;
            var _S420 : u32 = neighbour_0 + u32(1);
            own_2 = other_3;
            other_3 = _S419;
            neighbour_0 = _S420;
        }
        var _S421 : f32 = _S415.below_0 + _S415.above_0;
        var _S422 : f32 = min(_S415.half_width_1 / _S421, 0.5f);
        var _S423 : f32 = min(_S422 * (2.0f + own_2.y + other_3.y), 1.0f);
        var _S424 : vec2<f32> = sqrt(max(vec2<f32>(1.0f) + vec2<f32>(own_2.x, other_3.x), vec2<f32>(0.25f)));
        var _S425 : f32 = _S424.x;
        var _S426 : f32 = _S423 * _S425 / (_S425 + _S424.y);
        var _S427 : f32 = abs(_S415.across_0) / _S421;
        var _S428 : f32 = 1.0f - _S423;
        var _S429 : f32 = _S427 - _S426;
        var _S430 : f32 = moved_share_0(_S411, _S406) * _S417 * _S421 * (select(select((_S429 - _S428) / max(_S423 - _S426, 9.99999997475242708e-07f) * _S422 + (1.0f - _S422), _S429 / max(_S428, 9.99999997475242708e-07f) * (1.0f - 2.0f * _S422) + _S422, _S429 < _S428), _S427 * _S422 / _S426, _S429 < 0.0f) - _S427);
        var moved_1 : vec2<f32> = moved_0 + select_vector_0(_S410, vec2<f32>(_S430, 0.0f), vec2<f32>(0.0f, _S430));
        number_3 = number_3 + u32(1);
        moved_0 = moved_1;
    }
    return moved_0;
}

fn light_sample_count_0() -> u32
{
    return frame_record_0.lights_0 + frame_record_0.environment_samples_0;
}

fn visibility_at_0( _S431 : u32,  _S432 : vec2<u32>) -> f32
{
    if((frame_record_0.casts_shadows_0) == u32(0))
    {
        return 1.0f;
    }
    return visibilities_0[(_S431 * frame_record_0.height_0 + _S432.y) * frame_record_0.width_0 + _S432.x];
}

struct LightSample_0
{
     towards_0 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_1 : f32,
};

fn environment_texel_0( _S433 : u32,  _S434 : u32) -> vec3<f32>
{
    var _S435 : u32 = frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + frame_record_0.environment_rows_0 * (frame_record_0.environment_columns_0 + u32(1)) + u32(3) * (_S433 * frame_record_0.environment_columns_0 + _S434);
    return vec3<f32>(scene_number_0(_S435), scene_number_0(_S435 + u32(1)), scene_number_0(_S435 + u32(2)));
}

fn sample_environment_0( _S436 : vec2<f32>,  _S437 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S438 : u32 = frame_record_0.environment_rows_0;
    var _S439 : Choice_0 = choose_0(frame_record_0.environment_table_0, frame_record_0.environment_rows_0, _S436.y);
    var _S440 : u32 = frame_record_0.environment_columns_0;
    var _S441 : Choice_0 = choose_0(frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + _S439.index_5 * (frame_record_0.environment_columns_0 + u32(1)), frame_record_0.environment_columns_0, _S436.x);
    var _S442 : vec3<f32> = environment_texel_0(_S439.index_5, _S441.index_5);
    (*_S437) = _S442 * vec3<f32>((frame_record_0.environment_total_0 / max(mean_0(_S442), 9.99999968265522539e-21f)));
    var _S443 : f32 = 3.14159274101257324f / f32(_S438);
    var _S444 : f32 = mix(sine_cosine_0(f32(_S439.index_5) * _S443).y, sine_cosine_0(f32(_S439.index_5 + u32(1)) * _S443).y, _S439.remainder_0);
    var _S445 : f32 = sqrt(max(1.0f - _S444 * _S444, 0.0f));
    var _S446 : vec2<f32> = sine_cosine_0((f32(_S441.index_5) + _S441.remainder_0) * (6.28318548202514648f / f32(_S440)));
    var _S447 : f32 = _S445 * _S446.x;
    var _S448 : f32 = - _S445 * _S446.y;
    return vec3<f32>(frame_record_0.environment_cosine_0 * _S447 + frame_record_0.environment_sine_0 * _S448, _S444, frame_record_0.environment_cosine_0 * _S448 - frame_record_0.environment_sine_0 * _S447);
}

fn light_sample_0( _S449 : u32,  _S450 : vec2<u32>,  _S451 : vec3<f32>) -> LightSample_0
{
    var sample_0 : LightSample_0;
    sample_0.distance_1 = 1.00000001504746622e+30f;
    var _S452 : u32 = frame_record_0.lights_0;
    if(_S449 >= (frame_record_0.lights_0))
    {
        var weight_6 : vec3<f32>;
        var _S453 : vec3<f32> = sample_environment_0(pixel_sequence_0(_S450, frame_record_0.pass_number_0 * frame_record_0.environment_samples_0 + (_S449 - _S452), u32(3)), &(weight_6));
        sample_0.towards_0 = _S453;
        sample_0.irradiance_1 = weight_6 / vec3<f32>(f32(frame_record_0.environment_samples_0));
        return sample_0;
    }
    var _S454 : Light_0 = scene_light_0(frame_record_0.light_records_0 + u32(7) * _S449);
    sample_0.irradiance_1 = vec3<f32>(_S454.red_0, _S454.green_0, _S454.blue_0);
    sample_0.towards_0 = vec3<f32>(_S454.x_7, _S454.y_1, _S454.z_1);
    if((_S454.is_point_0) != u32(0))
    {
        var _S455 : vec3<f32> = sample_0.towards_0 - _S451;
        var _S456 : f32 = max(square_0(_S455), 9.999999960041972e-13f);
        sample_0.distance_1 = sqrt(_S456);
        sample_0.irradiance_1 = sample_0.irradiance_1 / vec3<f32>(_S456);
        sample_0.towards_0 = normalize(_S455);
    }
    return sample_0;
}

struct FamilyAlbedos_0
{
     warp_7 : Albedos_0,
     weft_7 : Albedos_0,
};

struct Estimate_0
{
     components_0 : Components_0,
     close_0 : CloseUp_0,
     albedos_7 : FamilyAlbedos_0,
};

struct Regime_0
{
     prefiltered_0 : f32,
     threads_2 : f32,
     points_0 : f32,
};

fn regime_of_0( _S457 : u32,  _S458 : Footprint_0,  _S459 : f32) -> Regime_0
{
    var _S460 : f32 = Footprint_spread_side_0(_S458);
    var _S461 : f32 = clamp((binary_logarithm_0(max(_S460, 9.99999971718068537e-10f)) - fabrics_0[_S457].lobes_0.unit_level_0 - -0.51457315683364868f) / 1.51457309722900391f, 0.0f, 1.0f);
    var regime_0 : Regime_0;
    var _S462 : f32 = _S461 * _S461 * (3.0f - 2.0f * _S461);
    regime_0.prefiltered_0 = _S462;
    var _S463 : f32 = _S460 * fabrics_0[_S457].lobes_0.threads_per_mm_0;
    regime_0.threads_2 = _S463;
    regime_0.points_0 = select(0.0f, clamp(_S463 * 12.0f, 1.0f, max(mix(8.0f, 4.0f, _S462) / _S459, 1.0f)), _S462 < 1.0f);
    return regime_0;
}

fn varies_at_0( _S464 : u32,  _S465 : f32) -> bool
{
    return (((((fabrics_0[_S464].fibre_noise_0) > 0.0f) | (((fabrics_0[_S464].colour_noise_0) > 0.0f)))) | (((((fabrics_0[_S464].has_detail_0) != u32(0)) & ((_S465 >= 0.0f))))));
}

struct Hit_0
{
     x_18 : f32,
     y_11 : f32,
     hole_7 : bool,
     height_8 : f32,
};

struct Sample_0
{
     crossing_2 : Crossing_0,
     shown_3 : Shown_0,
     run_3 : Run_0,
     section_1 : Section_0,
     height_9 : f32,
     slope_across_0 : f32,
     slope_along_0 : f32,
     dive_1 : vec3<f32>,
     slope_x_1 : f32,
     slope_y_1 : f32,
};

fn crossing_at_0( _S466 : u32,  _S467 : f32,  _S468 : f32,  _S469 : bool) -> Crossing_0
{
    var crossing_3 : Crossing_0;
    crossing_3.warp_2 = locate_0(fabrics_0[_S466].warp_0, _S467);
    crossing_3.weft_2 = locate_0(fabrics_0[_S466].weft_0, _S468);
    var _S470 : u32 = fabrics_0[_S466].run_words_0 + u32(2) * (crossing_3.weft_2.thread_1 * fabrics_0[_S466].ends_1 + crossing_3.warp_2.thread_1);
    var _S471 : u32 = words_0[_S470];
    crossing_3.warp_word_0 = _S471;
    crossing_3.weft_word_0 = words_0[_S470 + u32(1)];
    crossing_3.warp_above_0 = (((_S471 & (u32(1)))) == u32(1)) != _S469;
    return crossing_3;
}

fn sample_at_0( _S472 : u32,  _S473 : f32,  _S474 : f32,  _S475 : bool) -> Sample_0
{
    var sample_1 : Sample_0;
    var _S476 : Crossing_0 = crossing_at_0(_S472, _S473, _S474, _S475);
    sample_1.crossing_2 = _S476;
    var _S477 : Shown_0 = shown_at_0(_S476, _S475);
    sample_1.shown_3 = _S477;
    var _S478 : u32 = select(fabrics_0[_S472].weft_0, fabrics_0[_S472].warp_0, _S477.is_warp_2);
    var _S479 : u32 = select(fabrics_0[_S472].warp_0, fabrics_0[_S472].weft_0, _S477.is_warp_2);
    var _S480 : Cell_0 = select_cell_0(_S477.is_warp_2, sample_1.crossing_2.warp_2, sample_1.crossing_2.weft_2);
    var _S481 : Cell_0 = select_cell_0(_S477.is_warp_2, sample_1.crossing_2.weft_2, sample_1.crossing_2.warp_2);
    var _S482 : Run_0 = unpack_0(_S478, _S479, _S480.thread_1, _S481, _S477.word_0);
    var _S483 : Section_0 = section_at_0(_S480);
    var _S484 : bool = ((_S477.on_top_0) & (((_S482.distance_0) < (_S483.drop_0 * _S482.bend_1.sine_0))));
    var _S485 : f32 = select(-1.0f, 1.0f, ((_S477.on_top_0) & ((!_S484))));
    var _S486 : f32 = select(_S482.reach_0, _S482.other_reach_0, _S484);
    var _S487 : f32 = select(max(_S486 - _S482.distance_0, 0.0f), _S486 + _S482.distance_0, _S484);
    var _S488 : f32 = _S486 / _S482.bend_1.sine_0 - _S485 * _S483.drop_0;
    var _S489 : f32 = _S487 * _S487;
    var _S490 : f32 = max(_S488 * _S488 - _S489, 9.99999968265522539e-21f);
    var _S491 : f32 = rsqrt_0(_S490);
    var _S492 : f32 = _S489 / (_S490 * _S491 + _S488);
    var _S493 : bool = _S487 > 0.0f;
    var _S494 : f32 = select(-1.0f, 1.0f, _S477.on_top_0) * select(-1.0f, 1.0f, _S482.near_start_0);
    var _S495 : f32 = _S483.slope_0 * select(1.0f, _S488 * _S491, _S493);
    sample_1.slope_across_0 = _S495;
    var _S496 : f32 = select(0.0f, _S494 * _S487 * _S491, _S493);
    sample_1.slope_along_0 = _S496;
    var _S497 : vec3<f32> = dive_0(_S479, _S477, _S482, _S481);
    sample_1.dive_1 = _S497;
    sample_1.height_9 = select(families_0[_S478].height_scale_0 * _S485, 0.0f, _S482.straight_0) * (_S486 * _S482.bend_1.half_tangent_0 - _S492) - families_0[_S478].height_scale_0 * _S483.drop_0 - _S497.x;
    var _S498 : f32 = families_0[_S478].height_scale_0 * _S495;
    var _S499 : f32 = families_0[_S478].height_scale_0 * _S496 - _S497.y;
    sample_1.slope_x_1 = select(_S499, _S498, _S477.is_warp_2);
    sample_1.slope_y_1 = select(_S498, _S499, _S477.is_warp_2);
    sample_1.run_3 = _S482;
    sample_1.section_1 = _S483;
    return sample_1;
}

fn steps_per_length_0( _S500 : u32,  _S501 : SearchQuality_0,  _S502 : vec3<f32>) -> f32
{
    return max(max(abs(_S502.x) * fabrics_0[_S500].threads_per_x_0, abs(_S502.y) * fabrics_0[_S500].threads_per_y_0) * _S501.steps_per_thread_0, abs(_S502.z) * fabrics_0[_S500].per_relief_0 * _S501.steps_per_relief_0);
}

fn cell_maximum_0( _S503 : u32,  _S504 : Crossing_0) -> f32
{
    var _S505 : u32 = select(fabrics_0[_S503].weft_0, fabrics_0[_S503].warp_0, _S504.warp_above_0);
    return f32((select(_S504.weft_word_0, _S504.warp_word_0, _S504.warp_above_0) >> (u32(28)))) * families_0[_S505].height_scale_0 * families_0[_S505].level_0;
}

fn probe_0( _S506 : u32,  _S507 : f32,  _S508 : f32,  _S509 : bool,  _S510 : bool,  _S511 : bool) -> Probe_0
{
    var _S512 : Sample_0 = sample_at_0(_S506, _S507, _S508, _S509);
    var probe_1 : Probe_0;
    probe_1.height_4 = _S512.height_9;
    probe_1.hole_4 = _S512.shown_3.hole_3;
    probe_1.slope_x_0 = _S512.slope_x_1;
    probe_1.slope_y_0 = _S512.slope_y_1;
    probe_1.yarn_1 = select(_S512.crossing_2.weft_2.thread_1 * u32(2), _S512.crossing_2.warp_2.thread_1 * u32(2) + u32(1), _S512.shown_3.is_warp_2);
    probe_1.cell_max_0 = cell_maximum_0(_S506, _S512.crossing_2);
    probe_1.side_x_0 = select(_S512.crossing_2.warp_2.below_0, _S512.crossing_2.warp_2.above_0, _S510);
    probe_1.side_y_0 = select(_S512.crossing_2.weft_2.below_0, _S512.crossing_2.weft_2.above_0, _S511);
    probe_1.edge_x_0 = outline_distance_0(_S512.crossing_2.warp_2, _S512.shown_3, _S512.run_3, !_S512.shown_3.is_warp_2, _S510);
    probe_1.edge_y_0 = outline_distance_0(_S512.crossing_2.weft_2, _S512.shown_3, _S512.run_3, _S512.shown_3.is_warp_2, _S511);
    return probe_1;
}

fn is_free_0( _S513 : u32,  _S514 : SearchQuality_0,  _S515 : vec3<f32>,  _S516 : vec3<f32>,  _S517 : bool,  _S518 : f32) -> bool
{
    var _S519 : f32 = _S516.z;
    if(_S519 <= 0.0f)
    {
        return false;
    }
    var _S520 : f32 = 1.0f / max(_S514.shadow_share_0 * steps_per_length_0(_S513, _S514, _S516), 9.99999971718068537e-10f);
    var _S521 : StepControl_0 = step_control_0(_S516.xy, _S520);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_4 : u32 = u32(0);
    var distance_2 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        if(((count_4 < u32(1024)) & (((_S515.z + _S519 * distance_2) < _S518))))
        {
        }
        else
        {
            break;
        }
        var _S522 : vec3<f32> = _S515 + _S516 * vec3<f32>(distance_2);
        var _S523 : Probe_0 = probe_0(_S513, _S522.x, _S522.y, _S517, _S521.right_0, _S521.up_0);
        var _S524 : f32 = _S522.z;
        var _S525 : f32 = _S524 - _S523.height_4;
        var _S526 : f32 = _S519 - _S523.slope_x_0 * _S516.x - _S523.slope_y_0 * _S516.y;
        if(((!_S523.hole_4) & ((_S525 < 0.0f))))
        {
            return false;
        }
        var _S527 : f32 = way_back_to_dip_0(previous_3, _S525, _S526, last_step_0, _S523);
        if(_S527 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S527;
            distance_2 = distance_2 - _S527;
            last_step_0 = last_step_1;
            count_4 = count_4 + u32(1);
            continue;
        }
        var _S528 : bool = _S524 > (_S523.cell_max_0);
        var last_step_2 : f32 = select(StepControl_to_next_sample_0(_S521, _S523, _S525, _S526), max(StepControl_to_cell_exit_0(_S521, _S523.side_x_0, _S523.side_y_0), _S520), _S528);
        var distance_3 : f32 = distance_2 + last_step_2;
        previous_3 = after_sample_0(_S525, _S526, _S523, _S528);
        distance_2 = distance_3;
        last_step_0 = last_step_2;
        count_4 = count_4 + u32(1);
    }
    return true;
}

fn passes_through_0( _S529 : u32,  _S530 : SearchQuality_0,  _S531 : f32,  _S532 : f32,  _S533 : vec3<f32>,  _S534 : bool) -> bool
{
    if(!sample_at_0(_S529, _S531, _S532, _S534).shown_3.hole_3)
    {
        return false;
    }
    var _S535 : vec3<f32> = vec3<f32>(_S531, _S532, 0.0f);
    var passes_0 : bool = true;
    var side_2 : u32 = u32(0);
    for(;;)
    {
        if(((side_2 < u32(2)) & (passes_0)))
        {
        }
        else
        {
            break;
        }
        var _S536 : bool = is_free_0(_S529, _S530, _S535, select_vector_1(side_2 == u32(0), _S533, vec3<f32>(- _S533.x, - _S533.y, _S533.z)), _S534 != (side_2 == u32(1)), fabrics_0[_S529].height_high_0);
        var _S537 : u32 = side_2 + u32(1);
        passes_0 = _S536;
        side_2 = _S537;
    }
    return passes_0;
}

struct ViewRayEnd_0
{
     height_10 : f32,
     last_step_3 : f32,
     depth_2 : f32,
     rate_4 : f32,
     smooth_0 : bool,
     previous_4 : PreviousSample_0,
};

fn max_height_along_0( _S538 : u32,  _S539 : f32,  _S540 : f32,  _S541 : f32,  _S542 : vec3<f32>,  _S543 : bool) -> f32
{
    var _S544 : f32 = _S542.x;
    var _S545 : f32 = _S542.y;
    var _S546 : u32 = (words_0[fabrics_0[_S538].max_heights_0 + u32(4) * (locate_0(fabrics_0[_S538].weft_0, _S540).thread_1 / u32(2) * fabrics_0[_S538].max_height_columns_0 + locate_0(fabrics_0[_S538].warp_0, _S539).thread_1 / u32(2)) + (select(u32(0), u32(1), _S544 > 0.0f) + select(u32(0), u32(2), _S545 > 0.0f))] >> (u32(select(i32(0), i32(4), _S543))));
    var _S547 : f32 = max(abs(_S544) * fabrics_0[_S538].threads_per_x_0, abs(_S545) * fabrics_0[_S538].threads_per_y_0) / _S542.z;
    var _S548 : f32 = fabrics_0[_S538].height_high_0;
    var max_height_0 : f32 = fabrics_0[_S538].height_high_0;
    var number_4 : i32 = i32(3);
    for(;;)
    {
        if(number_4 >= i32(0))
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S541) * _S547) <= (PYRAMID_RADII_0[number_4]))
        {
            max_height_0 = min(max_height_0, f32((((_S546 >> (u32(i32(8) * number_4)))) & (u32(15)))) * 0.06666667014360428f * _S548);
        }
        number_4 = number_4 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S549 : u32,  _S550 : f32,  _S551 : f32,  _S552 : bool,  _S553 : bool,  _S554 : bool) -> vec3<f32>
{
    var _S555 : Crossing_0 = crossing_at_0(_S549, _S550, _S551, _S552);
    return vec3<f32>(cell_maximum_0(_S549, _S555), select(_S555.warp_2.below_0, _S555.warp_2.above_0, _S553), select(_S555.weft_2.below_0, _S555.weft_2.above_0, _S554));
}

fn first_sample_height_0( _S556 : u32,  _S557 : ViewRay_0,  _S558 : StepControl_0,  _S559 : bool) -> f32
{
    var _S560 : f32 = max_height_along_0(_S556, _S557.origin_0.x, _S557.origin_0.y, 0.0f, vec3<f32>(_S557.slope_1, 1.0f), _S559);
    var count_5 : u32 = u32(0);
    var height_11 : f32 = _S560;
    for(;;)
    {
        if(count_5 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S561 : vec2<f32> = ViewRay_at_0(_S557, height_11);
        var _S562 : vec3<f32> = cell_bounds_0(_S556, _S561.x, _S561.y, _S559, _S558.right_0, _S558.up_0);
        var _S563 : f32 = height_11 - _S562.x;
        var _S564 : f32 = StepControl_to_cell_exit_0(_S558, _S562.y, _S562.z);
        var height_12 : f32 = height_11 - clamp(_S563, 0.0f, _S564);
        if(_S563 <= _S564)
        {
            height_11 = height_12;
            break;
        }
        count_5 = count_5 + u32(1);
        height_11 = height_12;
    }
    return height_11;
}

fn search_down_0( _S565 : u32,  _S566 : ViewRay_0,  _S567 : StepControl_0,  _S568 : bool) -> ViewRayEnd_0
{
    var _S569 : f32 = fabrics_0[_S565].height_low_0 - (fabrics_0[_S565].height_high_0 - fabrics_0[_S565].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_10 = first_sample_height_0(_S565, _S566, _S567, _S568);
    end_1.last_step_3 = _S567.epsilon_0;
    end_1.previous_4 = no_previous_sample_0();
    end_1.depth_2 = 0.0f;
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
        var _S570 : vec2<f32> = ViewRay_at_0(_S566, end_1.height_10);
        var _S571 : Probe_0 = probe_0(_S565, _S570.x, _S570.y, _S568, _S567.right_0, _S567.up_0);
        var _S572 : f32 = end_1.height_10 - _S571.height_4;
        var _S573 : f32 = ViewRay_rate_0(_S566, _S571);
        end_1.depth_2 = - _S572;
        end_1.rate_4 = _S573;
        var _S574 : bool = !_S571.hole_4;
        end_1.smooth_0 = ((((end_1.previous_4.known_0) & (_S574))) & (((end_1.previous_4.yarn_0) == (_S571.yarn_1))));
        if((((_S574 & ((_S572 <= 0.0f)))) | (((end_1.height_10) <= _S569))))
        {
            break;
        }
        var _S575 : f32 = way_back_to_dip_0(end_1.previous_4, _S572, _S573, end_1.last_step_3, _S571);
        if(_S575 >= 0.0f)
        {
            end_1.height_10 = end_1.height_10 + _S575;
            end_1.last_step_3 = end_1.last_step_3 - _S575;
            count_6 = count_6 + u32(1);
            continue;
        }
        var _S576 : f32 = min(StepControl_to_cell_exit_0(_S567, _S571.side_x_0, _S571.side_y_0), end_1.height_10 - _S571.cell_max_0);
        var _S577 : f32 = StepControl_to_next_sample_0(_S567, _S571, _S572, _S573);
        end_1.previous_4 = after_sample_0(_S572, _S573, _S571, _S576 > _S577);
        var _S578 : f32 = max(_S576, _S577);
        end_1.last_step_3 = _S578;
        end_1.height_10 = end_1.height_10 - _S578;
        count_6 = count_6 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S579 : u32,  _S580 : ViewRay_0,  _S581 : StepControl_0,  _S582 : bool,  _S583 : ViewRayEnd_0,  _S584 : u32) -> f32
{
    var _S585 : f32 = fabrics_0[_S579].height_high_0 - fabrics_0[_S579].height_low_0;
    var above_2 : f32 = _S583.height_10 + _S583.last_step_3;
    var above_gap_1 : f32 = clamp(_S583.previous_4.clearance_0, 0.0f, _S585);
    var under_gap_1 : f32 = clamp(_S583.depth_2, 0.0f, _S585);
    var middle_0 : f32 = select(between_0(above_2, _S583.height_10, above_gap_1, under_gap_1), above_2 - cubic_root_0(above_gap_1, - under_gap_1, _S583.previous_4.rate_0 * _S583.last_step_3, _S583.rate_4 * _S583.last_step_3) * _S583.last_step_3, _S583.smooth_0);
    var side_3 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S583.height_10;
    var above_3 : f32 = above_2;
    var i_2 : u32 = u32(0);
    for(;;)
    {
        if(i_2 < _S584)
        {
        }
        else
        {
            break;
        }
        var _S586 : vec2<f32> = ViewRay_at_0(_S580, middle_0);
        var _S587 : Probe_0 = probe_0(_S579, _S586.x, _S586.y, _S582, _S581.right_0, _S581.up_0);
        var _S588 : f32 = clamp(middle_0 - select(_S587.height_4, -1.0e+09f, _S587.hole_4), - _S585, _S585);
        if(_S588 <= 0.0f)
        {
            var _S589 : f32 = select(above_gap_2, 0.5f * above_gap_2, side_3 > 0.0f);
            var _S590 : f32 = - _S588;
            under_1 = middle_0;
            above_gap_2 = _S589;
            under_gap_2 = _S590;
            side_3 = 1.0f;
        }
        else
        {
            var _S591 : f32 = select(under_gap_2, 0.5f * under_gap_2, side_3 < 0.0f);
            above_3 = middle_0;
            above_gap_2 = _S588;
            under_gap_2 = _S591;
            side_3 = -1.0f;
        }
        var _S592 : f32 = select(between_0(above_3, under_1, above_gap_2, under_gap_2), clamp(middle_0 + _S588 / min(ViewRay_rate_0(_S580, _S587), -9.99999997475242708e-07f), under_1, above_3), _S583.smooth_0);
        var _S593 : u32 = i_2 + u32(1);
        middle_0 = _S592;
        i_2 = _S593;
    }
    return select(under_1, middle_0, _S583.smooth_0);
}

fn first_hit_of_yarn_0( _S594 : u32,  _S595 : SearchQuality_0,  _S596 : f32,  _S597 : f32,  _S598 : vec3<f32>,  _S599 : bool) -> Hit_0
{
    var _S600 : f32 = max(_S598.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S596, _S597);
    var _S601 : vec2<f32> = _S598.xy / vec2<f32>(_S600);
    ray_0.slope_1 = _S601;
    var _S602 : StepControl_0 = step_control_0((vec2<f32>(0) - _S601), 1.0f / max(steps_per_length_0(_S594, _S595, _S598) / _S600, 9.99999971718068537e-10f));
    var _S603 : ViewRayEnd_0 = search_down_0(_S594, ray_0, _S602, _S599);
    var hit_0 : Hit_0;
    hit_0.hole_7 = false;
    var _S604 : f32 = refined_height_0(_S594, ray_0, _S602, _S599, _S603, _S595.refinements_0);
    hit_0.height_8 = _S604;
    var _S605 : vec2<f32> = ViewRay_at_0(ray_0, _S604);
    hit_0.x_18 = _S605.x;
    hit_0.y_11 = _S605.y;
    return hit_0;
}

fn first_hit_0( _S606 : u32,  _S607 : SearchQuality_0,  _S608 : f32,  _S609 : f32,  _S610 : vec3<f32>,  _S611 : bool) -> Hit_0
{
    if(!passes_through_0(_S606, _S607, _S608, _S609, _S610, _S611))
    {
        return first_hit_of_yarn_0(_S606, _S607, _S608, _S609, _S610, _S611);
    }
    var hit_1 : Hit_0;
    hit_1.x_18 = _S608;
    hit_1.y_11 = _S609;
    hit_1.height_8 = 0.0f;
    hit_1.hole_7 = true;
    return hit_1;
}

fn surface_of_0( _S612 : u32,  _S613 : Sample_0,  _S614 : f32,  _S615 : f32,  _S616 : bool) -> SurfacePoint_0
{
    var _S617 : u32 = select(fabrics_0[_S612].weft_0, fabrics_0[_S612].warp_0, _S613.shown_3.is_warp_2);
    var _S618 : f32 = families_0[_S617].twist_sine_0 * select(1.0f, -1.0f, _S616);
    var _S619 : f32 = select(-1.0f, 1.0f, _S613.shown_3.is_warp_2);
    var _S620 : vec2<f32> = fibre_direction_0(_S613.slope_across_0, _S619 * _S613.slope_along_0, _S618, families_0[_S617].twist_cosine_0);
    var _S621 : f32 = _S620.x;
    var _S622 : f32 = _S620.y;
    var _S623 : f32 = select(_S613.slope_y_1, _S613.slope_x_1, _S613.shown_3.is_warp_2) * _S621 + _S619 * select(_S613.slope_x_1, _S613.slope_y_1, _S613.shown_3.is_warp_2) * _S622;
    var _S624 : f32 = select(_S613.crossing_2.weft_2.half_width_1, _S613.crossing_2.warp_2.half_width_1, _S613.shown_3.is_warp_2) * 1.0154266357421875f;
    var _S625 : f32 = _S624 * arc_sine_0(clamp(_S613.section_1.across_3 / _S624, -1.0f, 1.0f));
    var _S626 : f32 = select(- _S614, _S615, _S613.shown_3.is_warp_2);
    var point_4 : SurfacePoint_0;
    point_4.hole_0 = _S613.shown_3.hole_3;
    point_4.is_warp_0 = _S613.shown_3.is_warp_2;
    point_4.warp_thread_0 = _S613.crossing_2.warp_2.thread_1;
    point_4.weft_thread_0 = _S613.crossing_2.weft_2.thread_1;
    point_4.height_2 = _S613.height_9;
    point_4.normal_1 = normalize(vec3<f32>(- _S613.slope_x_1, - _S613.slope_y_1, 1.0f));
    point_4.tangent_0 = normalize(select_vector_1(_S613.shown_3.is_warp_2, vec3<f32>(_S621, _S622, _S623), vec3<f32>(- _S622, _S621, _S623)));
    point_4.across_1 = _S613.section_1.across_3;
    point_4.fibre_across_0 = _S625 * families_0[_S617].twist_cosine_0 + _S626 * _S618;
    point_4.fibre_along_0 = _S626 * families_0[_S617].twist_cosine_0 - _S625 * _S618;
    var _S627 : f32 = run_share_0(_S613.shown_3.word_0);
    point_4.shown_share_0 = select(1.0f - _S627, _S627, _S613.shown_3.on_top_0);
    point_4.x_8 = _S614;
    point_4.y_2 = _S615;
    return point_4;
}

fn surface_met_0( _S628 : u32,  _S629 : f32,  _S630 : f32,  _S631 : f32,  _S632 : vec3<f32>,  _S633 : bool) -> SurfacePoint_0
{
    var _S634 : Sample_0 = sample_at_0(_S628, _S629, _S630, _S633);
    var point_5 : SurfacePoint_0 = surface_of_0(_S628, _S634, _S629, _S630, _S633);
    var _S635 : u32 = select(fabrics_0[_S628].weft_0, fabrics_0[_S628].warp_0, point_5.is_warp_0);
    var _S636 : f32 = select(_S634.crossing_2.weft_2.half_width_1, _S634.crossing_2.warp_2.half_width_1, point_5.is_warp_0) * 1.0154266357421875f;
    var _S637 : f32 = _S634.dive_1.z;
    var _S638 : f32 = _S634.slope_along_0 - (1.0f - _S637) * _S634.dive_1.y / families_0[_S635].height_scale_0;
    var _S639 : f32 = rsqrt_0(_S638 * _S638 + 1.0f);
    var _S640 : f32 = _S632.x;
    var _S641 : f32 = _S632.y;
    var _S642 : f32 = select(_S641, _S640, point_5.is_warp_0);
    var _S643 : f32 = _S632.z;
    var _S644 : f32 = (_S643 / families_0[_S635].height_scale_0 - _S638 * select(_S640, _S641, point_5.is_warp_0)) * _S639;
    var _S645 : f32 = square_1(_S636);
    var _S646 : f32 = sqrt(max(_S645 - square_1(point_5.across_1), 0.0f)) - (_S634.height_9 + _S637 * _S634.dive_1.x - _S631) / families_0[_S635].height_scale_0 * _S639;
    var _S647 : f32 = square_1(_S642) + square_1(_S644) + 9.999999960041972e-13f;
    var _S648 : f32 = point_5.across_1 * _S642 + _S646 * _S644;
    var _S649 : f32 = square_1(point_5.across_1) + square_1(_S646) - _S645;
    var _S650 : f32 = sqrt(max(square_1(_S648) - _S647 * _S649, 0.0f));
    var _S651 : f32 = clamp(select((_S650 - _S648) / _S647, - _S649 / max(_S648 + _S650, 9.999999960041972e-13f), _S648 > 0.0f), - _S636, _S636);
    var _S652 : f32 = point_5.across_1 + _S651 * _S642;
    point_5.across_1 = _S652;
    var _S653 : vec2<f32> = normalize(vec2<f32>(_S652, _S646 + _S651 * _S644));
    var _S654 : f32 = select(-1.0f, 1.0f, point_5.is_warp_0);
    var _S655 : f32 = families_0[_S635].twist_sine_0 * select(1.0f, -1.0f, _S633);
    var _S656 : f32 = _S653.x;
    var _S657 : f32 = _S655 * _S656 * _S639;
    var _S658 : f32 = _S653.y;
    var _S659 : f32 = - _S655 * _S658;
    var _S660 : f32 = families_0[_S635].twist_cosine_0 * _S639 - _S654 * _S638 * _S657;
    var _S661 : f32 = families_0[_S635].height_scale_0 * (families_0[_S635].twist_cosine_0 * _S654 * _S638 * _S639 + _S657);
    var _S662 : f32 = families_0[_S635].height_scale_0 * _S656;
    var _S663 : f32 = - families_0[_S635].height_scale_0 * _S638 * _S639 * _S658;
    point_5.normal_1 = normalize(vec3<f32>(select(_S663, _S662, point_5.is_warp_0), select(_S662, _S663, point_5.is_warp_0), _S639 * _S658));
    point_5.tangent_0 = normalize(vec3<f32>(select(- _S660, _S659, point_5.is_warp_0), select(_S659, _S660, point_5.is_warp_0), _S661));
    var _S664 : f32 = _S636 * angle_of_0(_S653);
    var _S665 : f32 = select(- _S629 - _S651 * _S640, _S630 + _S651 * _S641, point_5.is_warp_0);
    point_5.fibre_across_0 = _S664 * families_0[_S635].twist_cosine_0 + _S665 * _S655;
    point_5.fibre_along_0 = _S665 * families_0[_S635].twist_cosine_0 - _S664 * _S655;
    var _S666 : f32 = 0.00999999977648258f * _S636;
    var _S667 : f32 = - _S666;
    var _S668 : bool = _S651 < _S667;
    var _S669 : f32 = select(_S666, _S667, _S642 < 0.0f);
    var _S670 : f32 = max(_S651, 0.0f);
    point_5.x_8 = point_5.x_8 + select(_S670 * _S640, select(0.0f, _S669, point_5.is_warp_0), _S668);
    point_5.y_2 = point_5.y_2 + select(_S670 * _S641, select(_S669, 0.0f, point_5.is_warp_0), _S668);
    point_5.height_2 = select(_S631 + _S651 * _S643, _S631, _S668);
    return point_5;
}

fn hairs_over_0( _S671 : u32,  _S672 : SurfacePoint_0,  _S673 : bool,  _S674 : f32) -> Hairs_0
{
    var hairs_2 : Hairs_0;
    hairs_2.place_1 = vec2<f32>(_S672.x_8, _S672.y_2);
    hairs_2.below_1 = fabrics_0[_S671].height_high_0 - _S672.height_2;
    hairs_2.back_4 = _S673;
    hairs_2.size_3 = _S674;
    return hairs_2;
}

fn has_hairs_0( _S675 : u32) -> bool
{
    return (((families_0[fabrics_0[_S675].warp_0].hairiness_0) > 0.0f) | (((families_0[fabrics_0[_S675].weft_0].hairiness_0) > 0.0f)));
}

fn hair_towards_0( _S676 : u32,  _S677 : Hairs_0,  _S678 : vec3<f32>,  _S679 : f32) -> Hair_0
{
    var _S680 : f32 = fabrics_0[_S676].fibre_size_0;
    var _S681 : f32 = 17.0f * fabrics_0[_S676].fibre_size_0;
    var _S682 : f32 = fade_0(_S679, _S681);
    var _S683 : vec2<f32> = _S678.xy / vec2<f32>(max(_S678.z, 0.3333333432674408f));
    var _S684 : u32 = hash_key_0(select(u32(0), u32(1), _S677.back_4), ((fabrics_0[_S676].seed_0) ^ (u32(1013904242))));
    var _S685 : f32 = fabrics_0[_S676].fibre_size_0 / max(_S679, 0.07000000029802322f * fabrics_0[_S676].fibre_size_0);
    const _S686 : vec2<f32> = vec2<f32>(0.0f, 1.0f);
    var cover_3 : f32 = 0.0f;
    var hair_across_0 : vec2<f32> = _S686;
    var hair_away_0 : f32 = 0.0f;
    var is_warp_7 : bool = false;
    var number_5 : u32 = u32(0);
    for(;;)
    {
        if(((_S682 > 0.0f) & ((number_5 < u32(18)))))
        {
        }
        else
        {
            break;
        }
        var _S687 : u32 = number_5 / u32(9);
        var _S688 : u32 = number_5 / u32(3) - u32(3) * _S687;
        var _S689 : vec2<f32> = (vec2<f32>(((f32(_S687) * 6.0f + 2.0f) * _S680 + _S677.below_1)) * _S683 + _S677.place_1) / vec2<f32>(_S681);
        var _S690 : vec2<f32> = floor(_S689) + vec2<f32>(f32(number_5 - u32(3) * _S688 - u32(9) * _S687), f32(_S688)) - vec2<f32>(1.0f);
        var _S691 : u32 = hash_bits_0(_S684 + _S687, u32(i32(_S690.x)) * u32(65536) + u32(i32(_S690.y)));
        var _S692 : u32 = hash_bits_0(_S684, _S691);
        var _S693 : vec2<f32> = _S689 - _S690 - vec2<f32>(share_of_0(_S691), share_of_0((_S691 >> (u32(10)))));
        var _S694 : vec2<f32> = sine_cosine_0(3.14159274101257324f * share_of_0((_S691 >> (u32(20)))));
        var _S695 : f32 = mix(5.0f, 16.0f, share_of_0((_S692 >> (u32(10))))) / 17.0f;
        var _S696 : f32 = _S693.x;
        var _S697 : f32 = _S694.y;
        var _S698 : f32 = _S693.y;
        var _S699 : f32 = _S694.x;
        var _S700 : f32 = (_S696 * _S697 + _S698 * _S699) / _S695;
        var _S701 : f32 = 0.69999998807907104f * (2.0f * share_of_0((_S692 >> (u32(20)))) - 1.0f);
        var _S702 : f32 = 0.5f * (2.0f * share_of_0((_S691 ^ (_S692))) - 1.0f);
        var _S703 : f32 = _S700 * (3.0f * _S702 * _S700 + 2.0f * _S701);
        var _S704 : f32 = rsqrt_0(_S703 * _S703 + 1.0f);
        var _S705 : f32 = (_S698 * _S697 - _S696 * _S699 - _S695 * _S700 * _S700 * (_S702 * _S700 + _S701)) * _S704 * 17.0f;
        var _S706 : f32 = 0.2800000011920929f * max(1.0f - square_1(square_1(_S700)), 0.0f) * _S685;
        var _S707 : f32 = clamp(_S706 + 0.5f - abs(_S705) * _S685, 0.0f, min(2.0f * _S706, 1.0f));
        var _S708 : bool = ((((_S692 >> (u32(30)))) & (u32(1)))) == u32(1);
        var _S709 : bool = (((((share_of_0(_S692)) < (families_0[select(fabrics_0[_S676].weft_0, fabrics_0[_S676].warp_0, _S708)].hairiness_0)) & (((abs(_S700)) < 1.0f)))) & ((_S707 > cover_3)));
        var _S710 : vec2<f32> = vec2<f32>(- _S699 - _S703 * _S697, _S697 - _S703 * _S699) * vec2<f32>(_S704);
        var _S711 : f32 = select(cover_3, _S707, _S709);
        var _S712 : vec2<f32> = vec2<f32>(select(hair_across_0.x, _S710.x, _S709), select(hair_across_0.y, _S710.y, _S709));
        var _S713 : f32 = select(hair_away_0, _S705, _S709);
        var _S714 : bool = select(is_warp_7, _S708, _S709);
        var _S715 : u32 = number_5 + u32(1);
        cover_3 = _S711;
        hair_across_0 = _S712;
        hair_away_0 = _S713;
        is_warp_7 = _S714;
        number_5 = _S715;
    }
    var _S716 : f32 = clamp(hair_away_0 * 2.85714292526245117f, -0.80000001192092896f, 0.80000001192092896f);
    var hair_1 : Hair_0;
    hair_1.cover_1 = _S682 * cover_3;
    hair_1.normal_5 = vec3<f32>(vec2<f32>(_S716) * hair_across_0, sqrt(1.0f - _S716 * _S716));
    hair_1.tangent_4 = vec3<f32>(hair_across_0.y, - hair_across_0.x, 0.0f);
    hair_1.is_warp_5 = is_warp_7;
    hair_1.shade_0 = _S682 * 0.03255363181233406f * (families_0[fabrics_0[_S676].warp_0].hairiness_0 + families_0[fabrics_0[_S676].weft_0].hairiness_0);
    return hair_1;
}

fn thread_of_family_0( _S717 : u32,  _S718 : SurfacePoint_0) -> i32
{
    var _S719 : u32 = select(fabrics_0[_S717].weft_0, fabrics_0[_S717].warp_0, _S718.is_warp_0);
    return i32(floor((select(_S718.y_2, _S718.x_8, _S718.is_warp_0) - _S718.across_1) / families_0[_S719].period_0)) * i32(families_0[_S719].count_0) + i32(select(_S718.weft_thread_0, _S718.warp_thread_0, _S718.is_warp_0));
}

fn thread_number_0( _S720 : u32,  _S721 : SurfacePoint_0) -> u32
{
    return u32(thread_of_family_0(_S720, _S721)) * u32(2) + select(u32(0), u32(1), _S721.is_warp_0);
}

struct FibreNoise_0
{
     bundle_0 : vec2<f32>,
     bundle_weight_0 : f32,
     bundle_offset_0 : f32,
     fibre_0 : vec2<f32>,
     fibre_weight_0 : f32,
     offset_2 : f32,
     slope_2 : f32,
};

fn fibre_noise_at_0( _S722 : u32,  _S723 : u32,  _S724 : SurfacePoint_0,  _S725 : u32,  _S726 : f32) -> FibreNoise_0
{
    var _S727 : f32 = 5.0f * fabrics_0[_S722].fibre_size_0;
    var _S728 : vec2<f32> = wave_noise_0(hash_key_0(_S725, ((fabrics_0[_S722].seed_0) ^ (u32(458671337)))), _S724.fibre_along_0 / (25.0f * fabrics_0[_S722].fibre_size_0));
    var _S729 : f32 = _S724.fibre_across_0 + families_0[_S723].fibre_tilt_0 * 0.5f * 25.0f * fabrics_0[_S722].fibre_size_0 * _S728.x;
    var _S730 : vec3<f32> = fibre_cell_0(_S729, _S724.fibre_along_0, fabrics_0[_S722].fibre_size_0);
    var _S731 : vec3<f32> = fibre_cell_0(_S729, _S724.fibre_along_0, _S727);
    var noise_0 : FibreNoise_0;
    noise_0.bundle_0 = cell_noise_0(hash_key_0(_S725, ((fabrics_0[_S722].seed_0) ^ (u32(1757159915)))), _S731);
    noise_0.bundle_offset_0 = _S731.z;
    noise_0.bundle_weight_0 = fade_0(_S726, _S727);
    noise_0.fibre_0 = cell_noise_0(hash_key_0(_S725, ((fabrics_0[_S722].seed_0) ^ (u32(48610963)))), _S730);
    noise_0.fibre_weight_0 = fade_0(_S726, fabrics_0[_S722].fibre_size_0);
    noise_0.offset_2 = _S730.z;
    noise_0.slope_2 = 0.5f * _S728.y;
    return noise_0;
}

fn turned_frame_0( _S732 : u32,  _S733 : u32,  _S734 : SurfacePoint_0,  _S735 : bool,  _S736 : u32,  _S737 : f32) -> YarnFrame_0
{
    var frame_2 : YarnFrame_0;
    frame_2.normal_7 = _S734.normal_1;
    frame_2.tangent_6 = _S734.tangent_0;
    frame_2.loss_0 = 0.0f;
    frame_2.shade_2 = 0.0f;
    if((families_0[_S733].has_plies_0) > 0.0f)
    {
        var _S738 : f32 = fade_0(_S737, 1.0f / families_0[_S733].plies_per_mm_0);
        var _S739 : f32 = _S738 * 0.62000000476837158f * ply_offset_0(_S733, _S734, _S735);
        var _S740 : vec3<f32> = cross(frame_2.tangent_6, frame_2.normal_7);
        var _S741 : vec3<f32> = vec3<f32>(families_0[_S733].ply_cosine_0);
        var _S742 : vec3<f32> = vec3<f32>(select(families_0[_S733].ply_sine_0, - families_0[_S733].ply_sine_0, _S735));
        var _S743 : vec3<f32> = _S741 * _S740 + _S742 * frame_2.tangent_6;
        var _S744 : vec3<f32> = vec3<f32>(sqrt(1.0f - _S739 * _S739));
        var _S745 : vec3<f32> = vec3<f32>(_S739);
        frame_2.tangent_6 = _S741 * (_S741 * frame_2.tangent_6 - _S742 * _S740) + _S742 * (_S744 * _S743 - _S745 * frame_2.normal_7);
        frame_2.normal_7 = _S744 * frame_2.normal_7 + _S745 * _S743;
        frame_2.loss_0 = _S738 * _S738 * 0.62000000476837158f * 0.62000000476837158f / 3.0f;
    }
    var _S746 : f32 = families_0[_S733].fibre_tilt_0;
    if((families_0[_S733].fibre_tilt_0) > 0.0f)
    {
        var _S747 : FibreNoise_0 = fibre_noise_at_0(_S732, _S733, _S734, _S736, _S737);
        var _S748 : f32 = 1.09858846664428711f * _S746 * (_S747.bundle_weight_0 * _S747.bundle_0.x + _S747.fibre_weight_0 * (_S747.fibre_0.x + _S747.offset_2));
        var _S749 : f32 = _S746 * (1.42099642753601074f * (_S747.bundle_weight_0 * _S747.bundle_0.y + _S747.fibre_weight_0 * _S747.fibre_0.y) - _S747.bundle_weight_0 * _S747.slope_2);
        var _S750 : f32 = square_1(_S747.fibre_weight_0);
        frame_2.loss_0 = frame_2.loss_0 + 0.5f * _S746 * _S746 * ((0.24761904776096344f * (square_1(_S747.bundle_weight_0) + _S750) + _S750 / 3.0f) * 1.09858846664428711f * 1.09858846664428711f);
        var _S751 : vec3<f32> = cross(frame_2.tangent_6, frame_2.normal_7);
        var _S752 : vec2<f32> = sine_cosine_0(_S748);
        var _S753 : vec2<f32> = sine_cosine_0(_S749);
        var _S754 : vec3<f32> = vec3<f32>(_S752.y);
        var _S755 : vec3<f32> = vec3<f32>(_S752.x);
        var _S756 : vec3<f32> = _S754 * _S751 - _S755 * frame_2.normal_7;
        frame_2.normal_7 = _S754 * frame_2.normal_7 + _S755 * _S751;
        frame_2.tangent_6 = vec3<f32>(_S753.y) * frame_2.tangent_6 + vec3<f32>(_S753.x) * _S756;
    }
    return frame_2;
}

fn uncoloured_point_0( _S757 : u32,  _S758 : SurfacePoint_0,  _S759 : vec3<f32>,  _S760 : bool,  _S761 : bool,  _S762 : f32) -> YarnPoint_0
{
    var _S763 : u32 = fabrics_0[_S757].warp_0;
    var _S764 : u32 = fabrics_0[_S757].weft_0;
    var _S765 : u32 = select(fabrics_0[_S757].weft_0, fabrics_0[_S757].warp_0, _S758.is_warp_0);
    var _S766 : bool = (((fabrics_0[_S757].has_detail_0) != u32(0)) & ((_S762 >= 0.0f)));
    var _S767 : vec3<f32> = vec3<f32>(0.0f);
    var point_6 : YarnPoint_0 = YarnPoint_x24init_0(false, false, false, 0.0f, 0.0f, 0.0f, _S767, _S767, _S767, 0.0f, 0.0f, Albedos_x24init_0(_S767, _S767, _S767, _S767), Hairs_x24init_0(vec2<f32>(0.0f), 0.0f, false, 0.0f), 0.0f);
    point_6.hairs_0 = hairs_over_0(_S757, _S758, _S760, _S762);
    point_6.hair_cover_0 = 1.0f;
    var _S768 : Hair_0 = Hair_x24init_0(0.0f, _S767, _S767, false, 0.0f);
    point_6.is_warp_3 = _S758.is_warp_0;
    var _S769 : bool = (_S766 & ((has_hairs_0(_S757))));
    var hair_2 : Hair_0;
    if(_S769)
    {
        var _S770 : Hair_0 = hair_towards_0(_S757, point_6.hairs_0, _S759, _S762);
        point_6.hair_cover_0 = _S770.cover_1;
        point_6.is_warp_3 = select(_S758.is_warp_0, _S770.is_warp_5, (_S770.cover_1) > 0.5f);
        hair_2 = _S770;
    }
    else
    {
        hair_2 = _S768;
    }
    var _S771 : u32 = select(_S764, _S763, point_6.is_warp_3);
    point_6.back_6 = _S760;
    point_6.hole_5 = _S761;
    point_6.x_11 = _S758.x_8;
    point_6.y_4 = _S758.y_2;
    point_6.height_6 = _S758.height_2 + hair_2.cover_1 * point_6.hairs_0.below_1;
    point_6.normal_3 = _S758.normal_1;
    point_6.tangent_2 = _S758.tangent_0;
    point_6.surface_normal_0 = normalize(mix(_S758.normal_1, vec3<f32>(0.0f, 0.0f, 1.0f), vec3<f32>(hair_2.cover_1)));
    point_6.diffuse_gain_0 = 1.0f;
    if(_S766)
    {
        var _S772 : YarnFrame_0 = turned_frame_0(_S757, _S765, _S758, _S760, thread_number_0(_S757, _S758), _S762);
        var frame_3 : YarnFrame_0;
        if(_S769)
        {
            frame_3 = under_hair_0(_S772, hair_2);
        }
        else
        {
            frame_3 = _S772;
        }
        point_6.normal_3 = frame_3.normal_7;
        point_6.tangent_2 = frame_3.tangent_6;
        point_6.diffuse_gain_0 = diffuse_gain_2(frame_3, fabrics_0[_S757].diffuse_blend_0);
    }
    point_6.roughness_1 = families_0[_S771].roughness_0;
    return point_6;
}

fn surface_at_0( _S773 : u32,  _S774 : f32,  _S775 : f32,  _S776 : bool) -> SurfacePoint_0
{
    return surface_of_0(_S773, sample_at_0(_S773, _S774, _S775, _S776), _S774, _S775, _S776);
}

fn unoccluded_0( _S777 : u32,  _S778 : SearchQuality_0,  _S779 : f32,  _S780 : f32,  _S781 : f32,  _S782 : vec3<f32>,  _S783 : bool) -> bool
{
    if((_S782.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S777, _S778, vec3<f32>(_S779, _S780, _S781 + fabrics_0[_S777].lift_0), _S782, _S783, max_height_along_0(_S777, _S779, _S780, _S781, _S782, _S783));
}

fn is_lit_0( _S784 : u32,  _S785 : SearchQuality_0,  _S786 : YarnPoint_0,  _S787 : vec3<f32>) -> bool
{
    if(_S786.hole_5)
    {
        return true;
    }
    var _S788 : vec3<f32> = to_face_frame_0(_S787, _S786.back_6);
    var _S789 : f32 = _S788.z;
    var _S790 : bool = _S789 < 0.0f;
    var normal_12 : vec3<f32>;
    var height_13 : f32;
    if(_S790)
    {
        var _S791 : SurfacePoint_0 = surface_at_0(_S784, _S786.x_11, _S786.y_4, !_S786.back_6);
        normal_12 = _S791.normal_1;
        height_13 = _S791.height_2;
    }
    else
    {
        normal_12 = _S786.surface_normal_0;
        height_13 = _S786.height_6;
    }
    var _S792 : vec3<f32> = vec3<f32>(_S788.xy, abs(_S789));
    if((dot(normal_12, _S792)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S784, _S785, _S786.x_11, _S786.y_4, height_13, _S792, (_S786.back_6) != _S790);
}

fn hairs_lit_0( _S793 : u32,  _S794 : Hairs_0,  _S795 : vec3<f32>) -> f32
{
    return 1.0f - 0.5f * hair_towards_0(_S793, _S794, _S795, _S794.size_3 + fabrics_0[_S793].fibre_size_0).cover_1;
}

fn under_hairs_0( _S796 : u32,  _S797 : YarnPoint_0,  _S798 : vec3<f32>) -> f32
{
    if((((_S797.hair_cover_0) >= 1.0f) | (((_S798.z) <= 0.0f))))
    {
        return 1.0f;
    }
    return mix(hairs_lit_0(_S796, _S797.hairs_0, _S798), 1.0f, _S797.hair_cover_0);
}

fn components_of_point_0( _S799 : u32,  _S800 : SearchQuality_0,  _S801 : YarnPoint_0,  _S802 : vec3<f32>,  _S803 : vec3<f32>) -> Components_0
{
    var result_3 : Components_0 = no_components_0();
    result_3.hole_2 = select(0.0f, 1.0f, _S801.hole_5);
    var _S804 : bool;
    if(_S801.hole_5)
    {
        _S804 = true;
    }
    else
    {
        _S804 = !is_lit_0(_S799, _S800, _S801, _S802);
    }
    if(_S804)
    {
        return result_3;
    }
    var _S805 : vec3<f32> = to_face_frame_0(_S802, _S801.back_6);
    var _S806 : vec3<f32> = to_face_frame_0(_S803, _S801.back_6);
    var _S807 : bool = (_S805.z) < 0.0f;
    var _S808 : f32 = under_hairs_0(_S799, _S801, _S805);
    var _S809 : f32 = _S808 * _S801.diffuse_gain_0 * diffuse_reflection_0(select_vector_1(_S807, (vec3<f32>(0) - _S805), _S805), _S801.normal_3, fabrics_0[_S799].diffuse_blend_0);
    var _S810 : f32;
    if(_S807)
    {
        _S810 = transmission_1(_S805, _S806, _S801.normal_3, _S801.tangent_2, _S801.roughness_1, fabrics_0[_S799].optical_depth_0);
    }
    else
    {
        _S810 = reflection_0(_S805, _S806, _S801.normal_3, _S801.tangent_2, _S801.roughness_1, fabrics_0[_S799].optical_depth_0);
    }
    var _S811 : f32 = _S808 * _S810;
    result_3.diffuse_warp_0 = select(0.0f, _S809, _S801.is_warp_3);
    result_3.diffuse_weft_0 = select(_S809, 0.0f, _S801.is_warp_3);
    result_3.specular_warp_0 = select(0.0f, _S811, _S801.is_warp_3);
    result_3.specular_weft_0 = select(_S811, 0.0f, _S801.is_warp_3);
    result_3.light_visibility_1 = 1.0f;
    return result_3;
}

fn openness_number_0( _S812 : u32,  _S813 : u32) -> f32
{
    return table_number_0(fabrics_0[_S812].openness_0 + _S813);
}

fn blocked_of_terms_0( _S814 : u32,  _S815 : u32,  _S816 : array<f32, i32(6)>,  _S817 : u32) -> Blocked_0
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
        var term_0 : u32 = u32(0);
        for(;;)
        {
            if(term_0 < _S817)
            {
            }
            else
            {
                break;
            }
            shares_2[share_4] = shares_2[share_4] + openness_number_0(_S814, _S815 + share_4 * _S817 + term_0) * _S816[term_0];
            term_0 = term_0 + u32(1);
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

fn blocked_at_0( _S818 : u32,  _S819 : bool,  _S820 : bool,  _S821 : f32,  _S822 : f32) -> Blocked_0
{
    var _S823 : f32 = _S822 * openness_number_0(_S818, u32(158));
    var terms_2 : array<f32, i32(6)> = array<f32, i32(6)>( 1.0f, _S821, _S823, _S821 * _S821, _S821 * _S823, _S823 * _S823 );
    return blocked_of_terms_0(_S818, u32(60) + (select(u32(0), u32(2), _S820) + select(u32(1), u32(0), _S819)) * u32(18), terms_2, u32(6));
}

fn with_blocked_0( _S824 : u32,  _S825 : Blocked_0,  _S826 : YarnPoint_0,  _S827 : bool,  _S828 : f32) -> Blocked_0
{
    if(((_S826.hole_5) | (((_S826.is_warp_3) != _S827))))
    {
        return _S825;
    }
    var _S829 : Blocked_0 = blocked_at_0(_S824, _S827, _S826.back_6, _S826.surface_normal_0.z, _S826.height_6);
    var result_4 : Blocked_0;
    result_4.by_warp_0 = _S825.by_warp_0 + _S828 * _S829.by_warp_0;
    result_4.by_weft_0 = _S825.by_weft_0 + _S828 * _S829.by_weft_0;
    result_4.far_0 = _S825.far_0 + _S828 * _S829.far_0;
    return result_4;
}

struct CoverageTaps_0
{
     nodes_1 : array<u32, i32(9)>,
};

fn pyramid_level_0( _S830 : u32,  _S831 : f32) -> vec3<f32>
{
    var _S832 : u32 = fabrics_0[_S830].lobes_0.levels_0 + u32(4) * u32(min(_S831, fabrics_0[_S830].lobes_0.last_level_0));
    return vec3<f32>(table_number_0(_S832), table_number_0(_S832 + u32(1)), table_number_0(_S832 + u32(2)));
}

fn coverage_taps_0( _S833 : u32,  _S834 : Footprint_0,  _S835 : bool) -> CoverageTaps_0
{
    var _S836 : Lobes_std430_0 = fabrics_0[_S833].lobes_0;
    var _S837 : f32 = Footprint_spread_side_0(_S834) * fabrics_0[_S833].lobes_0.inverse_base_size_0;
    var _S838 : vec3<f32> = pyramid_level_0(_S833, floor(binary_logarithm_0(max(0.68000000715255737f * _S837, 1.0f))));
    var _S839 : f32 = 1.0f / max(_S837, 9.99999997475242708e-07f);
    var _S840 : vec2<f32> = vec2<f32>(families_0[fabrics_0[_S833].warp_0].inverse_period_0, families_0[fabrics_0[_S833].weft_0].inverse_period_0);
    var _S841 : vec2<f32> = _S834.centre_0 * _S840;
    var _S842 : vec2<f32> = vec2<f32>(min(max(sqrt(clamp(1.29999995231628418f * (1.0f - _S839 * _S839), 0.0f, 1.0f)), 0.3333333432674408f * _S839), 1.0f));
    var _S843 : vec2<f32> = _S834.dx_0 * _S840 * _S842;
    var _S844 : vec2<f32> = _S834.dy_0 * _S840 * _S842;
    var taps_4 : CoverageTaps_0;
    var number_6 : u32 = u32(0);
    for(;;)
    {
        if(number_6 < u32(9))
        {
        }
        else
        {
            break;
        }
        var _S845 : vec2<f32> = _S841 + vec2<f32>(TAP_OFFSETS_0[number_6].x) * _S843 + vec2<f32>(TAP_OFFSETS_0[number_6].y) * _S844;
        var _S846 : f32 = _S838.y;
        taps_4.nodes_1[number_6] = select(u32(0), _S836.face_nodes_0, _S835) + u32(wrapped_cell_0(_S845.y, _S838.z) * _S846 + wrapped_cell_0(_S845.x, _S846) + _S838.x);
        number_6 = number_6 + u32(1);
    }
    return taps_4;
}

fn joint_ratios_0( _S847 : u32,  _S848 : vec3<f32>,  _S849 : vec3<f32>,  _S850 : bool) -> vec2<f32>
{
    var _S851 : NodeTaps_0 = node_taps_of_0(_S849, u32(16));
    var _S852 : NodeTaps_0 = node_taps_of_0(_S848, u32(16));
    var _S853 : u32 = fabrics_0[_S847].lobes_0.joint_0 + u32(2) * (select(u32(0), u32(2), _S850) + select(u32(0), u32(1), (_S848.z) < 0.0f)) * u32(512);
    var _S854 : u32 = _S853 + u32(512);
    return clamp(vec2<f32>(1.0f) + vec2<f32>(dot(joint_terms_0(_S851, _S853, u32(0)), joint_terms_0(_S852, _S854, u32(0))), dot(joint_terms_0(_S851, _S853, u32(1)), joint_terms_0(_S852, _S854, u32(1)))), vec2<f32>(0.0f), vec2<f32>(4.0f));
}

fn coverage_of_pack_0( _S855 : u32,  _S856 : CoverageTaps_0,  _S857 : u32) -> vec4<f32>
{
    var number_7 : u32 = u32(0);
    var even_1 : u32 = u32(0);
    var odd_1 : u32 = u32(0);
    for(;;)
    {
        if(number_7 < u32(9))
        {
        }
        else
        {
            break;
        }
        var _S858 : u32 = words_0[fabrics_0[_S855].lobes_0.coverage_0 + _S856.nodes_1[number_7] * fabrics_0[_S855].lobes_0.packs_0 + _S857];
        var even_2 : u32 = even_1 + ((_S858 & (u32(16711935))));
        var odd_2 : u32 = odd_1 + ((((_S858 >> (u32(8)))) & (u32(16711935))));
        number_7 = number_7 + u32(1);
        even_1 = even_2;
        odd_1 = odd_2;
    }
    return bytes_of_sums_0(even_1, odd_1) / vec4<f32>(9.0f);
}

fn coverage_of_holes_0( _S859 : u32,  _S860 : CoverageTaps_0) -> f32
{
    var number_8 : u32 = u32(0);
    var total_0 : u32 = u32(0);
    for(;;)
    {
        if(number_8 < u32(9))
        {
        }
        else
        {
            break;
        }
        var total_1 : u32 = total_0 + ((((words_0[fabrics_0[_S859].lobes_0.coverage_holes_0 + _S860.nodes_1[number_8] / u32(4)] >> ((u32(8) * (_S860.nodes_1[number_8] % u32(4)))))) & (u32(255))));
        number_8 = number_8 + u32(1);
        total_0 = total_1;
    }
    return f32(total_0) / 9.0f;
}

fn prefiltered_hole_0( _S861 : u32,  _S862 : CoverageTaps_0,  _S863 : NodeTaps_0,  _S864 : bool) -> f32
{
    var _S865 : f32 = interpolate_table_0(_S863, fabrics_0[_S861].lobes_0.projected_area_0 + fabrics_0[_S861].lobes_0.packs_0, fabrics_0[_S861].lobes_0.packs_0 + u32(1)).x;
    return min(coverage_of_holes_0(_S861, _S862) * _S865 * _S865 * select(fabrics_0[_S861].lobes_0.front_hole_weight_0, fabrics_0[_S861].lobes_0.back_hole_weight_0, _S864), 1.0f);
}

fn prefiltered_components_0( _S866 : u32,  _S867 : Footprint_0,  _S868 : vec3<f32>,  _S869 : vec3<f32>,  _S870 : bool) -> Components_0
{
    var _S871 : CoverageTaps_0 = coverage_taps_0(_S866, _S867, _S870);
    var _S872 : NodeTaps_0 = node_taps_0(_S869);
    var view_nodes_0 : NodeTaps_0 = _S872;
    var _S873 : NodeTaps_0 = node_taps_0(_S868);
    var light_nodes_0 : NodeTaps_0 = _S873;
    var _S874 : u32 = select(u32(0), u32(1), _S870);
    view_nodes_0.nodes_0 = view_nodes_0.nodes_0 + vec4<u32>((_S874 * u32(256)));
    light_nodes_0.nodes_0 = light_nodes_0.nodes_0 + vec4<u32>(((u32(2) * _S874 + select(u32(0), u32(1), (_S868.z) < 0.0f)) * u32(256)));
    var _S875 : vec3<f32> = half_vector_0(_S868, _S869);
    var _S876 : vec2<f32> = joint_ratios_0(_S866, _S868, _S869, _S870);
    var _S877 : Lobes_std430_0 = fabrics_0[_S866].lobes_0;
    var _S878 : u32 = select(fabrics_0[_S866].lobes_0.front_warp_packs_0, fabrics_0[_S866].lobes_0.back_warp_packs_0, _S870);
    var sums_6 : Components_0;
    sums_6.diffuse_warp_0 = 0.0f;
    sums_6.diffuse_weft_0 = 0.0f;
    sums_6.specular_warp_0 = 0.0f;
    sums_6.specular_weft_0 = 0.0f;
    sums_6.light_visibility_1 = 0.0f;
    var pack_0 : u32 = u32(0);
    var total_2 : f32 = 0.0f;
    for(;;)
    {
        if(pack_0 < (_S877.packs_0))
        {
        }
        else
        {
            break;
        }
        var _S879 : vec4<f32> = coverage_of_pack_0(_S866, _S871, pack_0);
        var _S880 : vec4<f32> = interpolate_table_0(view_nodes_0, _S877.projected_area_0 + pack_0, _S877.packs_0 + u32(1));
        var _S881 : vec4<f32> = interpolate_table_0(light_nodes_0, _S877.light_visibility_0 + pack_0, _S877.packs_0) / vec4<f32>(255.0f);
        var _S882 : vec4<f32> = interpolate_table_0(light_nodes_0, _S877.irradiance_0 + pack_0, _S877.packs_0) * vec4<f32>(0.00124827399849892f);
        var _S883 : bool = pack_0 < _S878;
        var _S884 : f32 = families_0[select(fabrics_0[_S866].weft_0, fabrics_0[_S866].warp_0, _S883)].roughness_0;
        var number_9 : u32 = u32(0);
        var diffuse_0 : f32 = 0.0f;
        var specular_0 : f32 = 0.0f;
        var lit_0 : f32 = 0.0f;
        for(;;)
        {
            if(number_9 < u32(4))
            {
            }
            else
            {
                break;
            }
            var _S885 : Group_0 = group_at_0(_S877.moments_0 + u32(12) * (u32(4) * (_S874 * _S877.packs_0 + pack_0) + number_9), _S884);
            var _S886 : f32 = _S879[number_9] * _S880[number_9] * _S880[number_9] * _S885.weight_2;
            var diffuse_1 : f32 = diffuse_0 + _S886 * _S882[number_9];
            var specular_1 : f32 = specular_0 + _S886 * layer_value_0(_S885, _S875, _S868, _S869, fabrics_0[_S866].optical_depth_0) * _S881[number_9];
            var lit_1 : f32 = lit_0 + _S886 * _S881[number_9];
            var total_3 : f32 = total_2 + _S886;
            number_9 = number_9 + u32(1);
            diffuse_0 = diffuse_1;
            specular_0 = specular_1;
            lit_0 = lit_1;
            total_2 = total_3;
        }
        sums_6.diffuse_warp_0 = sums_6.diffuse_warp_0 + select(0.0f, diffuse_0, _S883);
        sums_6.diffuse_weft_0 = sums_6.diffuse_weft_0 + select(diffuse_0, 0.0f, _S883);
        sums_6.specular_warp_0 = sums_6.specular_warp_0 + select(0.0f, specular_0, _S883);
        sums_6.specular_weft_0 = sums_6.specular_weft_0 + select(specular_0, 0.0f, _S883);
        sums_6.light_visibility_1 = sums_6.light_visibility_1 + lit_0 * select(_S876.y, _S876.x, _S883);
        pack_0 = pack_0 + u32(1);
    }
    var _S887 : f32 = prefiltered_hole_0(_S866, _S871, view_nodes_0, _S870);
    sums_6.hole_2 = _S887;
    var _S888 : f32 = 1.0f - _S887;
    var _S889 : f32 = _S888 / max(total_2, 9.999999960041972e-13f);
    var _S890 : f32 = _S889 * _S876.x;
    sums_6.diffuse_warp_0 = sums_6.diffuse_warp_0 * _S890;
    var _S891 : f32 = _S889 * _S876.y;
    sums_6.diffuse_weft_0 = sums_6.diffuse_weft_0 * _S891;
    sums_6.specular_warp_0 = sums_6.specular_warp_0 * _S890;
    sums_6.specular_weft_0 = sums_6.specular_weft_0 * _S891;
    sums_6.light_visibility_1 = min(sums_6.light_visibility_1 * _S889, _S888);
    return sums_6;
}

fn yarns_over_0( _S892 : u32,  _S893 : Footprint_0,  _S894 : bool) -> Yarns_0
{
    var _S895 : vec2<f32> = _S893.dx_0;
    var _S896 : vec2<f32> = _S893.dy_0;
    var _S897 : vec2<f32> = sqrt(_S895 * _S895 + _S896 * _S896);
    var _S898 : f32 = Footprint_spread_side_0(_S893);
    var _S899 : vec4<f32> = vec4<f32>(0.0f);
    var yarns_0 : Yarns_0 = Yarns_x24init_0(_S899, _S899, vec3<f32>(0.0f));
    var _S900 : bool = (fabrics_0[_S892].is_irregular_0) != u32(0);
    var number_10 : u32 = u32(0);
    for(;;)
    {
        if(number_10 < select(u32(0), u32(2), _S900))
        {
        }
        else
        {
            break;
        }
        var _S901 : bool = number_10 == u32(0);
        var _S902 : u32 = select(fabrics_0[_S892].weft_0, fabrics_0[_S892].warp_0, _S901);
        var _S903 : vec2<f32> = select_vector_0(_S901, _S893.centre_0, _S893.centre_0.yx);
        var _S904 : vec2<f32> = select_vector_0(_S901, _S897, _S897.yx);
        var _S905 : f32 = _S903.x;
        var _S906 : Cell_0 = locate_0(_S902, _S905);
        var yarn_3 : vec4<f32> = irregular_over_0(_S902, irregular_key_0(_S892, number_10), irregular_thread_0(_S902, _S905, _S906) + _S906.below_0 / (_S906.below_0 + _S906.above_0), _S904.x * (families_0[_S902].count_0 / families_0[_S902].period_0), _S903.y, _S904.y);
        yarn_3[i32(1)] = yarn_3[i32(1)] * (1.0f - moved_share_0(_S902, _S898));
        yarns_0.warp_3 = yarns_0.weft_3;
        yarns_0.weft_3 = yarn_3;
        number_10 = number_10 + u32(1);
    }
    var _S907 : vec2<f32> = vec2<f32>(families_0[fabrics_0[_S892].warp_0].cover_0, families_0[fabrics_0[_S892].weft_0].cover_0);
    var _S908 : f32 = select(fabrics_0[_S892].warp_on_top_0, 1.0f - fabrics_0[_S892].warp_on_top_0, _S894);
    var _S909 : vec3<f32> = shown_of_covers_0(_S907, _S908);
    var _S910 : vec3<f32> = select_vector_1(_S900, shown_of_covers_0(saturate(_S907 + _S907 * vec2<f32>(yarns_0.warp_3.y, yarns_0.weft_3.y)), _S908) / max(_S909, vec3<f32>(0.00009999999747379f)), vec3<f32>(1.0f));
    yarns_0.shares_0 = _S910;
    yarns_0.shares_0[i32(2)] = select(1.0f, _S910.z, (_S909.z) > 0.00009999999747379f);
    return yarns_0;
}

fn with_shares_0( _S911 : u32,  _S912 : Components_0,  _S913 : Yarns_0) -> Components_0
{
    var result_5 : Components_0;
    var _S914 : f32 = min(_S912.hole_2 * _S913.shares_0.z, 1.0f);
    result_5.hole_2 = _S914;
    var _S915 : f32 = _S913.shares_0.x;
    result_5.diffuse_warp_0 = _S912.diffuse_warp_0 * _S915;
    var _S916 : f32 = _S913.shares_0.y;
    result_5.diffuse_weft_0 = _S912.diffuse_weft_0 * _S916;
    result_5.specular_warp_0 = _S912.specular_warp_0 * _S915;
    result_5.specular_weft_0 = _S912.specular_weft_0 * _S916;
    result_5.light_visibility_1 = _S912.light_visibility_1 * select(1.0f, (1.0f - _S914) / max(1.0f - _S912.hole_2, 9.99999997475242708e-07f), (fabrics_0[_S911].is_irregular_0) != u32(0));
    return result_5;
}

fn albedos_over_0( _S917 : u32,  _S918 : Footprint_0,  _S919 : bool) -> FamilyAlbedos_0
{
    var _S920 : vec2<f32> = _S918.dx_0;
    var _S921 : vec2<f32> = _S918.dy_0;
    var _S922 : vec2<f32> = sqrt(_S920 * _S920 + _S921 * _S921);
    var _S923 : Stretch_0 = stretch_of_0(fabrics_0[_S917].warp_0, _S918.centre_0.x, _S922.x);
    var _S924 : Stretch_0 = stretch_of_0(fabrics_0[_S917].weft_0, _S918.centre_0.y, _S922.y);
    var albedos_8 : FamilyAlbedos_0;
    albedos_8.warp_7 = mean_albedos_0(fabrics_0[_S917].warp_0, fabrics_0[_S917].weft_0, _S923, _S924, _S919);
    albedos_8.weft_7 = mean_albedos_0(fabrics_0[_S917].weft_0, fabrics_0[_S917].warp_0, _S924, _S923, _S919);
    return albedos_8;
}

fn toned_0( _S925 : u32,  _S926 : u32,  _S927 : Albedos_0,  _S928 : vec4<f32>) -> Albedos_0
{
    var _S929 : vec3<f32> = _S927.diffuse_reflect_0 + _S927.diffuse_transmit_0;
    var _S930 : vec3<f32> = vec3<f32>(1.0f);
    var _S931 : vec3<f32> = _S930 - vec3<f32>(fabrics_0[_S925].layer_bound_0) * max(_S927.specular_reflect_0, _S927.specular_transmit_0);
    var _S932 : vec3<f32> = vec3<f32>(0.0f);
    var _S933 : vec3<f32> = max(_S930 - _S929, _S932) / (_S930 + _S929);
    var _S934 : vec3<f32> = vec3<f32>(9.99999997475242708e-07f);
    var _S935 : vec3<f32> = (_S931 / max(_S929, _S934) - _S930) / max(vec3<f32>(0.89999997615814209f) * _S933, _S934);
    var _S936 : vec3<f32> = _S930 - vec3<f32>((saturate(min(min(_S935.x, _S935.y), _S935.z)) * _S928.z)) * _S933;
    var _S937 : vec3<f32> = min(vec3<f32>(families_0[_S926].nep_red_0, families_0[_S926].nep_green_0, families_0[_S926].nep_blue_0), _S931);
    var found_1 : Albedos_0 = _S927;
    var _S938 : f32 = _S928.w;
    var _S939 : vec3<f32> = _S936 * _S927.diffuse_transmit_0 * vec3<f32>((1.0f - _S938));
    found_1.diffuse_transmit_0 = _S939;
    found_1.diffuse_reflect_0 = clamp(mix(_S936 * _S927.diffuse_reflect_0, _S937, vec3<f32>(_S938)), _S932, max(_S931 - _S939, _S932));
    return found_1;
}

fn with_tones_0( _S940 : u32,  _S941 : FamilyAlbedos_0,  _S942 : Yarns_0) -> FamilyAlbedos_0
{
    if((fabrics_0[_S940].is_irregular_0) == u32(0))
    {
        return _S941;
    }
    var result_6 : FamilyAlbedos_0;
    result_6.warp_7 = toned_0(_S940, fabrics_0[_S940].warp_0, _S941.warp_7, _S942.warp_3);
    result_6.weft_7 = toned_0(_S940, fabrics_0[_S940].weft_0, _S941.weft_7, _S942.weft_3);
    return result_6;
}

fn detail_gain_0( _S943 : u32,  _S944 : u32,  _S945 : SurfacePoint_0,  _S946 : bool,  _S947 : u32,  _S948 : f32) -> vec2<f32>
{
    var _S949 : vec2<f32> = vec2<f32>(0.0f);
    var gain_2 : vec2<f32>;
    if((families_0[_S944].has_plies_0) > 0.0f)
    {
        gain_2 = groove_0(0.94999998807907104f * fade_0(_S948, 1.0f / families_0[_S944].plies_per_mm_0), ply_offset_0(_S944, _S945, _S946));
    }
    else
    {
        gain_2 = _S949;
    }
    if((families_0[_S944].fibre_tone_0) > 0.0f)
    {
        var _S950 : FibreNoise_0 = fibre_noise_at_0(_S943, _S944, _S945, _S947, _S948);
        var _S951 : f32 = 4.5f * families_0[_S944].fibre_tone_0;
        gain_2 = gain_2 + vec2<f32>(families_0[_S944].fibre_tone_0) * vec2<f32>(_S950.bundle_weight_0 * _S950.bundle_0.y + _S950.fibre_weight_0 * _S950.fibre_0.y, _S950.bundle_weight_0 + _S950.fibre_weight_0) + (groove_0(_S951 * (_S950.bundle_weight_0 * (0.5f * (_S950.bundle_0.x - 1.0f) + 1.0f)), _S950.bundle_offset_0) + groove_0(_S951 * _S950.fibre_weight_0, _S950.offset_2));
    }
    if((families_0[_S944].slub_0) > 0.0f)
    {
        gain_2 = gain_2 + vec2<f32>((0.15000000596046448f * families_0[_S944].slub_0 * fade_0(_S948, 1.0f / families_0[_S944].slubs_per_mm_0))) * vec2<f32>(wave_noise_0(hash_key_0(_S947, ((fabrics_0[_S943].seed_0) ^ (u32(1373058189)))), select(- _S945.x_8, _S945.y_2, _S945.is_warp_0) * families_0[_S944].slubs_per_mm_0).x, 1.0f);
    }
    return vec2<f32>(max(gain_2.x, -0.94999998807907104f), gain_2.y);
}

fn vary_albedos_0( _S952 : u32,  _S953 : Albedos_0,  _S954 : u32,  _S955 : u32,  _S956 : vec2<f32>) -> Albedos_0
{
    var _S957 : vec3<f32> = max(_S953.specular_reflect_0, _S953.specular_transmit_0);
    var _S958 : vec3<f32> = _S953.diffuse_reflect_0 + _S953.diffuse_transmit_0;
    var _S959 : vec3<f32> = vec3<f32>(fabrics_0[_S952].layer_bound_0);
    var _S960 : vec3<f32> = vec3<f32>(1.0f);
    var _S961 : vec3<f32> = _S960 - _S959 * _S957;
    var colour_1 : f32 = bounded_gain_0(thread_gain_0(_S954, fabrics_0[_S952].colour_noise_0, fabrics_0[_S952].seed_0), _S958, _S961);
    var _S962 : vec3<f32> = vec3<f32>((colour_1 * (1.0f + flattened_0(_S956.y, vec3<f32>(colour_1) * _S958, _S961) * _S956.x)));
    var _S963 : f32 = bounded_gain_0(fibre_gain_0(_S954, _S955, fabrics_0[_S952].fibre_noise_0, fabrics_0[_S952].seed_0), _S957, min((_S960 - _S962 * _S958) / _S959, vec3<f32>(1.0f)));
    var varied_0 : Albedos_0;
    varied_0.diffuse_reflect_0 = _S962 * _S953.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S962 * _S953.diffuse_transmit_0;
    var _S964 : vec3<f32> = vec3<f32>(_S963);
    varied_0.specular_reflect_0 = _S964 * _S953.specular_reflect_0;
    varied_0.specular_transmit_0 = _S964 * _S953.specular_transmit_0;
    return varied_0;
}

fn varied_at_0( _S965 : u32,  _S966 : SurfacePoint_0,  _S967 : Albedos_0,  _S968 : bool,  _S969 : f32,  _S970 : f32) -> Albedos_0
{
    var _S971 : u32 = thread_number_0(_S965, _S966);
    var _S972 : vec3<f32> = fibre_cell_0(_S966.fibre_across_0, _S966.fibre_along_0, fabrics_0[_S965].fibre_size_0);
    var _S973 : vec2<f32> = vec2<f32>(0.0f);
    var gain_3 : vec2<f32>;
    if((((fabrics_0[_S965].has_detail_0) != u32(0)) & ((_S969 >= 0.0f))))
    {
        gain_3 = detail_gain_0(_S965, select(fabrics_0[_S965].weft_0, fabrics_0[_S965].warp_0, _S966.is_warp_0), _S966, _S968, _S971, _S969) * vec2<f32>(1.0f - _S970, 1.0f);
    }
    else
    {
        gain_3 = _S973;
    }
    return vary_albedos_0(_S965, _S967, _S971, u32(i32(_S972.x)) * u32(65536) + u32(i32(floor(_S972.y))), gain_3);
}

fn lobes_estimate_of_pass_0( _S974 : u32,  _S975 : Footprint_0,  _S976 : f32,  _S977 : vec2<f32>,  _S978 : vec3<f32>,  _S979 : vec3<f32>) -> Estimate_0
{
    var _S980 : f32;
    var _S981 : Regime_0 = regime_of_0(_S974, _S975, _S976);
    var _S982 : bool = (_S979.z) < 0.0f;
    var _S983 : vec3<f32> = to_face_frame_0(_S979, _S982);
    var _S984 : f32 = Footprint_spread_side_0(_S975);
    var _S985 : bool = varies_at_0(_S974, _S984);
    var _S986 : f32 = 1.0f - _S981.prefiltered_0;
    var _S987 : bool = ((_S986 > 0.0f) & (((((_S985 | (((((families_0[fabrics_0[_S974].warp_0].quantities_0) > u32(1)) | (((families_0[fabrics_0[_S974].weft_0].quantities_0) > u32(1)))))))) | (((fabrics_0[_S974].is_irregular_0) != u32(0)))))));
    var box_0 : Footprint_0 = _S975;
    var _S988 : vec3<f32> = vec3<f32>(0.0f);
    var _S989 : SurfacePoint_0 = SurfacePoint_x24init_0(false, false, u32(0), u32(0), 0.0f, _S988, _S988, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f);
    var _S990 : Components_0 = no_components_0();
    var close_1 : CloseUp_0 = no_close_up_0();
    var _S991 : u32 = select(u32(1), u32(0), _S987);
    var points_1 : Components_0 = _S990;
    var central_weight_0 : f32 = 0.0f;
    var central_0 : SurfacePoint_0 = _S989;
    var number_11 : u32 = _S991;
    for(;;)
    {
        var _S992 : f32 = f32(number_11);
        _S980 = _S981.points_0;
        if(_S992 < (_S981.points_0 + 1.0f))
        {
        }
        else
        {
            break;
        }
        var _S993 : bool = number_11 == u32(0);
        var _S994 : u32 = number_11 - u32(1);
        var _S995 : vec2<f32> = POINT_OFFSETS_0[select(_S994, u32(0), _S993)] + _S977;
        var _S996 : vec2<f32> = select_vector_0(_S993, vec2<f32>(0.0f), _S995 - round(_S995));
        var _S997 : vec2<f32> = _S975.centre_0 + vec2<f32>(_S996.x) * _S975.dx_0 + vec2<f32>(_S996.y) * _S975.dy_0;
        var _S998 : SearchQuality_0 = quality_of_0(select(_S981.threads_2, 0.0f, _S993));
        var _S999 : Hit_0 = first_hit_0(_S974, _S998, _S997.x, _S997.y, _S983, _S982);
        var _S1000 : SurfacePoint_0 = surface_met_0(_S974, _S999.x_18, _S999.y_11, _S999.height_8, _S983, _S982);
        if(_S993)
        {
            var central_weight_1 : f32 = select(_S986, 0.0f, _S999.hole_7);
            box_0.centre_0 = mix(_S975.centre_0, vec2<f32>(_S999.x_18, _S999.y_11), vec2<f32>(central_weight_1));
            central_weight_0 = central_weight_1;
            central_0 = _S1000;
            number_11 = number_11 + u32(1);
            continue;
        }
        var _S1001 : YarnPoint_0 = uncoloured_point_0(_S974, _S1000, _S983, _S982, _S999.hole_7, _S984);
        var _S1002 : f32 = min(_S981.points_0 - f32(_S994), 1.0f);
        var _S1003 : Components_0 = with_added_0(points_1, components_of_point_0(_S974, _S998, _S1001, _S978, _S979), _S1002);
        if((fabrics_0[_S974].openness_0) != u32(4294967295))
        {
            close_1.warp_1 = with_blocked_0(_S974, close_1.warp_1, _S1001, true, _S1002);
            close_1.weft_1 = with_blocked_0(_S974, close_1.weft_1, _S1001, false, _S1002);
        }
        points_1 = _S1003;
        number_11 = number_11 + u32(1);
    }
    close_1.weight_0 = _S986;
    var _S1004 : f32 = max(_S980, 1.0f);
    close_1.warp_1 = scaled_0(close_1.warp_1, 1.0f / _S1004);
    close_1.weft_1 = scaled_0(close_1.weft_1, 1.0f / _S1004);
    var estimate_0 : Estimate_0;
    estimate_0.close_0 = close_1;
    estimate_0.components_0 = with_added_0(_S990, points_1, _S986 / _S1004);
    if((_S981.prefiltered_0) > 0.0f)
    {
        var _S1005 : Components_0 = prefiltered_components_0(_S974, _S975, to_face_frame_0(_S978, _S982), _S983, _S982);
        estimate_0.components_0 = with_added_0(estimate_0.components_0, _S1005, _S981.prefiltered_0);
    }
    var _S1006 : Yarns_0 = yarns_over_0(_S974, box_0, _S982);
    estimate_0.components_0 = with_shares_0(_S974, estimate_0.components_0, _S1006);
    estimate_0.albedos_7 = with_tones_0(_S974, albedos_over_0(_S974, box_0, _S982), _S1006);
    if((_S985 & ((central_weight_0 > 0.0f))))
    {
        var _S1007 : SurfacePoint_0 = central_0;
        var _S1008 : Albedos_0;
        if(central_0.is_warp_0)
        {
            _S1008 = estimate_0.albedos_7.warp_7;
        }
        else
        {
            _S1008 = estimate_0.albedos_7.weft_7;
        }
        var _S1009 : bool;
        if((fabrics_0[_S974].has_detail_0) != u32(0))
        {
            _S1009 = has_hairs_0(_S974);
        }
        else
        {
            _S1009 = false;
        }
        var cover_4 : f32;
        if(_S1009)
        {
            cover_4 = hair_towards_0(_S974, hairs_over_0(_S974, central_0, _S982, _S984), _S983, _S984).cover_1;
        }
        else
        {
            cover_4 = 0.0f;
        }
        var _S1010 : Albedos_0 = lerp_albedos_0(_S1008, varied_at_0(_S974, central_0, _S1008, _S982, _S984, cover_4), central_weight_0);
        if(_S1007.is_warp_0)
        {
            estimate_0.albedos_7.warp_7 = _S1010;
        }
        else
        {
            estimate_0.albedos_7.weft_7 = _S1010;
        }
    }
    return estimate_0;
}

fn diffuse_kept_0( _S1011 : u32,  _S1012 : vec3<f32>,  _S1013 : vec3<f32>) -> f32
{
    return (1.0f - fabrics_0[_S1011].grazing_loss_0 * fourth_power_0(max(1.0f - abs(_S1012.z), 0.0f))) * (1.0f - fabrics_0[_S1011].grazing_loss_0 * fourth_power_0(max(1.0f - abs(_S1013.z), 0.0f)));
}

fn highlight_rise_0( _S1014 : u32,  _S1015 : vec3<f32>,  _S1016 : vec3<f32>) -> f32
{
    var _S1017 : f32 = 1.0f - sqrt(clamp(0.5f * dot(_S1015, _S1016) + 0.5f, 9.99999993922529029e-09f, 1.0f));
    return fabrics_0[_S1014].grazing_gain_0 * fourth_power_0(_S1017) * _S1017;
}

fn towards_grazing_0( _S1018 : u32,  _S1019 : Albedos_0,  _S1020 : vec3<f32>,  _S1021 : vec3<f32>) -> Albedos_0
{
    var _S1022 : f32 = diffuse_kept_0(_S1018, _S1020, _S1021);
    var result_7 : Albedos_0 = _S1019;
    var _S1023 : vec3<f32> = vec3<f32>(_S1022);
    result_7.diffuse_reflect_0 = result_7.diffuse_reflect_0 * _S1023;
    result_7.diffuse_transmit_0 = result_7.diffuse_transmit_0 * _S1023;
    result_7.specular_reflect_0 = result_7.specular_reflect_0 + vec3<f32>(highlight_rise_0(_S1018, _S1020, _S1021));
    return result_7;
}

fn scattered_by_0( _S1024 : u32,  _S1025 : Albedos_0,  _S1026 : u32,  _S1027 : vec3<f32>) -> Scattered_0
{
    var _S1028 : u32 = u32(159) + u32(2) * _S1026;
    var yarn_4 : Scattered_0;
    yarn_4.back_10 = _S1027 * _S1025.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S1024, _S1028)) * _S1025.specular_reflect_0;
    yarn_4.through_0 = _S1027 * _S1025.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S1024, _S1028 + u32(1))) * _S1025.specular_transmit_0;
    return yarn_4;
}

fn sent_0( _S1029 : u32,  _S1030 : u32,  _S1031 : vec3<f32>,  _S1032 : vec3<f32>,  _S1033 : vec3<f32>,  _S1034 : vec3<f32>,  _S1035 : ptr<function, vec3<f32>>,  _S1036 : ptr<function, vec3<f32>>)
{
    var _S1037 : u32 = u32(146) + u32(4) * _S1030;
    var _S1038 : f32 = openness_number_0(_S1029, _S1037 + u32(1));
    var _S1039 : f32 = openness_number_0(_S1029, _S1037 + u32(2));
    var _S1040 : vec3<f32> = vec3<f32>(1.0f);
    var _S1041 : vec3<f32> = _S1040 - _S1033 * vec3<f32>(openness_number_0(_S1029, _S1037));
    var _S1042 : vec3<f32> = _S1040 - _S1034 * vec3<f32>(openness_number_0(_S1029, _S1037 + u32(3)));
    var _S1043 : vec3<f32> = _S1040 / (_S1041 * _S1042 - _S1033 * _S1034 * vec3<f32>((_S1038 * _S1039)));
    (*_S1035) = (_S1031 * _S1042 + _S1033 * vec3<f32>(_S1038) * _S1032) * _S1043;
    (*_S1036) = (_S1032 * _S1041 + _S1034 * vec3<f32>(_S1039) * _S1031) * _S1043;
    return;
}

fn face_sends_0( _S1044 : u32,  _S1045 : u32,  _S1046 : Scattered_0,  _S1047 : Scattered_0) -> FaceSends_0
{
    var _S1048 : u32 = u32(2) * _S1045;
    var _S1049 : u32 = u32(142) + _S1048;
    var _S1050 : f32 = openness_number_0(_S1044, _S1049);
    var _S1051 : f32 = openness_number_0(_S1044, _S1049 + u32(1));
    var _S1052 : vec3<f32> = vec3<f32>((1.0f - _S1050)) * _S1046.back_10;
    var _S1053 : vec3<f32> = vec3<f32>((1.0f - _S1051)) * _S1047.back_10;
    var sends_1 : FaceSends_0;
    var _S1054 : u32 = u32(154) + _S1048;
    var _S1055 : f32 = openness_number_0(_S1044, _S1054);
    sends_1.blocks_warp_0 = _S1055;
    var _S1056 : f32 = openness_number_0(_S1044, _S1054 + u32(1));
    sends_1.blocks_weft_0 = _S1056;
    sends_1.open_0 = _S1055 * _S1050 + _S1056 * _S1051;
    var _S1057 : vec3<f32> = vec3<f32>(_S1050) * _S1046.back_10;
    var _S1058 : vec3<f32> = vec3<f32>(_S1051) * _S1047.back_10;
    var _S1059 : vec3<f32> = sends_1.sky_warp_0;
    var _S1060 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S1044, _S1045, _S1057, _S1058, _S1052, _S1053, &(_S1059), &(_S1060));
    sends_1.sky_warp_0 = _S1059;
    sends_1.sky_weft_0 = _S1060;
    var _S1061 : vec3<f32> = sends_1.crossing_warp_0;
    var _S1062 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S1044, _S1045, _S1046.through_0, _S1047.through_0, _S1052, _S1053, &(_S1061), &(_S1062));
    sends_1.crossing_warp_0 = _S1061;
    sends_1.crossing_weft_0 = _S1062;
    return sends_1;
}

fn interior_of_0( _S1063 : u32,  _S1064 : vec3<f32>,  _S1065 : bool) -> Interior_0
{
    var _S1066 : Scattered_0 = scattered_by_0(_S1063, table_albedos_0(families_0[fabrics_0[_S1063].warp_0].colour_mean_0), u32(0), _S1064);
    var _S1067 : Scattered_0 = scattered_by_0(_S1063, table_albedos_0(families_0[fabrics_0[_S1063].weft_0].colour_mean_0), u32(1), _S1064);
    var _S1068 : FaceSends_0 = face_sends_0(_S1063, select(u32(0), u32(1), _S1065), _S1066, _S1067);
    var _S1069 : FaceSends_0 = face_sends_0(_S1063, select(u32(1), u32(0), _S1065), _S1066, _S1067);
    var _S1070 : vec3<f32> = vec3<f32>(_S1068.blocks_warp_0);
    var _S1071 : vec3<f32> = vec3<f32>(_S1068.blocks_weft_0);
    var _S1072 : vec3<f32> = _S1070 * _S1068.crossing_warp_0 + _S1071 * _S1068.crossing_weft_0;
    var _S1073 : vec3<f32> = vec3<f32>(_S1069.blocks_warp_0);
    var _S1074 : vec3<f32> = vec3<f32>(_S1069.blocks_weft_0);
    var _S1075 : vec3<f32> = _S1073 * _S1069.crossing_warp_0 + _S1074 * _S1069.crossing_weft_0;
    var _S1076 : f32 = 1.0f - _S1068.open_0;
    var _S1077 : f32 = 1.0f - _S1069.open_0;
    var _S1078 : vec3<f32> = vec3<f32>(1.0f);
    var _S1079 : vec3<f32> = _S1078 / (_S1078 - _S1072 * _S1075 * vec3<f32>((_S1076 * _S1077)));
    var _S1080 : vec3<f32> = _S1075 * (vec3<f32>(_S1068.open_0) + vec3<f32>(_S1076) * (_S1070 * _S1068.sky_warp_0 + _S1071 * _S1068.sky_weft_0)) * _S1079;
    var _S1081 : vec3<f32> = _S1072 * (vec3<f32>(_S1069.open_0) + vec3<f32>(_S1077) * (_S1073 * _S1069.sky_warp_0 + _S1074 * _S1069.sky_weft_0)) * _S1079;
    var _S1082 : FaceRadiance_0 = face_radiance_0(_S1068, _S1069.open_0, _S1080, _S1081);
    var _S1083 : FaceRadiance_0 = face_radiance_0(_S1069, _S1068.open_0, _S1081, _S1080);
    var interior_1 : Interior_0;
    interior_1.warp_6 = _S1082.warp_5;
    interior_1.weft_6 = _S1082.weft_5;
    interior_1.leaked_1 = _S1082.leaked_0;
    interior_1.far_1 = _S1083.mean_1;
    interior_1.far_leaked_0 = _S1083.leaked_0;
    return interior_1;
}

fn blocked_from_0( _S1084 : u32,  _S1085 : vec3<f32>,  _S1086 : bool,  _S1087 : bool) -> Blocked_0
{
    var terms_3 : array<f32, i32(6)>;
    view_terms_0(_S1085, &(terms_3));
    return blocked_of_terms_0(_S1084, (select(u32(0), u32(2), _S1087) + select(u32(1), u32(0), _S1086)) * u32(15), terms_3, u32(5));
}

fn warp_seen_from_0( _S1088 : u32,  _S1089 : vec3<f32>,  _S1090 : bool) -> f32
{
    var terms_4 : array<f32, i32(6)>;
    view_terms_1(_S1089, &(terms_4));
    var term_1 : u32 = u32(0);
    var share_5 : f32 = 0.0f;
    for(;;)
    {
        if(term_1 < u32(5))
        {
        }
        else
        {
            break;
        }
        var share_6 : f32 = share_5 + openness_number_0(_S1088, u32(132) + select(u32(0), u32(5), _S1090) + term_1) * terms_4[term_1];
        term_1 = term_1 + u32(1);
        share_5 = share_6;
    }
    return saturate(share_5);
}

fn bounced_of_families_0( _S1091 : u32,  _S1092 : FamilyAlbedos_0,  _S1093 : vec3<f32>,  _S1094 : Interior_0,  _S1095 : Blocked_0,  _S1096 : Blocked_0) -> Bounced_0
{
    return sum_of_0(bounced_by_0(_S1095, scattered_by_0(_S1091, _S1092.warp_7, u32(0), _S1093), _S1094), bounced_by_0(_S1096, scattered_by_0(_S1091, _S1092.weft_7, u32(1), _S1093), _S1094));
}

fn bounced_far_0( _S1097 : u32,  _S1098 : FamilyAlbedos_0,  _S1099 : vec3<f32>,  _S1100 : Interior_0,  _S1101 : vec3<f32>,  _S1102 : bool,  _S1103 : f32,  _S1104 : f32,  _S1105 : f32) -> Bounced_0
{
    var _S1106 : Blocked_0 = blocked_from_0(_S1097, _S1101, true, _S1102);
    var _S1107 : Blocked_0 = blocked_from_0(_S1097, _S1101, false, _S1102);
    var _S1108 : f32 = _S1103 / max(1.0f - _S1106.by_warp_0 - _S1106.by_weft_0, 0.10000000149011612f);
    var _S1109 : f32 = (0.0020000000949949f * warp_seen_from_0(_S1097, _S1101, _S1102) + _S1108) / (_S1108 + _S1104 / max(1.0f - _S1107.by_warp_0 - _S1107.by_weft_0, 0.10000000149011612f) + 0.0020000000949949f);
    var _S1110 : f32 = 1.0f - _S1105;
    return bounced_of_families_0(_S1097, _S1098, _S1099, _S1100, scaled_0(_S1106, _S1109 * _S1110), scaled_0(_S1107, (1.0f - _S1109) * _S1110));
}

fn bounced_over_0( _S1111 : u32,  _S1112 : Components_0,  _S1113 : CloseUp_0,  _S1114 : FamilyAlbedos_0,  _S1115 : vec3<f32>,  _S1116 : vec3<f32>) -> Bounced_0
{
    var _S1117 : bool = (_S1116.z) < 0.0f;
    var _S1118 : Interior_0 = interior_of_0(_S1111, _S1115, _S1117);
    var bounced_2 : Bounced_0 = bounced_far_0(_S1111, _S1114, _S1115, _S1118, to_face_frame_0(_S1116, _S1117), _S1117, _S1112.diffuse_warp_0, _S1112.diffuse_weft_0, _S1112.hole_2);
    if((_S1113.weight_0) > 0.0f)
    {
        var _S1119 : Bounced_0 = bounced_of_families_0(_S1111, _S1114, _S1115, _S1118, _S1113.warp_1, _S1113.weft_1);
        var _S1120 : vec3<f32> = vec3<f32>(_S1113.weight_0);
        bounced_2.reflected_0 = mix(bounced_2.reflected_0, _S1119.reflected_0, _S1120);
        bounced_2.transmitted_0 = mix(bounced_2.transmitted_0, _S1119.transmitted_0, _S1120);
    }
    return bounced_2;
}

fn composed_0( _S1121 : u32,  _S1122 : Components_0,  _S1123 : CloseUp_0,  _S1124 : FamilyAlbedos_0,  _S1125 : vec3<f32>,  _S1126 : vec3<f32>,  _S1127 : vec3<f32>) -> vec3<f32>
{
    var _S1128 : Albedos_0 = towards_grazing_0(_S1121, tinted_0(_S1124.warp_7, _S1125), _S1126, _S1127);
    var _S1129 : Albedos_0 = towards_grazing_0(_S1121, tinted_0(_S1124.weft_7, _S1125), _S1126, _S1127);
    var _S1130 : vec3<f32> = vec3<f32>(_S1122.diffuse_warp_0);
    var _S1131 : vec3<f32> = vec3<f32>(_S1122.diffuse_weft_0);
    var _S1132 : vec3<f32> = vec3<f32>(_S1122.specular_warp_0);
    var _S1133 : vec3<f32> = vec3<f32>(_S1122.specular_weft_0);
    var _S1134 : vec3<f32> = _S1128.diffuse_reflect_0 * _S1130 + _S1129.diffuse_reflect_0 * _S1131 + _S1128.specular_reflect_0 * _S1132 + _S1129.specular_reflect_0 * _S1133;
    var _S1135 : f32 = _S1127.z;
    var body_0 : vec3<f32>;
    if((_S1126.z * _S1135) < 0.0f)
    {
        body_0 = _S1128.diffuse_transmit_0 * _S1130 + _S1129.diffuse_transmit_0 * _S1131 + _S1128.specular_transmit_0 * _S1132 + _S1129.specular_transmit_0 * _S1133;
    }
    else
    {
        body_0 = _S1134;
    }
    if((fabrics_0[_S1121].openness_0) != u32(4294967295))
    {
        body_0 = body_0 + bounced_value_0(bounced_over_0(_S1121, _S1122, _S1123, _S1124, _S1125, _S1127), _S1126, _S1127) * vec3<f32>(diffuse_kept_0(_S1121, _S1126, _S1127));
    }
    var _S1136 : f32 = fabrics_0[_S1121].sheen_strength_0;
    if((fabrics_0[_S1121].sheen_strength_0) <= 0.0f)
    {
        return body_0;
    }
    var _S1137 : bool = _S1135 < 0.0f;
    var _S1138 : vec2<f32> = sheen_with_transmittance_0(to_face_frame_0(_S1126, _S1137), to_face_frame_0(_S1127, _S1137), _S1136, fabrics_0[_S1121].sheen_roughness_0);
    return vec3<f32>(_S1138.y) * body_0 + vec3<f32>(((_S1122.light_visibility_1 + _S1122.hole_2) * _S1138.x));
}

fn light_of_footprint_0( _S1139 : u32,  _S1140 : VisiblePoint_0,  _S1141 : vec2<u32>,  _S1142 : vec3<f32>) -> vec4<f32>
{
    var footprint_0 : Footprint_0;
    footprint_0.dx_0 = _S1140.draft_dx_0;
    footprint_0.dy_0 = _S1140.draft_dy_0;
    footprint_0.centre_0 = irregular_place_0(_S1139, _S1140.draft_0, Footprint_spread_side_0(footprint_0));
    var _S1143 : vec2<f32> = fract(vec2<f32>(f32(((frame_record_0.pass_number_0) & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
    var _S1144 : vec3<f32> = to_local_0(_S1140, _S1140.view_0);
    var _S1145 : u32 = light_sample_count_0();
    var _S1146 : vec3<f32> = vec3<f32>(0.0f);
    var number_12 : u32 = u32(0);
    var radiance_1 : vec3<f32> = _S1146;
    var hole_8 : f32 = 0.0f;
    for(;;)
    {
        if(number_12 < (max(_S1145, u32(1))))
        {
        }
        else
        {
            break;
        }
        var _S1147 : f32;
        if(number_12 < _S1145)
        {
            _S1147 = visibility_at_0(number_12, _S1141);
        }
        else
        {
            _S1147 = 0.0f;
        }
        var _S1148 : bool;
        if(_S1147 <= 0.0f)
        {
            _S1148 = number_12 > u32(0);
        }
        else
        {
            _S1148 = false;
        }
        if(_S1148)
        {
            number_12 = number_12 + u32(1);
            continue;
        }
        var _S1149 : LightSample_0 = light_sample_0(number_12, _S1141, _S1140.position_4);
        var _S1150 : vec3<f32> = to_local_0(_S1140, _S1149.towards_0);
        var _S1151 : Estimate_0 = lobes_estimate_of_pass_0(_S1139, footprint_0, 1.0f, _S1143, _S1150, _S1144);
        radiance_1 = radiance_1 + vec3<f32>(_S1147) * _S1149.irradiance_1 * composed_0(_S1139, _S1151.components_0, _S1151.close_0, _S1151.albedos_7, _S1142, _S1150, _S1144);
        hole_8 = _S1151.components_0.hole_2;
        number_12 = number_12 + u32(1);
    }
    var _S1152 : f32 = fabrics_0[_S1139].sheen_strength_0;
    if((fabrics_0[_S1139].sheen_strength_0) > 0.0f)
    {
        hole_8 = hole_8 * (1.0f - _S1152 * sheen_lobe_0(abs(_S1144.z), fabrics_0[_S1139].sheen_roughness_0).z);
    }
    return vec4<f32>(radiance_1, 1.0f - hole_8);
}

@compute
@workgroup_size(8, 8, 1)
fn shade_lobes(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S1153 : u32 = id_0.x;
    var _S1154 : bool;
    if(_S1153 >= (frame_record_0.width_0))
    {
        _S1154 = true;
    }
    else
    {
        _S1154 = (id_0.y) >= (frame_record_0.height_0);
    }
    if(_S1154)
    {
        return;
    }
    var _S1155 : u32 = id_0.y * frame_record_0.width_0 + _S1153;
    var _S1156 : u32 = layers_0[_S1155].face_0;
    if((layers_0[_S1155].face_0) == u32(0))
    {
        return;
    }
    var _S1157 : u32 = _S1156 - u32(1);
    var _S1158 : u32 = fabric_of_0(_S1157);
    var _S1159 : vec2<u32> = id_0.xy;
    var _S1160 : VisiblePoint_0 = visible_point_0(_S1158, _S1157, _S1159);
    var _S1161 : vec4<f32> = light_of_footprint_0(_S1158, _S1160, _S1159, filtered_albedo_0(_S1158, _S1160));
    accumulate_0(_S1155, _S1161);
    return;
}

