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
     plane_0 : f32,
     layer_0 : u32,
};

fn SurfacePoint_x24init_0( hole_1 : bool,  is_warp_1 : bool,  warp_thread_1 : u32,  weft_thread_1 : u32,  height_3 : f32,  normal_2 : vec3<f32>,  tangent_1 : vec3<f32>,  across_2 : f32,  fibre_across_1 : f32,  fibre_along_1 : f32,  x_9 : f32,  y_3 : f32,  shown_share_1 : f32,  plane_1 : f32,  layer_1 : u32) -> SurfacePoint_0
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
    _S68.plane_0 = plane_1;
    _S68.layer_0 = layer_1;
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

struct Plane_0
{
     warp_2 : u32,
     weft_2 : u32,
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

fn plane_at_0( first_3 : u32) -> Plane_0
{
    var record_2 : Plane_0;
    record_2.warp_2 = words_0[first_3];
    record_2.weft_2 = words_0[first_3 + u32(1)];
    record_2.run_words_1 = words_0[first_3 + u32(2)];
    record_2.ends_2 = words_0[first_3 + u32(3)];
    record_2.end_numbers_0 = words_0[first_3 + u32(4)];
    record_2.pick_numbers_0 = words_0[first_3 + u32(5)];
    record_2.max_heights_1 = words_0[first_3 + u32(6)];
    record_2.max_height_columns_1 = words_0[first_3 + u32(7)];
    record_2.height_low_1 = (bitcast<f32>((words_0[first_3 + u32(8)])));
    record_2.height_high_1 = (bitcast<f32>((words_0[first_3 + u32(9)])));
    record_2.front_level_0 = (bitcast<f32>((words_0[first_3 + u32(10)])));
    record_2.back_level_0 = (bitcast<f32>((words_0[first_3 + u32(11)])));
    record_2.start_x_0 = (bitcast<f32>((words_0[first_3 + u32(12)])));
    record_2.start_y_0 = (bitcast<f32>((words_0[first_3 + u32(13)])));
    record_2.fine_x_0 = (bitcast<f32>((words_0[first_3 + u32(14)])));
    record_2.fine_y_0 = (bitcast<f32>((words_0[first_3 + u32(15)])));
    return record_2;
}

struct Crossing_0
{
     warp_3 : Cell_0,
     weft_3 : Cell_0,
     warp_word_0 : u32,
     weft_word_0 : u32,
     warp_above_0 : bool,
};

fn crossing_at_0( plane_2 : Plane_0,  x_10 : f32,  y_4 : f32,  back_3 : bool) -> Crossing_0
{
    var crossing_0 : Crossing_0;
    crossing_0.warp_3 = locate_0(plane_2.warp_2, x_10 - plane_2.start_x_0);
    crossing_0.weft_3 = locate_0(plane_2.weft_2, y_4 - plane_2.start_y_0);
    var _S72 : u32 = plane_2.run_words_1 + u32(2) * (crossing_0.weft_3.thread_1 * plane_2.ends_2 + crossing_0.warp_3.thread_1);
    var _S73 : u32 = words_0[_S72];
    crossing_0.warp_word_0 = _S73;
    crossing_0.weft_word_0 = words_0[_S72 + u32(1)];
    crossing_0.warp_above_0 = (((_S73 & (u32(1)))) == u32(1)) != back_3;
    return crossing_0;
}

fn cell_maximum_0( plane_3 : Plane_0,  crossing_1 : Crossing_0) -> f32
{
    var _S74 : u32 = select(plane_3.weft_2, plane_3.warp_2, crossing_1.warp_above_0);
    return f32((select(crossing_1.weft_word_0, crossing_1.warp_word_0, crossing_1.warp_above_0) >> (u32(28)))) * families_0[_S74].height_scale_0 * families_0[_S74].level_0;
}

fn bounds_in_0( plane_4 : Plane_0,  x_11 : f32,  y_5 : f32,  back_4 : bool,  right_0 : bool,  up_0 : bool) -> vec3<f32>
{
    var _S75 : Crossing_0 = crossing_at_0(plane_4, x_11, y_5, back_4);
    return vec3<f32>(cell_maximum_0(plane_4, _S75), select(_S75.warp_3.below_0, _S75.warp_3.above_0, right_0), select(_S75.weft_3.below_0, _S75.weft_3.above_0, up_0));
}

fn hole_edge_0( cell_6 : Cell_0,  forwards_0 : bool) -> f32
{
    var _S76 : f32 = select(- cell_6.across_0, cell_6.across_0, forwards_0);
    var _S77 : f32 = - cell_6.half_width_1;
    return select(select(cell_6.half_width_1, _S77, _S76 < _S77) - _S76, 2.0f * select(cell_6.below_0, cell_6.above_0, forwards_0) + _S76 - cell_6.half_width_1, _S76 >= (cell_6.half_width_1));
}

struct Shown_0
{
     is_warp_2 : bool,
     hole_3 : bool,
     on_top_0 : bool,
     word_0 : u32,
};

fn shown_at_0( crossing_2 : Crossing_0,  back_5 : bool) -> Shown_0
{
    var _S78 : bool = (abs(crossing_2.warp_3.across_0)) < (crossing_2.warp_3.half_width_1);
    var shown_0 : Shown_0;
    var _S79 : bool = !((abs(crossing_2.weft_3.across_0)) < (crossing_2.weft_3.half_width_1));
    var _S80 : bool = (_S78 & (((_S79 | ((crossing_2.warp_above_0))))));
    shown_0.is_warp_2 = _S80;
    shown_0.hole_3 = ((!_S78) & (_S79));
    var _S81 : u32 = select(crossing_2.weft_word_0, crossing_2.warp_word_0, _S80);
    shown_0.word_0 = _S81;
    shown_0.on_top_0 = (((_S81 & (u32(1)))) == u32(1)) != back_5;
    return shown_0;
}

fn select_cell_0( is_first_0 : bool,  first_4 : Cell_0,  second_0 : Cell_0) -> Cell_0
{
    var cell_7 : Cell_0;
    cell_7.thread_1 = select(second_0.thread_1, first_4.thread_1, is_first_0);
    cell_7.across_0 = select(second_0.across_0, first_4.across_0, is_first_0);
    cell_7.half_width_1 = select(second_0.half_width_1, first_4.half_width_1, is_first_0);
    cell_7.below_0 = select(second_0.below_0, first_4.below_0, is_first_0);
    cell_7.above_0 = select(second_0.above_0, first_4.above_0, is_first_0);
    return cell_7;
}

fn boundary_0( family_9 : u32,  thread_4 : u32,  step_0 : i32) -> f32
{
    var _S82 : vec2<f32> = turns_and_remainder_0(family_9, f32(i32(thread_4) + step_0));
    return fma(_S82.x, families_0[family_9].period_0, table_number_0(families_0[family_9].place_table_0 + u32(_S82.y) * u32(4)));
}

fn span_0( family_10 : u32,  thread_5 : u32,  first_5 : i32,  last_0 : i32) -> f32
{
    if((families_0[family_10].is_alike_0) != u32(0))
    {
        return f32(last_0 - first_5) * families_0[family_10].size_0;
    }
    return boundary_0(family_10, thread_5, last_0) - boundary_0(family_10, thread_5, first_5);
}

struct Bend_0
{
     sine_0 : f32,
     half_tangent_0 : f32,
     arc_0 : f32,
};

fn bend_of_0( family_11 : u32,  thread_6 : u32) -> Bend_0
{
    var _S83 : u32 = families_0[family_11].bend_table_0 + select(thread_6 * u32(4), u32(0), (families_0[family_11].is_alike_0) != u32(0));
    var bend_0 : Bend_0;
    bend_0.sine_0 = table_number_0(_S83);
    bend_0.half_tangent_0 = table_number_0(_S83 + u32(1));
    bend_0.arc_0 = table_number_0(_S83 + u32(2));
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
    var _S84 : i32 = i32((((word_1 >> (u32(1)))) & (u32(127))));
    var _S85 : i32 = i32((((word_1 >> (u32(8)))) & (u32(127))));
    var _S86 : i32 = i32((((word_1 >> (u32(15)))) & (u32(63))));
    var _S87 : i32 = i32((((word_1 >> (u32(21)))) & (u32(63))));
    var run_0 : Run_0;
    var _S88 : bool = ((((word_1 >> (u32(27)))) & (u32(1)))) == u32(1);
    run_0.straight_0 = _S88;
    var _S89 : i32 = - _S84;
    var _S90 : f32 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_1, _S89, i32(0));
    run_0.from_start_0 = _S90;
    var _S91 : i32 = _S85 + i32(1);
    var _S92 : f32 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_1, i32(1), _S91);
    run_0.to_end_0 = _S92;
    var _S93 : bool = _S90 < _S92;
    run_0.near_start_0 = _S93;
    var _S94 : i32 = select(_S91, _S89 - _S86, _S93);
    var _S95 : i32 = select(_S91 + _S87, _S89, _S93);
    run_0.bend_1 = bend_of_0(own_0, thread_7);
    run_0.distance_0 = select(min(_S90, _S92), 1.0e+06f, _S88);
    run_0.reach_0 = min(0.5f * (_S90 + _S92), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_1, _S94, _S95), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S84 == i32(0);
    run_0.last_crossing_0 = _S85 == i32(0);
    return run_0;
}

struct Section_0
{
     across_3 : f32,
     drop_0 : f32,
     slope_0 : f32,
};

fn section_at_0( cell_8 : Cell_0) -> Section_0
{
    var _S96 : f32 = cell_8.half_width_1 * 1.0154266357421875f;
    var section_0 : Section_0;
    var _S97 : f32 = clamp(cell_8.across_0, - cell_8.half_width_1, cell_8.half_width_1);
    section_0.across_3 = _S97;
    var _S98 : f32 = _S96 * _S96 - square_1(_S97);
    var _S99 : f32 = rsqrt_0(_S98);
    section_0.drop_0 = _S96 - _S98 * _S99;
    section_0.slope_0 = - _S97 * _S99;
    return section_0;
}

fn edge_drop_0( family_12 : u32,  thread_8 : u32,  step_1 : i32) -> f32
{
    return table_number_0(families_0[family_12].bend_table_0 + select(u32(turns_and_remainder_0(family_12, f32(i32(thread_8) + step_1)).y) * u32(4), u32(0), (families_0[family_12].is_alike_0) != u32(0)) + u32(3));
}

fn dive_0( other_1 : u32,  shown_1 : Shown_0,  run_1 : Run_0,  crossed_1 : Cell_0) -> vec3<f32>
{
    var _S100 : bool = (crossed_1.below_0) < (crossed_1.above_0);
    var _S101 : f32 = min(crossed_1.below_0, crossed_1.above_0);
    var _S102 : f32 = select(crossed_1.above_0 + crossed_1.across_0, crossed_1.below_0 - crossed_1.across_0, _S100) - crossed_1.half_width_1;
    var _S103 : bool = select(run_1.last_crossing_0, run_1.first_crossing_0, _S100);
    var _S104 : f32;
    if(shown_1.on_top_0)
    {
        _S104 = 0.0f;
    }
    else
    {
        _S104 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_1, i32(0));
    }
    var _S105 : f32;
    if((shown_1.on_top_0) != _S103)
    {
        _S105 = 0.0f;
    }
    else
    {
        _S105 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_1, select(i32(1), i32(-1), _S100));
    }
    var _S106 : f32 = 2.0f * _S102;
    var _S107 : f32 = 1.0f / max(_S106, 9.999999960041972e-13f);
    var _S108 : f32 = clamp((_S102 - _S101) * _S107, 0.0f, 1.0f);
    var _S109 : f32 = clamp((0.44999998807907104f - _S106 / crossed_1.half_width_1) * 4.0000004768371582f, 0.0f, 1.0f);
    return vec3<f32>(_S104 + (_S105 - _S104) * (_S108 * _S108 * (3.0f - 2.0f * _S108)), (_S104 - _S105) * (6.0f * _S108 * (1.0f - _S108) * _S107) * select(-1.0f, 1.0f, _S100), _S109 * _S109 * (3.0f - 2.0f * _S109));
}

struct PlaneHere_0
{
     plane_5 : Plane_0,
     number_2 : u32,
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
     height_4 : f32,
     slope_across_0 : f32,
     slope_along_0 : f32,
     dive_1 : vec3<f32>,
     slope_x_0 : f32,
     slope_y_0 : f32,
};

fn sample_in_0( here_1 : PlaneHere_0,  x_12 : f32,  y_6 : f32,  back_6 : bool) -> Sample_0
{
    var sample_0 : Sample_0;
    sample_0.here_0 = here_1;
    var _S110 : Crossing_0 = crossing_at_0(here_1.plane_5, x_12, y_6, back_6);
    sample_0.crossing_3 = _S110;
    var _S111 : Shown_0 = shown_at_0(_S110, back_6);
    sample_0.shown_2 = _S111;
    var _S112 : u32 = select(here_1.plane_5.weft_2, here_1.plane_5.warp_2, _S111.is_warp_2);
    var _S113 : u32 = select(here_1.plane_5.warp_2, here_1.plane_5.weft_2, _S111.is_warp_2);
    var _S114 : Cell_0 = select_cell_0(_S111.is_warp_2, sample_0.crossing_3.warp_3, sample_0.crossing_3.weft_3);
    var _S115 : Cell_0 = select_cell_0(_S111.is_warp_2, sample_0.crossing_3.weft_3, sample_0.crossing_3.warp_3);
    var _S116 : Run_0 = unpack_0(_S112, _S113, _S114.thread_1, _S115, _S111.word_0);
    var _S117 : Section_0 = section_at_0(_S114);
    var _S118 : bool = ((_S111.on_top_0) & (((_S116.distance_0) < (_S117.drop_0 * _S116.bend_1.sine_0))));
    var _S119 : f32 = select(-1.0f, 1.0f, ((_S111.on_top_0) & ((!_S118))));
    var _S120 : f32 = select(_S116.reach_0, _S116.other_reach_0, _S118);
    var _S121 : f32 = select(max(_S120 - _S116.distance_0, 0.0f), _S120 + _S116.distance_0, _S118);
    var _S122 : f32 = _S120 / _S116.bend_1.sine_0 - _S119 * _S117.drop_0;
    var _S123 : f32 = _S121 * _S121;
    var _S124 : f32 = max(_S122 * _S122 - _S123, 9.99999968265522539e-21f);
    var _S125 : f32 = rsqrt_0(_S124);
    var _S126 : f32 = _S123 / (_S124 * _S125 + _S122);
    var _S127 : bool = _S121 > 0.0f;
    var _S128 : f32 = select(-1.0f, 1.0f, _S111.on_top_0) * select(-1.0f, 1.0f, _S116.near_start_0);
    var _S129 : f32 = _S117.slope_0 * select(1.0f, _S122 * _S125, _S127);
    sample_0.slope_across_0 = _S129;
    var _S130 : f32 = select(0.0f, _S128 * _S121 * _S125, _S127);
    sample_0.slope_along_0 = _S130;
    var _S131 : vec3<f32> = dive_0(_S113, _S111, _S116, _S115);
    sample_0.dive_1 = _S131;
    sample_0.height_4 = select(families_0[_S112].height_scale_0 * _S119, 0.0f, _S116.straight_0) * (_S120 * _S116.bend_1.half_tangent_0 - _S126) - families_0[_S112].height_scale_0 * _S117.drop_0 - _S131.x + here_1.level_1;
    var _S132 : f32 = families_0[_S112].height_scale_0 * _S129;
    var _S133 : f32 = families_0[_S112].height_scale_0 * _S130 - _S131.y;
    sample_0.slope_x_0 = select(_S133, _S132, _S111.is_warp_2);
    sample_0.slope_y_0 = select(_S132, _S133, _S111.is_warp_2);
    sample_0.run_2 = _S116;
    sample_0.section_1 = _S117;
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
    var _S134 : f32 = direction_2.x;
    control_0.per_x_0 = 1.0f / max(abs(_S134), 9.99999971718068537e-10f);
    var _S135 : f32 = direction_2.y;
    control_0.per_y_0 = 1.0f / max(abs(_S135), 9.99999971718068537e-10f);
    control_0.right_1 = _S134 > 0.0f;
    control_0.up_1 = _S135 > 0.0f;
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

fn outline_distance_0( cell_9 : Cell_0,  shown_3 : Shown_0,  run_3 : Run_0,  lengthwise_0 : bool,  forwards_1 : bool) -> f32
{
    var _S136 : f32 = select(- cell_9.across_0, cell_9.across_0, forwards_1);
    var _S137 : f32 = select(cell_9.below_0, cell_9.above_0, forwards_1);
    var _S138 : f32 = - cell_9.half_width_1;
    var _S139 : bool = _S136 < _S138;
    var _S140 : bool = _S136 >= (cell_9.half_width_1);
    var _S141 : bool = (((lengthwise_0 & ((!select(run_3.first_crossing_0, run_3.last_crossing_0, forwards_1))))) & ((!shown_3.hole_3)));
    var _S142 : f32 = select(cell_9.half_width_1, _S138, _S139) - _S136;
    var _S143 : f32 = select(_S137, 2.0f * _S137 + _S136 - cell_9.half_width_1, ((shown_3.hole_3) | (((_S141 & ((!shown_3.on_top_0)))))));
    if((((_S141 & ((shown_3.on_top_0)))) & ((!((select(run_3.last_crossing_0, run_3.first_crossing_0, forwards_1) & (_S139)))))))
    {
        return select(run_3.from_start_0, run_3.to_end_0, forwards_1);
    }
    return select(_S142, _S143, _S140);
}

struct Probe_0
{
     height_5 : f32,
     hole_4 : bool,
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
    var _S144 : f32 = previous_1.rate_0 * step_4;
    var _S145 : f32 = rate_1 * step_4;
    if(((((((((!previous_1.known_0) | ((here_2.hole_4)))) | (((previous_1.yarn_0) != (here_2.yarn_1))))) | (((previous_1.rate_0) >= 0.0f)))) | ((rate_1 <= 0.0f))))
    {
        return -1.0f;
    }
    if((((3.0f * previous_1.clearance_0 + _S144) >= 0.0f) & (((3.0f * clearance_1 - _S145) >= 0.0f))))
    {
        return -1.0f;
    }
    var _S146 : f32 = clearance_1 - previous_1.clearance_0;
    var _S147 : f32 = 6.0f * _S146 - 4.0f * _S144 - 2.0f * _S145;
    var _S148 : f32 = -2.0f * _S144 / max(_S147 + sqrt(max(_S147 * _S147 - 4.0f * (3.0f * (_S144 + _S145 - 2.0f * _S146)) * _S144, 0.0f)), 9.99999968265522539e-21f);
    var _S149 : f32 = 1.0f - _S148;
    return select(-1.0f, _S149 * step_4, ((((_S148 > 0.01999999955296516f) & ((_S149 > 0.01999999955296516f)))) & ((((previous_1.clearance_0 * (2.0f * _S148 + 1.0f) + _S144 * _S148) * _S149 * _S149 + (clearance_1 * (2.0f * _S149 + 1.0f) - _S145 * _S149) * _S148 * _S148) < 0.0f))));
}

fn after_sample_0( clearance_2 : f32,  rate_2 : f32,  here_3 : Probe_0,  is_cell_exit_0 : bool) -> PreviousSample_0
{
    var previous_2 : PreviousSample_0;
    previous_2.clearance_0 = select(clearance_2, 1.0e+09f, here_3.hole_4);
    previous_2.rate_0 = rate_2;
    previous_2.yarn_0 = here_3.yarn_1;
    previous_2.known_0 = ((!here_3.hole_4) & ((!is_cell_exit_0)));
    return previous_2;
}

fn StepControl_to_cell_exit_0( this_1 : StepControl_0,  side_x_1 : f32,  side_y_1 : f32) -> f32
{
    return max(min(side_x_1 * this_1.per_x_0, side_y_1 * this_1.per_y_0), 0.0f) + this_1.epsilon_0;
}

fn StepControl_to_next_sample_0( this_2 : StepControl_0,  here_4 : Probe_0,  clearance_3 : f32,  rate_3 : f32) -> f32
{
    var _S150 : f32 = min(here_4.edge_x_1 * this_2.per_x_0, here_4.edge_y_1 * this_2.per_y_0);
    return min(this_2.step_2, select(max(_S150, 0.0f) + this_2.epsilon_0, _S150 - this_2.epsilon_0, ((((!here_4.hole_4) & (((rate_3 * _S150 + clearance_3) < 0.0f)))) & ((_S150 > (2.0f * this_2.epsilon_0))))));
}

struct ViewRay_0
{
     origin_0 : vec2<f32>,
     slope_1 : vec2<f32>,
};

fn ViewRay_at_0( this_3 : ViewRay_0,  height_6 : f32) -> vec2<f32>
{
    return this_3.origin_0 + this_3.slope_1 * vec2<f32>(height_6);
}

fn ViewRay_rate_0( this_4 : ViewRay_0,  here_5 : Probe_0) -> f32
{
    return here_5.slope_x_1 * this_4.slope_1.x + here_5.slope_y_1 * this_4.slope_1.y - 1.0f;
}

fn cubic_root_0( start_1 : f32,  end_0 : f32,  start_rate_0 : f32,  end_rate_0 : f32) -> f32
{
    var _S151 : f32 = end_0 - start_1;
    var _S152 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S151;
    var _S153 : f32 = 3.0f * _S151 - 2.0f * start_rate_0 - end_rate_0;
    var share_1 : f32 = start_1 / max(- _S151, 9.99999968265522539e-21f);
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
        var _S154 : f32 = clamp(share_1 - (((_S152 * share_1 + _S153) * share_1 + start_rate_0) * share_1 + start_1) / min((3.0f * _S152 * share_1 + 2.0f * _S153) * share_1 + start_rate_0, 0.10000000149011612f * _S151 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S155 : i32 = i_0 + i32(1);
        share_1 = _S154;
        i_0 = _S155;
    }
    return share_1;
}

fn between_0( above_1 : f32,  under_0 : f32,  above_gap_0 : f32,  under_gap_0 : f32) -> f32
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

fn fibre_direction_0( across_slope_0 : f32,  along_slope_0 : f32,  sine_1 : f32,  cosine_0 : f32) -> vec2<f32>
{
    var _S156 : f32 = along_slope_0 * along_slope_0 + 1.0f;
    var _S157 : f32 = rsqrt_0(_S156);
    var _S158 : f32 = sine_1 * _S157 * rsqrt_0(_S156 + across_slope_0 * across_slope_0);
    return vec2<f32>(- _S158 * _S156, _S158 * across_slope_0 * along_slope_0 + cosine_0 * _S157);
}

fn arc_sine_0( x_13 : f32) -> f32
{
    var _S159 : f32 = abs(x_13);
    var _S160 : bool = _S159 > 0.5f;
    var _S161 : f32 = select(_S159 * _S159, 0.5f * (1.0f - _S159), _S160);
    var _S162 : f32 = select(_S159, sqrt(max(_S161, 0.0f)), _S160);
    var _S163 : f32 = ((((0.04216320067644119f * _S161 + 0.02418131195008755f) * _S161 + 0.04547002539038658f) * _S161 + 0.07495300471782684f) * _S161 + 0.16666752099990845f) * _S161 * _S162 + _S162;
    var _S164 : f32 = select(_S163, 1.57079637050628662f - 2.0f * _S163, _S160);
    return select(_S164, - _S164, x_13 < 0.0f);
}

fn run_share_0( word_2 : u32) -> f32
{
    var _S165 : f32 = f32(((((word_2 >> (u32(1)))) & (u32(127)))) + ((((word_2 >> (u32(8)))) & (u32(127)))) + u32(1));
    return _S165 / (_S165 + 0.5f * f32(((((word_2 >> (u32(15)))) & (u32(63)))) + ((((word_2 >> (u32(21)))) & (u32(63))))));
}

fn angle_of_0( direction_3 : vec2<f32>) -> f32
{
    var _S166 : f32 = direction_3.x;
    var _S167 : f32 = arc_sine_0(_S166);
    var _S168 : bool = _S166 < 0.0f;
    var _S169 : f32 = select(3.14159274101257324f, -3.14159274101257324f, _S168);
    var _S170 : f32 = direction_3.y;
    return select(0.5f * _S169 - select(1.0f, -1.0f, _S168) * arc_sine_0(_S170), select(_S167, _S169 - _S167, _S170 < 0.0f), (abs(_S166)) < 0.69999998807907104f);
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
    var _S171 : Albedos_0;
    _S171.diffuse_reflect_0 = diffuse_reflect_1;
    _S171.diffuse_transmit_0 = diffuse_transmit_1;
    _S171.specular_reflect_0 = specular_reflect_1;
    _S171.specular_transmit_0 = specular_transmit_1;
    return _S171;
}

struct Hairs_0
{
     place_1 : vec2<f32>,
     below_1 : f32,
     back_7 : bool,
     size_3 : f32,
};

fn Hairs_x24init_0( place_2 : vec2<f32>,  below_2 : f32,  back_8 : bool,  size_4 : f32) -> Hairs_0
{
    var _S172 : Hairs_0;
    _S172.place_1 = place_2;
    _S172.below_1 = below_2;
    _S172.back_7 = back_8;
    _S172.size_3 = size_4;
    return _S172;
}

struct YarnPoint_0
{
     back_9 : bool,
     hole_5 : bool,
     is_warp_3 : bool,
     x_14 : f32,
     y_7 : f32,
     height_7 : f32,
     normal_3 : vec3<f32>,
     tangent_2 : vec3<f32>,
     surface_normal_0 : vec3<f32>,
     diffuse_gain_0 : f32,
     roughness_1 : f32,
     albedos_0 : Albedos_0,
     hairs_0 : Hairs_0,
     hair_cover_0 : f32,
     place_3 : vec2<f32>,
     plane_6 : f32,
};

fn YarnPoint_x24init_0( back_10 : bool,  hole_6 : bool,  is_warp_4 : bool,  x_15 : f32,  y_8 : f32,  height_8 : f32,  normal_4 : vec3<f32>,  tangent_3 : vec3<f32>,  surface_normal_1 : vec3<f32>,  diffuse_gain_1 : f32,  roughness_2 : f32,  albedos_1 : Albedos_0,  hairs_1 : Hairs_0,  hair_cover_1 : f32,  place_4 : vec2<f32>,  plane_7 : f32) -> YarnPoint_0
{
    var _S173 : YarnPoint_0;
    _S173.back_9 = back_10;
    _S173.hole_5 = hole_6;
    _S173.is_warp_3 = is_warp_4;
    _S173.x_14 = x_15;
    _S173.y_7 = y_8;
    _S173.height_7 = height_8;
    _S173.normal_3 = normal_4;
    _S173.tangent_2 = tangent_3;
    _S173.surface_normal_0 = surface_normal_1;
    _S173.diffuse_gain_0 = diffuse_gain_1;
    _S173.roughness_1 = roughness_2;
    _S173.albedos_0 = albedos_1;
    _S173.hairs_0 = hairs_1;
    _S173.hair_cover_0 = hair_cover_1;
    _S173.place_3 = place_4;
    _S173.plane_6 = plane_7;
    return _S173;
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
    var _S174 : Hair_0;
    _S174.cover_1 = cover_2;
    _S174.normal_5 = normal_6;
    _S174.tangent_4 = tangent_5;
    _S174.is_warp_5 = is_warp_6;
    _S174.shade_0 = shade_1;
    return _S174;
}

fn share_of_0( bits_0 : u32) -> f32
{
    return (f32((bits_0 & (u32(1023)))) + 0.5f) * 0.0009765625f;
}

fn ply_offset_0( family_13 : u32,  point_1 : SurfacePoint_0,  back_11 : bool) -> f32
{
    var _S175 : f32 = (point_1.fibre_across_0 * families_0[family_13].ply_cosine_0 + point_1.fibre_along_0 * select(families_0[family_13].ply_sine_0, - families_0[family_13].ply_sine_0, back_11)) * families_0[family_13].plies_per_mm_0;
    return 2.0f * (_S175 - floor(_S175)) - 1.0f;
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
    var _S176 : f32 = floor(position_5);
    var _S177 : f32 = position_5 - _S176;
    var _S178 : u32 = u32(i32(_S176));
    var _S179 : f32 = signed_noise_0(hash_bits_0(key_4, _S178));
    var _S180 : f32 = signed_noise_0(hash_bits_0(key_4, _S178 + u32(1)));
    return vec2<f32>(mix(_S179, _S180, smooth_share_0(_S177)), 6.0f * _S177 * (1.0f - _S177) * (_S180 - _S179));
}

fn fibre_cell_0( across_4 : f32,  along_1 : f32,  width_2 : f32) -> vec3<f32>
{
    var _S181 : f32 = floor(across_4 / width_2);
    return vec3<f32>(_S181, along_1 / (width_2 * 40.0f) + 0.61799997091293335f * _S181, 2.0f * (across_4 / width_2 - _S181) - 1.0f);
}

fn cell_noise_0( key_5 : u32,  cell_10 : vec3<f32>) -> vec2<f32>
{
    var _S182 : f32 = cell_10.y;
    var _S183 : f32 = floor(_S182);
    var _S184 : u32 = u32(i32(cell_10.x)) * u32(65536) + u32(i32(_S183));
    var _S185 : u32 = hash_bits_0(key_5, _S184);
    var _S186 : u32 = hash_bits_0(key_5, _S184 + u32(1));
    return mix(vec2<f32>(signed_noise_0(_S185), signed_noise_0((_S185 >> (u32(16))))), vec2<f32>(signed_noise_0(_S186), signed_noise_0((_S186 >> (u32(16))))), vec2<f32>(smooth_share_0(_S182 - _S183)));
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
    var _S187 : vec3<f32> = select_vector_1((dot(frame_0.tangent_6, hair_0.tangent_4)) < 0.0f, (vec3<f32>(0) - hair_0.tangent_4), hair_0.tangent_4);
    var blended_0 : YarnFrame_0;
    var _S188 : vec3<f32> = vec3<f32>(hair_0.cover_1);
    var _S189 : vec3<f32> = normalize(mix(frame_0.normal_7, hair_0.normal_5, _S188));
    blended_0.normal_7 = _S189;
    var _S190 : vec3<f32> = mix(frame_0.tangent_6, _S187, _S188);
    var _S191 : vec3<f32> = _S190 - vec3<f32>(dot(_S190, _S189)) * _S189;
    blended_0.tangent_6 = _S191 * vec3<f32>(rsqrt_0(max(dot(_S191, _S191), 9.999999960041972e-13f)));
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
    var _S192 : f32 = light_1.z;
    if(_S192 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S192, 0.0f), max(dot(light_1, normal_8), 0.0f), blend_1);
}

fn projected_area_1( direction_4 : vec3<f32>,  tangent_7 : vec3<f32>,  roughness_3 : f32) -> f32
{
    var _S193 : f32 = dot(direction_4, tangent_7);
    return sqrt(max((roughness_3 + 1.0f) * (roughness_3 - 1.0f) * _S193 * _S193 + 1.0f, roughness_3 * roughness_3));
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
    var _S194 : f32 = roughness_4 * roughness_4;
    var _S195 : f32 = squared_along_0 * (1.0f - _S194) + _S194;
    return 0.31830987334251404f * _S194 * roughness_4 / (_S195 * _S195);
}

fn density_between_0( light_2 : vec3<f32>,  view_1 : vec3<f32>,  tangent_8 : vec3<f32>,  roughness_5 : f32) -> f32
{
    var _S196 : vec3<f32> = light_2 + view_1;
    var _S197 : f32 = dot(_S196, tangent_8);
    return flake_density_0(min(_S197 * _S197 / max(square_0(_S196), 9.999999960041972e-13f), 1.0f), roughness_5);
}

fn transmission_1( light_3 : vec3<f32>,  view_2 : vec3<f32>,  normal_9 : vec3<f32>,  tangent_9 : vec3<f32>,  roughness_6 : f32,  optical_depth_1 : f32) -> f32
{
    var _S198 : f32 = - dot(light_3, normal_9);
    var _S199 : f32 = dot(view_2, normal_9);
    if(((_S198 <= 0.0f) | ((_S199 <= 0.0f))))
    {
        return 0.0f;
    }
    var _S200 : f32 = 1.0f / max(_S199, 9.99999997475242708e-07f);
    var _S201 : f32 = projected_area_1(light_3, tangent_9, roughness_6) / max(_S198, 9.99999997475242708e-07f);
    var _S202 : f32 = projected_area_1(view_2, tangent_9, roughness_6) * _S200;
    return density_between_0(light_3, view_2, tangent_9, roughness_6) * 0.25f * optical_depth_1 * exponential_0(- optical_depth_1 * min(_S201, _S202)) * mean_attenuation_0(optical_depth_1 * abs(_S201 - _S202)) * _S200;
}

fn reflection_0( light_4 : vec3<f32>,  view_3 : vec3<f32>,  normal_10 : vec3<f32>,  tangent_10 : vec3<f32>,  roughness_7 : f32,  optical_depth_2 : f32) -> f32
{
    var _S203 : f32 = dot(light_4, normal_10);
    var _S204 : f32 = dot(view_3, normal_10);
    if(((_S203 <= 0.0f) | ((_S204 <= 0.0f))))
    {
        return 0.0f;
    }
    var _S205 : f32 = max(_S203, 9.99999997475242708e-07f);
    var _S206 : f32 = max(_S204, 9.99999997475242708e-07f);
    var _S207 : f32 = projected_area_1(light_4, tangent_10, roughness_7) * _S206 + projected_area_1(view_3, tangent_10, roughness_7) * _S205;
    var _S208 : f32 = optical_depth_2 * _S207 / (_S205 * _S206);
    return 0.25f * density_between_0(light_4, view_3, tangent_10, roughness_7) * (_S208 * mean_attenuation_0(_S208)) * _S205 / _S207;
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

fn arc_tangent_quotient_0( x_16 : f32,  y_9 : f32) -> f32
{
    return ((((((0.0f * x_16 + 0.00809729471802711f) * x_16 + -0.0377517081797123f) * x_16 + 0.08475969731807709f) * x_16 + -0.13537675142288208f) * x_16 + 0.19895026087760925f) * x_16 + -0.33327975869178772f) * x_16 + 0.99999970197677612f;
}

fn arc_tangent_of_ratio_0( ratio_0 : f32) -> f32
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0f);
}

fn arc_tangent_0( y_10 : f32,  x_17 : f32) -> f32
{
    var _S209 : f32 = abs(x_17);
    var _S210 : f32 = abs(y_10);
    var angle_0 : f32 = arc_tangent_of_ratio_0(min(_S209, _S210) / max(max(_S209, _S210), 1.00000000317107685e-30f));
    var angle_1 : f32 = select(angle_0, 1.57079637050628662f - angle_0, _S210 > _S209);
    var angle_2 : f32 = select(angle_1, 3.14159274101257324f - angle_1, x_17 < 0.0f);
    return select(angle_2, - angle_2, y_10 < 0.0f);
}

struct NodeTaps_0
{
     nodes_0 : vec4<u32>,
     weights_0 : vec4<u32>,
     inverse_sum_0 : f32,
};

fn node_taps_of_0( direction_5 : vec3<f32>,  azimuths_0 : u32) -> NodeTaps_0
{
    var _S211 : f32 = arc_tangent_0(direction_5.y, direction_5.x) * (0.5f * f32(azimuths_0) * 0.31830987334251404f);
    var _S212 : f32 = floor(_S211);
    var _S213 : f32 = _S211 - _S212;
    var _S214 : f32 = sqrt(clamp((1.0f - abs(direction_5.z)) / 0.97000002861022949f, 0.0f, 1.0f));
    var _S215 : f32 = 7.0f * _S214 * sqrt(_S214);
    var _S216 : f32 = min(floor(_S215), 6.0f);
    var _S217 : f32 = _S215 - _S216;
    var _S218 : u32 = u32(i32(_S212) + i32(azimuths_0)) % azimuths_0;
    var _S219 : u32 = u32(_S216);
    var _S220 : u32 = _S218 * u32(8) + _S219;
    var _S221 : u32 = (_S218 + u32(1)) % azimuths_0;
    var _S222 : u32 = _S221 * u32(8) + _S219;
    var taps_0 : NodeTaps_0;
    taps_0.nodes_0 = vec4<u32>(_S220, _S220 + u32(1), _S222, _S222 + u32(1));
    var _S223 : f32 = 1.0f - _S213;
    var _S224 : f32 = 1.0f - _S217;
    var _S225 : vec4<u32> = vec4<u32>(vec4<f32>(_S223 * _S224, _S223 * _S217, _S213 * _S224, _S213 * _S217) * vec4<f32>(252.0f) + vec4<f32>(0.5f));
    taps_0.weights_0 = _S225;
    taps_0.inverse_sum_0 = 1.0f / f32(_S225.x + _S225.y + _S225.z + _S225.w);
    return taps_0;
}

fn node_taps_0( direction_6 : vec3<f32>) -> NodeTaps_0
{
    var _S226 : NodeTaps_0 = node_taps_of_0(direction_6, u32(32));
    return _S226;
}

fn half_vector_0( light_5 : vec3<f32>,  view_4 : vec3<f32>) -> vec3<f32>
{
    var _S227 : vec3<f32> = light_5 + view_4;
    return _S227 * vec3<f32>(rsqrt_0(max(square_0(_S227), 9.999999960041972e-13f)));
}

fn joint_terms_0( taps_1 : NodeTaps_0,  table_1 : u32,  ratio_1 : u32) -> vec4<f32>
{
    var _S228 : vec4<f32> = vec4<f32>(0.0f);
    var i_1 : u32 = u32(0);
    var sums_3 : vec4<f32> = _S228;
    for(;;)
    {
        if(i_1 < u32(4))
        {
        }
        else
        {
            break;
        }
        var _S229 : u32 = table_1 + u32(4) * taps_1.nodes_0[i_1] + u32(2) * ratio_1;
        var _S230 : vec2<u32> = vec2<u32>(words_0[_S229], words_0[_S229 + u32(1)]);
        var sums_4 : vec4<f32> = sums_3 + vec4<f32>(((vec4<i32>(vec2<i32>((_S230 << (vec2<u32>(u32(16))))), vec2<i32>(_S230)).xzyw) >> (vec4<u32>(u32(16))))) * vec4<f32>(f32(taps_1.weights_0[i_1]));
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
    var _S231 : vec4<u32> = vec4<u32>(u32(16711935));
    var _S232 : vec4<u32> = ((packs_1 & (_S231))) * taps_2.weights_0;
    var _S233 : vec4<u32> = ((((packs_1 >> (vec4<u32>(u32(8))))) & (_S231))) * taps_2.weights_0;
    return bytes_of_sums_0(_S232.x + _S232.y + _S232.z + _S232.w, _S233.x + _S233.y + _S233.z + _S233.w) * vec4<f32>(taps_2.inverse_sum_0);
}

fn interpolate_table_0( taps_3 : NodeTaps_0,  table_2 : u32,  stride_0 : u32) -> vec4<f32>
{
    var _S234 : vec4<u32> = vec4<u32>(table_2) + taps_3.nodes_0 * vec4<u32>(stride_0);
    return interpolate_0(taps_3, vec4<u32>(words_0[_S234.x], words_0[_S234.y], words_0[_S234.z], words_0[_S234.w]));
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
    var _S235 : vec3<f32> = vec3<f32>(table_number_0(row_1 + u32(4)), table_number_0(row_1 + u32(5)), table_number_0(row_1 + u32(6)));
    group_0.tangent_11 = _S235;
    var _S236 : f32 = table_number_0(row_1 + u32(7));
    var _S237 : f32 = table_number_0(row_1 + u32(8));
    group_0.variance_0 = vec3<f32>(_S236, _S237, 1.0f - square_0(_S235) - _S236 - _S237);
    group_0.covariance_0 = vec3<f32>(table_number_0(row_1 + u32(9)), table_number_0(row_1 + u32(10)), table_number_0(row_1 + u32(11)));
    group_0.roughness_8 = roughness_9;
    return group_0;
}

fn Group_variance_along_0( this_5 : Group_0,  direction_7 : vec3<f32>) -> f32
{
    var _S238 : f32 = direction_7.x;
    var _S239 : f32 = direction_7.y;
    var _S240 : f32 = direction_7.z;
    return max(dot(this_5.variance_0, direction_7 * direction_7) + 2.0f * dot(this_5.covariance_0, vec3<f32>(_S238 * _S239, _S238 * _S240, _S239 * _S240)), 0.0f);
}

fn mean_area_0( group_1 : Group_0,  direction_8 : vec3<f32>) -> f32
{
    var _S241 : f32 = dot(direction_8, group_1.tangent_11);
    var _S242 : f32 = group_1.roughness_8;
    var _S243 : f32 = _S242 * _S242;
    return sqrt(max((_S243 - 1.0f) * (_S241 * _S241 + Group_variance_along_0(group_1, direction_8)) + 1.0f, _S243));
}

fn mean_density_0( group_2 : Group_0,  half_0 : vec3<f32>) -> f32
{
    var _S244 : f32 = group_2.roughness_8;
    var _S245 : f32 = max(sqrt(max(1.0f - _S244 * _S244, 0.0f)) / group_2.roughness_8, 0.00100000004749745f);
    var _S246 : f32 = max(sqrt(3.0f * Group_variance_along_0(group_2, half_0)), group_2.roughness_8 * 0.01999999955296516f + 0.00009999999747379f);
    var _S247 : f32 = dot(half_0, group_2.tangent_11);
    var _S248 : f32 = _S245 * (_S247 - _S246);
    var _S249 : f32 = _S245 * (_S247 + _S246);
    var _S250 : f32 = _S248 * _S249;
    var _S251 : f32 = 2.0f * _S246 * _S245;
    return 0.15915493667125702f / group_2.roughness_8 * ((1.0f - _S250) / ((_S248 * _S248 + 1.0f) * (_S249 * _S249 + 1.0f)) + arc_tangent_0(_S251, 1.0f + _S250) / _S251);
}

fn layer_value_0( group_3 : Group_0,  half_1 : vec3<f32>,  light_6 : vec3<f32>,  view_5 : vec3<f32>,  optical_depth_3 : f32) -> f32
{
    var _S252 : bool = (light_6.z) < 0.0f;
    var _S253 : f32 = dot(light_6, group_3.normal_11);
    var _S254 : f32 = max(dot(view_5, group_3.normal_11), 0.01999999955296516f);
    var _S255 : f32 = mean_area_0(group_3, light_6) / max(select(_S253, - _S253, _S252), 0.01999999955296516f);
    var _S256 : f32 = mean_area_0(group_3, view_5) / _S254;
    var _S257 : f32 = optical_depth_3 * max(select(_S255 + _S256, abs(_S255 - _S256), _S252), 0.00100000004749745f);
    return 0.25f * mean_density_0(group_3, half_1) * select(1.0f - 0.34999999403953552f * (1.0f - square_0(group_3.normal_11)), 1.0f, _S252) * (optical_depth_3 * select(1.0f, exponential_0(- optical_depth_3 * min(_S255, _S256)), _S252) * (1.0f - exponential_0(- _S257)) / _S257 / _S254);
}

struct Yarns_0
{
     warp_4 : vec4<f32>,
     weft_4 : vec4<f32>,
     shares_0 : vec3<f32>,
};

fn Yarns_x24init_0( warp_5 : vec4<f32>,  weft_5 : vec4<f32>,  shares_1 : vec3<f32>) -> Yarns_0
{
    var _S258 : Yarns_0;
    _S258.warp_4 = warp_5;
    _S258.weft_4 = weft_5;
    _S258.shares_0 = shares_1;
    return _S258;
}

fn irregular_over_0( family_14 : u32,  key_6 : u32,  place_5 : f32,  width_3 : f32,  along_2 : f32,  length_0 : f32) -> vec4<f32>
{
    var _S259 : f32 = max(width_3, 0.0625f);
    var _S260 : f32 = min(_S259, 64.0f);
    var _S261 : f32 = max(length_0 / 2.0f, 1.0f);
    var _S262 : f32 = along_2 / 2.0f - 0.5f * _S261;
    var _S263 : f32 = 0.5f * _S260;
    var _S264 : vec2<f32> = floor(vec2<f32>(place_5 - _S263, place_5 + _S263) / vec2<f32>(64.0f));
    var _S265 : vec4<f32> = vec4<f32>(0.0f);
    var number_3 : u32 = u32(0);
    var sums_5 : vec4<f32> = _S265;
    for(;;)
    {
        if(number_3 < u32(6))
        {
        }
        else
        {
            break;
        }
        var _S266 : bool = number_3 >= u32(3);
        var _S267 : u32 = select(number_3, number_3 - u32(3), _S266);
        var _S268 : f32 = select(-1.0f, 1.0f, _S266);
        var _S269 : f32 = _S264.y;
        var _S270 : f32 = _S264.x;
        var _S271 : f32 = select(_S270, _S269, _S266);
        var _S272 : f32 = place_5 + _S268 * 0.5f * _S260 - 64.0f * _S271;
        var _S273 : f32 = clamp(floor(_S272), 0.0f, 63.0f);
        var _S274 : f32 = _S272 - _S273;
        var _S275 : f32 = select(select(64.0f, 0.0f, _S266), _S273 + f32(_S267), _S267 < u32(2));
        var _S276 : f32 = _S268 * select(select(select(0.0f, -1.0f, _S270 != _S269), _S274, _S267 == u32(1)), 1.0f - _S274, _S267 == u32(0));
        if(_S276 == 0.0f)
        {
            number_3 = number_3 + u32(1);
            continue;
        }
        var _S277 : u32 = hash_bits_0(key_6, u32(i32(_S271)));
        sums_5 = sums_5 + vec4<f32>(_S276) * irregular_integral_0(family_14, ((_S277 & (u32(127)))) + u32(_S275), _S262 + f32((_S277 >> (u32(22)))), _S261);
        number_3 = number_3 + u32(1);
    }
    return sums_5 * irregular_units_0(family_14) * vec4<f32>((sqrt(_S260 / _S259) / (_S260 * _S261)));
}

fn shown_of_covers_0( covers_0 : vec2<f32>,  warp_on_top_1 : f32) -> vec3<f32>
{
    var _S278 : f32 = covers_0.x;
    var _S279 : f32 = covers_0.y;
    return vec3<f32>(_S278 * (1.0f - _S279 * (1.0f - warp_on_top_1)), _S279 * (1.0f - _S278 * warp_on_top_1), (1.0f - _S278) * (1.0f - _S279));
}

struct FamilyAlbedos_0
{
     warp_6 : Albedos_0,
     weft_6 : Albedos_0,
};

fn FamilyAlbedos_x24init_0( warp_7 : Albedos_0,  weft_7 : Albedos_0) -> FamilyAlbedos_0
{
    var _S280 : FamilyAlbedos_0;
    _S280.warp_6 = warp_7;
    _S280.weft_6 = weft_7;
    return _S280;
}

struct LayersBehind_0
{
     reflected_0 : vec3<f32>,
     transmitted_0 : vec3<f32>,
};

fn LayersBehind_x24init_0( reflected_1 : vec3<f32>,  transmitted_1 : vec3<f32>) -> LayersBehind_0
{
    var _S281 : LayersBehind_0;
    _S281.reflected_0 = reflected_1;
    _S281.transmitted_0 = transmitted_1;
    return _S281;
}

struct LayeredAlbedos_0
{
     albedos_2 : FamilyAlbedos_0,
     behind_0 : LayersBehind_0,
};

fn LayeredAlbedos_x24init_0( albedos_3 : FamilyAlbedos_0,  behind_1 : LayersBehind_0) -> LayeredAlbedos_0
{
    var _S282 : LayeredAlbedos_0;
    _S282.albedos_2 = albedos_3;
    _S282.behind_0 = behind_1;
    return _S282;
}

struct LayerSums_0
{
     albedos_4 : Albedos_0,
     weight_3 : f32,
     behind_2 : LayersBehind_0,
};

fn LayerSums_x24init_0( albedos_5 : Albedos_0,  weight_4 : f32,  behind_3 : LayersBehind_0) -> LayerSums_0
{
    var _S283 : LayerSums_0;
    _S283.albedos_4 = albedos_5;
    _S283.weight_3 = weight_4;
    _S283.behind_2 = behind_3;
    return _S283;
}

struct Bound_0
{
     thread_9 : u32,
     turns_2 : f32,
     cell_11 : f32,
     visible_0 : f32,
     width_4 : f32,
     gap_0 : f32,
};

fn bound_at_0( family_15 : u32,  position_7 : f32) -> Bound_0
{
    var _S284 : Cell_0 = locate_0(family_15, position_7);
    var _S285 : f32 = table_number_0(families_0[family_15].before_0 + u32(2) * _S284.thread_1 + u32(1));
    var bound_0 : Bound_0;
    bound_0.thread_9 = _S284.thread_1;
    bound_0.turns_2 = round((position_7 - families_0[family_15].start_0 - _S285 - _S284.below_0) * families_0[family_15].inverse_period_0);
    bound_0.cell_11 = _S284.below_0;
    var _S286 : f32 = 2.0f * _S284.half_width_1;
    bound_0.width_4 = _S286;
    bound_0.visible_0 = clamp((_S284.across_0 + _S284.half_width_1) / _S286, 0.0f, 1.0f);
    bound_0.gap_0 = min(_S284.below_0, _S284.below_0 - _S284.across_0 - _S284.half_width_1) + max(_S284.across_0 - _S284.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
     low_1 : Bound_0,
     high_1 : Bound_0,
};

fn stretch_of_0( family_16 : u32,  centre_1 : f32,  size_5 : f32) -> Stretch_0
{
    var _S287 : f32 = centre_1 - floor((centre_1 - families_0[family_16].start_0) * families_0[family_16].inverse_period_0) * families_0[family_16].period_0;
    var _S288 : f32 = 0.5f * max(size_5, families_0[family_16].smallest_box_0);
    var stretch_0 : Stretch_0;
    stretch_0.low_1 = bound_at_0(family_16, _S287 - _S288);
    stretch_0.high_1 = bound_at_0(family_16, _S287 + _S288);
    return stretch_0;
}

fn table_colour_0( index_6 : u32) -> vec3<f32>
{
    return vec3<f32>(table_number_0(index_6), table_number_0(index_6 + u32(1)), table_number_0(index_6 + u32(2)));
}

fn table_albedos_0( row_2 : u32) -> Albedos_0
{
    var albedos_6 : Albedos_0;
    albedos_6.diffuse_reflect_0 = table_colour_0(row_2);
    albedos_6.diffuse_transmit_0 = table_colour_0(row_2 + u32(3));
    albedos_6.specular_reflect_0 = table_colour_0(row_2 + u32(6));
    albedos_6.specular_transmit_0 = table_colour_0(row_2 + u32(9));
    return albedos_6;
}

fn Stretch_turns_0( this_6 : Stretch_0) -> f32
{
    return this_6.high_1.turns_2 - this_6.low_1.turns_2;
}

fn lengths_0( family_17 : u32,  stretch_1 : Stretch_0) -> vec3<f32>
{
    var _S289 : f32 = Stretch_turns_0(stretch_1);
    var _S290 : u32 = families_0[family_17].before_0 + u32(2) * stretch_1.low_1.thread_9;
    var _S291 : u32 = families_0[family_17].before_0 + u32(2) * stretch_1.high_1.thread_9;
    var _S292 : f32 = table_number_0(_S291) - table_number_0(_S290);
    var _S293 : f32 = table_number_0(_S291 + u32(1)) - table_number_0(_S290 + u32(1));
    return vec3<f32>(_S292 + stretch_1.high_1.visible_0 * stretch_1.high_1.width_4 - stretch_1.low_1.visible_0 * stretch_1.low_1.width_4 + _S289 * families_0[family_17].visible_total_0, _S293 - _S292 + stretch_1.high_1.gap_0 - stretch_1.low_1.gap_0 + _S289 * (families_0[family_17].period_0 - families_0[family_17].visible_total_0), _S293 + stretch_1.high_1.cell_11 - stretch_1.low_1.cell_11 + _S289 * families_0[family_17].period_0);
}

fn integrals_along_0( family_18 : u32,  stretch_2 : Stretch_0,  quantity_0 : u32) -> vec2<f32>
{
    var _S294 : u32 = u32(3) * families_0[family_18].quantities_0;
    var _S295 : u32 = families_0[family_18].colour_threads_0 + _S294 * stretch_2.low_1.thread_9 + quantity_0;
    var _S296 : u32 = families_0[family_18].colour_threads_0 + _S294 * stretch_2.high_1.thread_9 + quantity_0;
    var _S297 : u32 = families_0[family_18].colour_threads_0 + _S294 * u32(families_0[family_18].count_0) + quantity_0;
    var _S298 : f32 = table_number_0(_S295);
    var _S299 : f32 = table_number_0(_S296);
    var _S300 : f32 = Stretch_turns_0(stretch_2);
    var _S301 : u32 = u32(2) * families_0[family_18].quantities_0;
    return vec2<f32>(table_number_0(_S296 + families_0[family_18].quantities_0) - table_number_0(_S295 + families_0[family_18].quantities_0) + _S299 * stretch_2.high_1.visible_0 * stretch_2.high_1.width_4 - _S298 * stretch_2.low_1.visible_0 * stretch_2.low_1.width_4 + _S300 * table_number_0(_S297 + families_0[family_18].quantities_0), table_number_0(_S296 + _S301) - table_number_0(_S295 + _S301) + _S299 * stretch_2.high_1.cell_11 - _S298 * stretch_2.low_1.cell_11 + _S300 * table_number_0(_S297 + _S301));
}

fn Stretch_wraps_0( this_7 : Stretch_0) -> bool
{
    return (this_7.high_1.thread_9) < (this_7.low_1.thread_9);
}

fn Stretch_differences_0( this_8 : Stretch_0,  entries_0 : vec4<u32>,  whole_0 : u32) -> vec4<u32>
{
    var _S302 : u32 = entries_0.z;
    var _S303 : u32 = entries_0.x;
    return vec4<u32>(_S302 - _S303 + select(u32(0), whole_0, Stretch_wraps_0(this_8)), entries_0.w - _S302, entries_0.y - _S303, whole_0);
}

fn row_differences_0( across_5 : Stretch_0,  row_3 : u32,  count_3 : u32,  quantities_1 : u32) -> vec4<u32>
{
    var _S304 : u32 = row_3 + across_5.low_1.thread_9 * quantities_1;
    var _S305 : u32 = row_3 + across_5.high_1.thread_9 * quantities_1;
    return Stretch_differences_0(across_5, vec4<u32>(words_0[_S304], words_0[_S304 + quantities_1], words_0[_S305], words_0[_S305 + quantities_1]), words_0[row_3 + count_3 * quantities_1]);
}

fn Stretch_weights_0( this_9 : Stretch_0) -> vec4<f32>
{
    return vec4<f32>(1.0f, this_9.high_1.visible_0, - this_9.low_1.visible_0, Stretch_turns_0(this_9) - select(0.0f, 1.0f, Stretch_wraps_0(this_9)));
}

fn integral_on_top_0( family_19 : u32,  across_6 : Stretch_0,  along_3 : Stretch_0,  crossing_count_0 : u32,  quantity_1 : u32) -> f32
{
    var _S306 : u32 = u32(families_0[family_19].count_0);
    var _S307 : u32 = (_S306 + u32(1)) * families_0[family_19].quantities_0;
    var _S308 : u32 = families_0[family_19].colour_areas_0 + quantity_1;
    var _S309 : vec4<u32> = row_differences_0(across_6, _S308 + along_3.low_1.thread_9 * _S307, _S306, families_0[family_19].quantities_0);
    var _S310 : vec4<u32> = row_differences_0(across_6, _S308 + along_3.high_1.thread_9 * _S307, _S306, families_0[family_19].quantities_0);
    var _S311 : vec4<u32> = row_differences_0(across_6, _S308 + crossing_count_0 * _S307, _S306, families_0[family_19].quantities_0);
    var _S312 : vec4<f32> = Stretch_weights_0(across_6);
    return dot(vec4<f32>(dot(vec4<f32>(vec4<i32>(_S310 - _S309 + select_vector_2(Stretch_wraps_0(along_3), _S311, vec4<u32>(vec4<i32>(i32(0)))))), _S312), dot(vec4<f32>(vec4<i32>(row_differences_0(across_6, _S308 + (along_3.high_1.thread_9 + u32(1)) * _S307, _S306, families_0[family_19].quantities_0) - _S310)), _S312), dot(vec4<f32>(vec4<i32>(row_differences_0(across_6, _S308 + (along_3.low_1.thread_9 + u32(1)) * _S307, _S306, families_0[family_19].quantities_0) - _S309)), _S312), dot(vec4<f32>(vec4<i32>(_S311)), _S312)), Stretch_weights_0(along_3)) * families_0[family_19].area_unit_0;
}

fn with_added_albedos_0( albedos_7 : Albedos_0,  weight_5 : f32,  row_4 : u32) -> Albedos_0
{
    var _S313 : Albedos_0 = table_albedos_0(row_4);
    var sum_0 : Albedos_0;
    var _S314 : vec3<f32> = vec3<f32>(weight_5);
    sum_0.diffuse_reflect_0 = albedos_7.diffuse_reflect_0 + _S314 * _S313.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_7.diffuse_transmit_0 + _S314 * _S313.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_7.specular_reflect_0 + _S314 * _S313.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_7.specular_transmit_0 + _S314 * _S313.specular_transmit_0;
    return sum_0;
}

fn mean_albedos_0( family_20 : u32,  crossing_4 : u32,  own_1 : Stretch_0,  other_2 : Stretch_0,  back_12 : bool) -> Albedos_0
{
    var albedos_8 : Albedos_0 = table_albedos_0(families_0[family_20].colour_mean_0);
    if((families_0[family_20].quantities_0) == u32(1))
    {
        return albedos_8;
    }
    var _S315 : vec3<f32> = lengths_0(crossing_4, other_2);
    var is_exposed_0 : bool = false;
    var weight_6 : f32 = 0.0f;
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
        var _S316 : vec2<f32> = integrals_along_0(family_20, own_1, quantity_2);
        var _S317 : f32 = integral_on_top_0(family_20, own_1, other_2, u32(families_0[crossing_4].count_0), quantity_2);
        var _S318 : f32 = _S316.x;
        var _S319 : f32 = _S318 * _S315.x;
        var _S320 : f32 = select(_S317, _S319 - _S317, back_12);
        var _S321 : bool = quantity_2 == u32(0);
        if(_S321)
        {
            is_exposed_0 = _S320 > (16.0f * families_0[family_20].area_unit_0 * min(_S319 / families_0[family_20].crossing_area_0, 1.0f) + 0.00000999999974738f * _S319);
        }
        var _S322 : f32 = _S318 * _S315.y + select(0.0f, _S320, is_exposed_0) + 0.000244140625f * _S315.z * _S316.y;
        if(_S321)
        {
            weight_6 = 1.0f / max(_S322, 9.99999968265522539e-21f);
        }
        else
        {
            albedos_8 = with_added_albedos_0(albedos_8, _S322 * weight_6, families_0[family_20].colour_axes_0 + u32(12) * (quantity_2 - u32(1)));
        }
        quantity_2 = quantity_2 + u32(1);
    }
    albedos_8.diffuse_reflect_0 = saturate(albedos_8.diffuse_reflect_0);
    albedos_8.diffuse_transmit_0 = saturate(albedos_8.diffuse_transmit_0);
    albedos_8.specular_reflect_0 = saturate(albedos_8.specular_reflect_0);
    albedos_8.specular_transmit_0 = saturate(albedos_8.specular_transmit_0);
    return albedos_8;
}

fn albedos_in_0( plane_8 : Plane_0,  centre_2 : vec2<f32>,  size_6 : vec2<f32>,  back_13 : bool) -> FamilyAlbedos_0
{
    var _S323 : Stretch_0 = stretch_of_0(plane_8.warp_2, centre_2.x - plane_8.start_x_0, size_6.x);
    var _S324 : Stretch_0 = stretch_of_0(plane_8.weft_2, centre_2.y - plane_8.start_y_0, size_6.y);
    var albedos_9 : FamilyAlbedos_0;
    albedos_9.warp_6 = mean_albedos_0(plane_8.warp_2, plane_8.weft_2, _S323, _S324, back_13);
    albedos_9.weft_6 = mean_albedos_0(plane_8.weft_2, plane_8.warp_2, _S324, _S323, back_13);
    return albedos_9;
}

fn rate_terms_0( direction_9 : vec3<f32>,  terms_0 : ptr<function, array<f32, i32(6)>>)
{
    var _S325 : f32 = 1.0f - direction_9.z;
    var _S326 : f32 = _S325 * _S325;
    var _S327 : f32 = direction_9.x;
    var _S328 : f32 = _S327 * _S327;
    var _S329 : f32 = direction_9.y;
    var _S330 : f32 = _S329 * _S329;
    var _S331 : f32 = _S328 - _S330;
    (*terms_0)[i32(0)] = sqrt(_S328 + _S330);
    (*terms_0)[i32(1)] = _S326;
    (*terms_0)[i32(2)] = _S326 * _S326;
    (*terms_0)[i32(3)] = _S331;
    (*terms_0)[i32(4)] = _S327 * _S329;
    (*terms_0)[i32(5)] = _S331 * _S331;
    return;
}

fn rate_of_view_0( first_6 : u32,  terms_1 : array<f32, i32(6)>) -> f32
{
    var _S332 : f32 = table_number_0(first_6);
    var term_0 : u32 = u32(0);
    var total_0 : f32 = _S332;
    for(;;)
    {
        if(term_0 < u32(6))
        {
        }
        else
        {
            break;
        }
        var total_1 : f32 = total_0 + table_number_0(first_6 + u32(1) + term_0) * terms_1[term_0];
        term_0 = term_0 + u32(1);
        total_0 = total_1;
    }
    return total_0;
}

fn rate_of_light_0( first_7 : u32,  terms_2 : array<f32, i32(6)>,  both_0 : vec2<f32>) -> f32
{
    var _S333 : u32 = first_7 + u32(8);
    var _S334 : u32 = _S333 + u32(6);
    var _S335 : f32 = table_number_0(_S334) * both_0.x + table_number_0(_S334 + u32(1)) * both_0.y;
    var term_1 : u32 = u32(0);
    var total_2 : f32 = _S335;
    for(;;)
    {
        if(term_1 < u32(6))
        {
        }
        else
        {
            break;
        }
        var total_3 : f32 = total_2 + table_number_0(_S333 + term_1) * terms_2[term_1];
        term_1 = term_1 + u32(1);
        total_2 = total_3;
    }
    return total_2;
}

fn rate_of_0( logarithm_0 : f32) -> f32
{
    return exponential_0(clamp(logarithm_0, -30.0f, 3.0f));
}

fn with_layer_0( sums_6 : Albedos_0,  albedos_10 : Albedos_0,  lit_0 : f32,  passed_0 : f32) -> Albedos_0
{
    var result_2 : Albedos_0;
    var _S336 : vec3<f32> = vec3<f32>(lit_0);
    result_2.diffuse_reflect_0 = sums_6.diffuse_reflect_0 + _S336 * albedos_10.diffuse_reflect_0;
    var _S337 : vec3<f32> = vec3<f32>(passed_0);
    result_2.diffuse_transmit_0 = sums_6.diffuse_transmit_0 + _S337 * albedos_10.diffuse_transmit_0;
    result_2.specular_reflect_0 = sums_6.specular_reflect_0 + _S336 * albedos_10.specular_reflect_0;
    result_2.specular_transmit_0 = sums_6.specular_transmit_0 + _S337 * albedos_10.specular_transmit_0;
    return result_2;
}

fn with_seen_0( sums_7 : LayerSums_0,  albedos_11 : Albedos_0,  through_0 : f32,  first_8 : u32,  share_4 : f32,  alone_0 : f32,  light_7 : vec3<f32>,  view_6 : vec3<f32>) -> LayerSums_0
{
    var of_view_0 : array<f32, i32(6)>;
    rate_terms_0(view_6, &(of_view_0));
    var _S338 : f32 = light_7.x;
    var _S339 : f32 = light_7.y;
    var _S340 : f32 = light_7.z;
    var of_light_0 : array<f32, i32(6)>;
    rate_terms_0(vec3<f32>(_S338, _S339, abs(_S340)), &(of_light_0));
    var _S341 : vec2<f32> = vec2<f32>(_S338 * view_6.x, _S339 * view_6.y);
    var _S342 : bool = _S340 < 0.0f;
    var _S343 : u32 = first_8 + u32(16) * select(u32(0), u32(1), _S342);
    var _S344 : u32 = first_8 + u32(32);
    var _S345 : f32 = share_4 * alone_0;
    var _S346 : f32 = _S345 * rate_of_0(rate_of_view_0(_S343, of_view_0) + rate_of_light_0(_S343, of_light_0, _S341));
    var _S347 : f32 = _S345 * rate_of_0(rate_of_view_0(_S344, of_view_0) + rate_of_light_0(_S344, of_light_0, _S341));
    var _S348 : f32 = share_4 * rate_of_0(rate_of_view_0(first_8 + u32(48), of_view_0));
    var _S349 : u32 = first_8 + u32(64);
    var _S350 : vec3<f32> = vec3<f32>(table_number_0(_S349), table_number_0(_S349 + u32(1)), table_number_0(_S349 + u32(2)));
    var _S351 : vec3<f32> = vec3<f32>(table_number_0(_S349 + u32(3)), table_number_0(_S349 + u32(4)), table_number_0(_S349 + u32(5)));
    var result_3 : LayerSums_0;
    result_3.albedos_4 = with_layer_0(sums_7.albedos_4, albedos_11, _S346, _S346);
    result_3.weight_3 = sums_7.weight_3 + _S346 + select(0.0f, _S347, _S342);
    var _S352 : vec3<f32> = vec3<f32>(_S348);
    result_3.behind_2.reflected_0 = sums_7.behind_2.reflected_0 + _S352 * _S351;
    result_3.behind_2.transmitted_0 = sums_7.behind_2.transmitted_0 + _S352 * _S350 * (albedos_11.diffuse_transmit_0 + vec3<f32>(through_0) * albedos_11.specular_transmit_0);
    return result_3;
}

fn divided_0( sums_8 : Albedos_0,  weight_7 : f32) -> Albedos_0
{
    var result_4 : Albedos_0;
    var _S353 : vec3<f32> = vec3<f32>((1.0f / max(weight_7, 9.99999971718068537e-10f)));
    result_4.diffuse_reflect_0 = sums_8.diffuse_reflect_0 * _S353;
    result_4.diffuse_transmit_0 = sums_8.diffuse_transmit_0 * _S353;
    result_4.specular_reflect_0 = sums_8.specular_reflect_0 * _S353;
    result_4.specular_transmit_0 = sums_8.specular_transmit_0 * _S353;
    return result_4;
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
    var _S354 : vec3<f32> = room_0 / max(albedo_1, vec3<f32>(9.99999997475242708e-07f));
    return min(gain_1, max(min(min(_S354.x, _S354.y), _S354.z), 0.0f));
}

fn flattened_0( largest_0 : f32,  albedo_2 : vec3<f32>,  room_1 : vec3<f32>) -> f32
{
    var _S355 : vec3<f32> = room_1 / max(albedo_2, vec3<f32>(9.99999997475242708e-07f)) - vec3<f32>(1.0f);
    return min(max(min(min(_S355.x, _S355.y), _S355.z), 0.0f) / max(largest_0, 9.99999997475242708e-07f), 1.0f);
}

fn fibre_gain_0( thread_11 : u32,  cell_12 : u32,  amount_1 : f32,  seed_2 : u32) -> f32
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_11, cell_12, (seed_2 ^ (u32(2654435769))))), 10.0f) - 1.0f) + 1.0f;
}

fn lerp_albedos_0( first_9 : Albedos_0,  second_1 : Albedos_0,  weight_8 : f32) -> Albedos_0
{
    var albedos_12 : Albedos_0;
    var _S356 : vec3<f32> = vec3<f32>(weight_8);
    albedos_12.diffuse_reflect_0 = mix(first_9.diffuse_reflect_0, second_1.diffuse_reflect_0, _S356);
    albedos_12.diffuse_transmit_0 = mix(first_9.diffuse_transmit_0, second_1.diffuse_transmit_0, _S356);
    albedos_12.specular_reflect_0 = mix(first_9.specular_reflect_0, second_1.specular_reflect_0, _S356);
    albedos_12.specular_transmit_0 = mix(first_9.specular_transmit_0, second_1.specular_transmit_0, _S356);
    return albedos_12;
}

fn tinted_0( albedos_13 : Albedos_0,  tint_0 : vec3<f32>) -> Albedos_0
{
    var result_5 : Albedos_0 = albedos_13;
    result_5.diffuse_reflect_0 = result_5.diffuse_reflect_0 * tint_0;
    result_5.diffuse_transmit_0 = result_5.diffuse_transmit_0 * tint_0;
    return result_5;
}

fn fourth_power_0( value_1 : f32) -> f32
{
    var _S357 : f32 = value_1 * value_1;
    return _S357 * _S357;
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
    var _S358 : vec3<f32> = vec3<f32>((1.0f - open_of_other_0)) * passed_1;
    var found_0 : FaceRadiance_0;
    var _S359 : vec3<f32> = sends_0.sky_warp_0 + _S358 * sends_0.crossing_warp_0;
    found_0.warp_8 = _S359;
    var _S360 : vec3<f32> = sends_0.sky_weft_0 + _S358 * sends_0.crossing_weft_0;
    found_0.weft_8 = _S360;
    found_0.mean_1 = vec3<f32>(sends_0.blocks_warp_0) * _S359 + vec3<f32>(sends_0.blocks_weft_0) * _S360;
    found_0.leaked_0 = from_other_0;
    return found_0;
}

fn view_terms_0( view_7 : vec3<f32>,  terms_3 : ptr<function, array<f32, i32(6)>>)
{
    var _S361 : f32 = 1.0f - view_7.z;
    var _S362 : f32 = _S361 * _S361;
    (*terms_3)[i32(0)] = 1.0f;
    var _S363 : f32 = view_7.x;
    var _S364 : f32 = _S363 * _S363;
    var _S365 : f32 = view_7.y;
    var _S366 : f32 = _S365 * _S365;
    (*terms_3)[i32(1)] = sqrt(max(_S364 + _S366, 9.999999960041972e-13f));
    (*terms_3)[i32(2)] = _S362;
    (*terms_3)[i32(3)] = _S362 * _S362;
    (*terms_3)[i32(4)] = _S364 - _S366;
    (*terms_3)[i32(5)] = 0.0f;
    return;
}

fn view_terms_1( view_8 : vec3<f32>,  terms_4 : ptr<function, array<f32, i32(6)>>)
{
    var _S367 : f32 = 1.0f - view_8.z;
    var _S368 : f32 = _S367 * _S367;
    (*terms_4)[i32(0)] = 1.0f;
    var _S369 : f32 = view_8.x;
    var _S370 : f32 = _S369 * _S369;
    var _S371 : f32 = view_8.y;
    var _S372 : f32 = _S371 * _S371;
    (*terms_4)[i32(1)] = sqrt(max(_S370 + _S372, 9.999999960041972e-13f));
    (*terms_4)[i32(2)] = _S368;
    (*terms_4)[i32(3)] = _S368 * _S368;
    (*terms_4)[i32(4)] = _S370 - _S372;
    (*terms_4)[i32(5)] = 0.0f;
    return;
}

struct Bounced_0
{
     reflected_2 : vec3<f32>,
     transmitted_2 : vec3<f32>,
     is_covered_0 : bool,
};

struct Scattered_0
{
     back_14 : vec3<f32>,
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
    var _S373 : vec3<f32> = vec3<f32>((blocked_1.by_warp_0 + blocked_1.by_weft_0)) * interior_0.leaked_1;
    var _S374 : vec3<f32> = vec3<f32>(blocked_1.far_0) * yarn_2.through_1;
    var bounced_0 : Bounced_0;
    bounced_0.reflected_2 = yarn_2.back_14 * (vec3<f32>(blocked_1.by_warp_0) * interior_0.warp_9 + vec3<f32>(blocked_1.by_weft_0) * interior_0.weft_9) + _S374 * interior_0.far_leaked_0;
    bounced_0.transmitted_2 = _S374 * interior_0.far_1 + yarn_2.back_14 * _S373;
    bounced_0.is_covered_0 = false;
    return bounced_0;
}

fn sum_of_0( first_10 : Bounced_0,  second_2 : Bounced_0) -> Bounced_0
{
    var sum_1 : Bounced_0;
    sum_1.reflected_2 = first_10.reflected_2 + second_2.reflected_2;
    sum_1.transmitted_2 = first_10.transmitted_2 + second_2.transmitted_2;
    sum_1.is_covered_0 = false;
    return sum_1;
}

fn bounced_value_0( bounced_1 : Bounced_0,  light_8 : vec3<f32>,  view_9 : vec3<f32>) -> vec3<f32>
{
    var _S375 : f32 = light_8.z;
    return select_vector_1((_S375 * view_9.z) < 0.0f, bounced_1.transmitted_2, bounced_1.reflected_2) * vec3<f32>((abs(_S375) * 0.31830987334251404f));
}

fn sheen_scale_0( x_18 : f32,  y_11 : f32) -> f32
{
    return (((((0.0f * x_18 + (((((-1.1402510404586792f * y_11 + 0.40672621130943298f) * y_11 + 1.65398800373077393f) * y_11 + -1.29730904102325439f) * y_11 + 0.30570998787879944f) * y_11 + -0.0220868494361639f)) * x_18 + (((((-0.21142719686031342f * y_11 + 1.05947399139404297f) * y_11 + -0.41116121411323547f) * y_11 + -0.93859231472015381f) * y_11 + 0.51606941223144531f) * y_11 + 0.05409301072359085f)) * x_18 + (((((1.22944498062133789f * y_11 + -0.45962560176849365f) * y_11 + -1.63861405849456787f) * y_11 + 1.33565104007720947f) * y_11 + -0.45725581049919128f) * y_11 + 0.08243165910243988f)) * x_18 + (((((0.39779931306838989f * y_11 + -1.18879103660583496f) * y_11 + 0.28251591324806213f) * y_11 + 1.168984055519104f) * y_11 + -0.76864629983901978f) * y_11 + 0.0091691892594099f)) * x_18 + (((((-0.26563560962677002f * y_11 + -0.19379159808158875f) * y_11 + 0.2677634060382843f) * y_11 + 0.00270519289188087f) * y_11 + 0.14349560439586639f) * y_11 + 0.10290180146694183f)) * x_18 + (((((-0.20701569318771362f * y_11 + 0.24526430666446686f) * y_11 + 0.19551840424537659f) * y_11 + 0.07586126774549484f) * y_11 + 0.38894739747047424f) * y_11 + 0.15043120086193085f);
}

fn sheen_shear_0( x_19 : f32,  y_12 : f32) -> f32
{
    return ((((0.0f * x_19 + (((((-0.10608240216970444f * y_12 + 1.99214303493499756f) * y_12 + -1.42255294322967529f) * y_12 + -1.09495604038238525f) * y_12 + 0.59180057048797607f) * y_12 + 0.06902855634689331f)) * x_19 + (((((-0.46220690011978149f * y_12 + -0.29113379120826721f) * y_12 + 1.39025199413299561f) * y_12 + 0.35589990019798279f) * y_12 + -1.17120099067687988f) * y_12 + 0.15940259397029877f)) * x_19 + (((((2.26068711280822754f * y_12 + -3.64728999137878418f) * y_12 + -0.72173482179641724f) * y_12 + 3.07659196853637695f) * y_12 + -0.6827620267868042f) * y_12 + -0.3039557933807373f)) * x_19 + (((((0.81201767921447754f * y_12 + 0.36014080047607422f) * y_12 + -1.72646903991699219f) * y_12 + -0.22630110383033752f) * y_12 + 0.89514690637588501f) * y_12 + -0.10397960245609283f)) * x_19 + (((((-0.37648698687553406f * y_12 + 1.10974001884460449f) * y_12 + 0.17824520170688629f) * y_12 + -1.04968702793121338f) * y_12 + 0.1461234986782074f) * y_12 + -0.00475129019469023f);
}

fn sheen_reflectance_0( x_20 : f32,  y_13 : f32) -> f32
{
    return ((((0.0f * x_20 + (((((12.95646953582763672f * y_13 + -21.38032913208007812f) * y_13 + -7.37853097915649414f) * y_13 + 34.55607986450195312f) * y_13 + -23.61347007751464844f) * y_13 + 5.00126314163208008f)) * x_20 + (((((10.91487026214599609f * y_13 + -6.08202791213989258f) * y_13 + -38.2036285400390625f) * y_13 + 53.3440399169921875f) * y_13 + -21.91996002197265625f) * y_13 + 2.01606011390686035f)) * x_20 + (((((-14.52206039428710938f * y_13 + 36.803619384765625f) * y_13 + -22.94047927856445312f) * y_13 + -10.07973003387451172f) * y_13 + 15.77003955841064453f) * y_13 + -4.92722177505493164f)) * x_20 + (((((-7.62505722045898438f * y_13 + 1.27310299873352051f) * y_13 + 31.19523048400878906f) * y_13 + -44.39989852905273438f) * y_13 + 26.44947052001953125f) * y_13 + -8.73507976531982422f)) * x_20 + (((((5.65633487701416016f * y_13 + -17.66820907592773438f) * y_13 + 24.65356063842773438f) * y_13 + -19.38941001892089844f) * y_13 + 11.06159019470214844f) * y_13 + -3.06573700904846191f);
}

fn sheen_lobe_0( cos_view_0 : f32,  roughness_10 : f32) -> vec3<f32>
{
    var _S376 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S377 : f32 = 2.0f * sqrt(_S376) - 1.0f;
    var _S378 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_10, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S377, _S378), 0.00999999977648258f, 1.0f), clamp((1.0f - _S376) * sheen_shear_0(_S377, _S378), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S377, _S378), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_9 : vec3<f32>,  view_10 : vec3<f32>,  scale_0 : f32,  shear_0 : f32) -> f32
{
    var _S379 : f32 = light_9.z;
    if(((_S379 <= 0.0f) | (((view_10.z) <= 0.0f))))
    {
        return 0.0f;
    }
    var _S380 : vec2<f32> = view_10.xy;
    var _S381 : f32 = dot(_S380, _S380);
    var _S382 : vec2<f32> = select_vector_0(_S381 > 9.99999968265522539e-21f, _S380 * vec2<f32>(rsqrt_0(max(_S381, 9.99999968265522539e-21f))), vec2<f32>(1.0f, 0.0f));
    var _S383 : f32 = scale_0 * dot(light_9.xy, _S382) + shear_0 * _S379;
    var _S384 : f32 = scale_0 * (light_9.y * _S382.x - light_9.x * _S382.y);
    var _S385 : f32 = _S383 * _S383 + _S384 * _S384 + _S379 * _S379;
    return 0.31830987334251404f * scale_0 * scale_0 * _S379 / max(_S385 * _S385, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_10 : vec3<f32>,  view_11 : vec3<f32>,  strength_0 : f32,  roughness_11 : f32) -> vec2<f32>
{
    var _S386 : vec3<f32> = sheen_lobe_0(view_11.z, roughness_11);
    var _S387 : f32 = strength_0 * _S386.z;
    return vec2<f32>(_S387 * transformed_cosine_0(light_10, view_11, _S386.x, _S386.y), 1.0f - _S387);
}

fn accumulate_0( index_7 : u32,  light_11 : vec4<f32>)
{
    var _S388 : f32 = layers_0[index_7].share_0;
    radiance_0[index_7] = radiance_0[index_7] + vec4<f32>(layers_0[index_7].share_0) * light_11;
    layers_0[index_7].share_0 = _S388 * (1.0f - light_11.w);
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

fn uneven_shift_0( _S389 : u32,  _S390 : u32,  _S391 : u32,  _S392 : vec2<f32>) -> f32
{
    var _S393 : f32 = families_0[_S391].period_0 / families_0[_S391].count_0;
    var _S394 : u32 = hash_key_0(_S390, ((fabrics_0[_S389].seed_0) ^ (u32(625341585))));
    var _S395 : vec2<f32> = vec2<f32>(_S392.x, _S392.y / 4.0f) / vec2<f32>(_S393);
    return 0.20000000298023224f * sqrt(families_0[_S391].slub_0) * _S393 * (uneven_octave_0(_S394, _S395) * 0.66666668653488159f + uneven_octave_0(_S394 + u32(1), vec2<f32>(2.0f) * _S395 + vec2<f32>(0.5f, 0.0f)) / 3.0f);
}

fn uneven_place_0( _S396 : u32,  _S397 : vec2<f32>) -> vec2<f32>
{
    return select_vector_0((fabrics_0[_S396].has_detail_0) == u32(0), _S397, _S397 + vec2<f32>(uneven_shift_0(_S396, u32(0), fabrics_0[_S396].warp_0, _S397), uneven_shift_0(_S396, u32(1), fabrics_0[_S396].weft_0, _S397.yx)));
}

fn face_point_0( _S398 : u32,  _S399 : u32,  _S400 : f32,  _S401 : f32) -> VisiblePoint_0
{
    var _S402 : u32 = u32(3) * _S399;
    var _S403 : Vertex_0 = vertex_at_0(_S402);
    var _S404 : Vertex_0 = vertex_at_0(_S402 + u32(1));
    var _S405 : Vertex_0 = vertex_at_0(_S402 + u32(2));
    var _S406 : vec3<f32> = position_of_0(_S403);
    var _S407 : vec3<f32> = position_of_0(_S404) - _S406;
    var _S408 : vec3<f32> = position_of_0(_S405) - _S406;
    var _S409 : f32 = _S404.u_0 - _S403.u_0;
    var _S410 : f32 = _S404.v_0 - _S403.v_0;
    var _S411 : vec2<f32> = vec2<f32>(_S409, _S410);
    var _S412 : f32 = _S405.u_0 - _S403.u_0;
    var _S413 : f32 = _S405.v_0 - _S403.v_0;
    var _S414 : vec2<f32> = vec2<f32>(_S412, _S413);
    var _S415 : vec3<f32> = vec3<f32>(select(1.0f, -1.0f, (_S409 * _S413 - _S410 * _S412) < 0.0f));
    var _S416 : vec3<f32> = _S415 * (vec3<f32>(_S413) * _S407 - vec3<f32>(_S410) * _S408);
    var _S417 : vec3<f32> = _S415 * (vec3<f32>(_S409) * _S408 - vec3<f32>(_S412) * _S407);
    var point_2 : VisiblePoint_0;
    var _S418 : vec3<f32> = vec3<f32>(_S400);
    var _S419 : vec3<f32> = vec3<f32>(_S401);
    var _S420 : vec3<f32> = normalize(vec3<f32>((1.0f - _S400 - _S401)) * normal_of_0(_S403) + _S418 * normal_of_0(_S404) + _S419 * normal_of_0(_S405));
    point_2.normal_0 = _S420;
    var _S421 : vec3<f32> = normalize(_S416 - _S420 * vec3<f32>(dot(_S420, _S416)));
    point_2.axis_x_0 = _S421;
    point_2.axis_y_0 = cross(_S420, _S421);
    var _S422 : vec3<f32> = normalize(cross(_S407, _S408));
    point_2.face_normal_0 = select_vector_1((dot(_S422, _S420)) < 0.0f, (vec3<f32>(0) - _S422), _S422);
    point_2.position_4 = _S406 + _S418 * _S407 + _S419 * _S408;
    point_2.view_0 = _S420;
    var _S423 : vec2<f32> = vec2<f32>(_S403.u_0, _S403.v_0) + vec2<f32>(_S400) * _S411 + vec2<f32>(_S401) * _S414;
    point_2.uv_1 = _S423;
    var _S424 : bool = (dot(cross(_S416, _S417), _S420)) < 0.0f;
    var _S425 : vec2<f32> = vec2<f32>(fabrics_0[_S398].uv_width_0, select(fabrics_0[_S398].uv_height_0, - fabrics_0[_S398].uv_height_0, _S424));
    point_2.draft_per_uv_0 = _S425;
    point_2.draft_0 = uneven_place_0(_S398, _S423 * _S425 + vec2<f32>(0.0f, select(0.0f, fabrics_0[_S398].uv_height_0, _S424)));
    var _S426 : vec2<f32> = vec2<f32>(0.0f);
    point_2.draft_dx_0 = _S426;
    point_2.draft_dy_0 = _S426;
    return point_2;
}

fn visible_point_0( _S427 : u32,  _S428 : u32,  _S429 : vec2<u32>) -> VisiblePoint_0
{
    var _S430 : u32 = u32(3) * _S428;
    var _S431 : Vertex_0 = vertex_at_0(_S430);
    var _S432 : Vertex_0 = vertex_at_0(_S430 + u32(1));
    var _S433 : Vertex_0 = vertex_at_0(_S430 + u32(2));
    var _S434 : vec3<f32> = position_of_0(_S431);
    var _S435 : vec3<f32> = position_of_0(_S432) - _S434;
    var _S436 : vec3<f32> = position_of_0(_S433) - _S434;
    var _S437 : vec3<f32> = cross(_S435, _S436);
    var _S438 : f32 = f32(frame_record_0.width_0);
    var _S439 : vec3<f32> = camera_right_0() * vec3<f32>((2.0f / _S438));
    var _S440 : f32 = f32(frame_record_0.height_0);
    var _S441 : vec3<f32> = camera_up_0() * vec3<f32>((-2.0f / _S440));
    var _S442 : vec3<f32> = camera_forward_0() + vec3<f32>((f32(_S429.x) + 0.5f - 0.5f * _S438)) * _S439 + vec3<f32>((f32(_S429.y) + 0.5f - 0.5f * _S440)) * _S441;
    var _S443 : f32 = dot(_S442, _S437);
    var _S444 : f32 = 1.0f / select(1.00000000317107685e-30f, _S443, (abs(_S443)) > 1.00000000317107685e-30f);
    var _S445 : vec3<f32> = _S434 - camera_origin_0();
    var _S446 : vec3<f32> = vec3<f32>((dot(_S445, _S437) * _S444));
    var _S447 : vec3<f32> = _S442 * _S446 - _S445;
    var _S448 : vec3<f32> = _S446 * (_S439 - _S442 * vec3<f32>((dot(_S439, _S437) * _S444)));
    var _S449 : vec3<f32> = _S446 * (_S441 - _S442 * vec3<f32>((dot(_S441, _S437) * _S444)));
    var _S450 : vec3<f32> = vec3<f32>((1.0f / max(square_0(_S437), 1.00000000317107685e-30f)));
    var _S451 : vec3<f32> = cross(_S436, _S437) * _S450;
    var _S452 : vec3<f32> = cross(_S437, _S435) * _S450;
    var _S453 : vec2<f32> = vec2<f32>(_S432.u_0 - _S431.u_0, _S432.v_0 - _S431.v_0);
    var _S454 : vec2<f32> = vec2<f32>(_S433.u_0 - _S431.u_0, _S433.v_0 - _S431.v_0);
    var point_3 : VisiblePoint_0 = face_point_0(_S427, _S428, dot(_S447, _S451), dot(_S447, _S452));
    point_3.position_4 = _S434 + _S447;
    point_3.view_0 = (vec3<f32>(0) - normalize(_S442));
    point_3.draft_dx_0 = (vec2<f32>(dot(_S448, _S451)) * _S453 + vec2<f32>(dot(_S448, _S452)) * _S454) * point_3.draft_per_uv_0;
    point_3.draft_dy_0 = (vec2<f32>(dot(_S449, _S451)) * _S453 + vec2<f32>(dot(_S449, _S452)) * _S454) * point_3.draft_per_uv_0;
    return point_3;
}

fn filtered_albedo_0( _S455 : u32,  _S456 : VisiblePoint_0) -> vec3<f32>
{
    var _S457 : u32 = fabrics_0[_S455].albedo_map_levels_0;
    if((fabrics_0[_S455].albedo_map_levels_0) == u32(0))
    {
        return vec3<f32>(1.0f);
    }
    var _S458 : vec2<f32> = vec2<f32>(fabrics_0[_S455].uv_width_0, fabrics_0[_S455].uv_height_0);
    var _S459 : vec2<f32> = _S456.draft_dx_0 / _S458;
    var _S460 : vec2<f32> = _S456.draft_dy_0 / _S458;
    var _S461 : u32 = _S457 - u32(1);
    var _S462 : u32 = (u32(1) << (_S461));
    var _S463 : f32 = clamp(0.5f * binary_logarithm_0(max(abs(_S459.x * _S460.y - _S459.y * _S460.x), 9.99999968265522539e-21f) * (square_1(f32(_S462)) / 3.0f)), 0.0f, f32(_S457) - 1.0f);
    var _S464 : u32 = min(u32(_S463), max(_S457, u32(2)) - u32(2));
    var _S465 : u32 = min(_S464 + u32(1), _S461);
    var _S466 : u32 = (u32(1) << ((u32(2) * _S457)));
    return mix(map_level_0(fabrics_0[_S455].albedo_map_0 + (_S466 - ((_S466 >> ((u32(2) * _S464))))) / u32(3), (_S462 >> (_S464)), _S456.uv_1), map_level_0(fabrics_0[_S455].albedo_map_0 + (_S466 - ((_S466 >> ((u32(2) * _S465))))) / u32(3), (_S462 >> (_S465)), _S456.uv_1), vec3<f32>(((exponential_0(1.38629436492919922f * (_S463 - f32(_S464))) - 1.0f) / 3.0f)));
}

fn is_layered_0( _S467 : u32) -> bool
{
    return (HAS_LAYERS_0 & (((fabrics_0[_S467].planes_0) != u32(0))));
}

fn irregular_key_0( _S468 : u32,  _S469 : u32) -> u32
{
    return hash_key_0(_S469, ((fabrics_0[_S468].seed_0) ^ (u32(1821285621))));
}

fn irregular_place_0( _S470 : u32,  _S471 : vec2<f32>,  _S472 : f32) -> vec2<f32>
{
    var _S473 : u32 = fabrics_0[_S470].warp_0;
    var _S474 : u32 = fabrics_0[_S470].weft_0;
    var _S475 : bool = (((((fabrics_0[_S470].is_irregular_0) != u32(0)) & ((!is_layered_0(_S470))))) & (((max(moved_share_0(fabrics_0[_S470].warp_0, _S472), moved_share_0(fabrics_0[_S470].weft_0, _S472))) > 0.0f)));
    var number_4 : u32 = u32(0);
    var moved_0 : vec2<f32> = _S471;
    for(;;)
    {
        if(number_4 < select(u32(0), u32(2), _S475))
        {
        }
        else
        {
            break;
        }
        var _S476 : bool = number_4 == u32(0);
        var _S477 : u32 = select(_S474, _S473, _S476);
        var _S478 : vec2<f32> = select_vector_0(_S476, _S471, _S471.yx);
        var _S479 : u32 = irregular_key_0(_S470, number_4);
        var _S480 : f32 = _S478.x;
        var _S481 : Cell_0 = locate_0(_S477, _S480);
        var _S482 : f32 = irregular_thread_0(_S477, _S480, _S481);
        var _S483 : f32 = select(1.0f, -1.0f, (_S481.across_0) < 0.0f);
        var _S484 : vec2<f32> = vec2<f32>(0.0f);
        var other_3 : vec2<f32> = _S484;
        var own_2 : vec2<f32> = _S484;
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
            var _S485 : vec2<f32> = irregular_at_0(_S477, _S479, _S482 + _S483 * f32(neighbour_0), _S478.y).xy;
            var _S486 : u32 = neighbour_0 + u32(1);
            own_2 = other_3;
            other_3 = _S485;
            neighbour_0 = _S486;
        }
        var _S487 : f32 = _S481.below_0 + _S481.above_0;
        var _S488 : f32 = min(_S481.half_width_1 / _S487, 0.5f);
        var _S489 : f32 = min(_S488 * (2.0f + own_2.y + other_3.y), 1.0f);
        var _S490 : vec2<f32> = sqrt(max(vec2<f32>(1.0f) + vec2<f32>(own_2.x, other_3.x), vec2<f32>(0.25f)));
        var _S491 : f32 = _S490.x;
        var _S492 : f32 = _S489 * _S491 / (_S491 + _S490.y);
        var _S493 : f32 = abs(_S481.across_0) / _S487;
        var _S494 : f32 = 1.0f - _S489;
        var _S495 : f32 = _S493 - _S492;
        var _S496 : f32 = moved_share_0(_S477, _S472) * _S483 * _S487 * (select(select((_S495 - _S494) / max(_S489 - _S492, 9.99999997475242708e-07f) * _S488 + (1.0f - _S488), _S495 / max(_S494, 9.99999997475242708e-07f) * (1.0f - 2.0f * _S488) + _S488, _S495 < _S494), _S493 * _S488 / _S492, _S495 < 0.0f) - _S493);
        var moved_1 : vec2<f32> = moved_0 + select_vector_0(_S476, vec2<f32>(_S496, 0.0f), vec2<f32>(0.0f, _S496));
        number_4 = number_4 + u32(1);
        moved_0 = moved_1;
    }
    return moved_0;
}

fn light_sample_count_0() -> u32
{
    return frame_record_0.lights_0 + frame_record_0.environment_samples_0;
}

fn visibility_at_0( _S497 : u32,  _S498 : vec2<u32>) -> f32
{
    if((frame_record_0.casts_shadows_0) == u32(0))
    {
        return 1.0f;
    }
    return visibilities_0[(_S497 * frame_record_0.height_0 + _S498.y) * frame_record_0.width_0 + _S498.x];
}

struct LightSample_0
{
     towards_0 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_1 : f32,
};

fn environment_texel_0( _S499 : u32,  _S500 : u32) -> vec3<f32>
{
    var _S501 : u32 = frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + frame_record_0.environment_rows_0 * (frame_record_0.environment_columns_0 + u32(1)) + u32(3) * (_S499 * frame_record_0.environment_columns_0 + _S500);
    return vec3<f32>(scene_number_0(_S501), scene_number_0(_S501 + u32(1)), scene_number_0(_S501 + u32(2)));
}

fn sample_environment_0( _S502 : vec2<f32>,  _S503 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S504 : u32 = frame_record_0.environment_rows_0;
    var _S505 : Choice_0 = choose_0(frame_record_0.environment_table_0, frame_record_0.environment_rows_0, _S502.y);
    var _S506 : u32 = frame_record_0.environment_columns_0;
    var _S507 : Choice_0 = choose_0(frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + _S505.index_5 * (frame_record_0.environment_columns_0 + u32(1)), frame_record_0.environment_columns_0, _S502.x);
    var _S508 : vec3<f32> = environment_texel_0(_S505.index_5, _S507.index_5);
    (*_S503) = _S508 * vec3<f32>((frame_record_0.environment_total_0 / max(mean_0(_S508), 9.99999968265522539e-21f)));
    var _S509 : f32 = 3.14159274101257324f / f32(_S504);
    var _S510 : f32 = mix(sine_cosine_0(f32(_S505.index_5) * _S509).y, sine_cosine_0(f32(_S505.index_5 + u32(1)) * _S509).y, _S505.remainder_0);
    var _S511 : f32 = sqrt(max(1.0f - _S510 * _S510, 0.0f));
    var _S512 : vec2<f32> = sine_cosine_0((f32(_S507.index_5) + _S507.remainder_0) * (6.28318548202514648f / f32(_S506)));
    var _S513 : f32 = _S511 * _S512.x;
    var _S514 : f32 = - _S511 * _S512.y;
    return vec3<f32>(frame_record_0.environment_cosine_0 * _S513 + frame_record_0.environment_sine_0 * _S514, _S510, frame_record_0.environment_cosine_0 * _S514 - frame_record_0.environment_sine_0 * _S513);
}

fn light_sample_0( _S515 : u32,  _S516 : vec2<u32>,  _S517 : vec3<f32>) -> LightSample_0
{
    var sample_1 : LightSample_0;
    sample_1.distance_1 = 1.00000001504746622e+30f;
    var _S518 : u32 = frame_record_0.lights_0;
    if(_S515 >= (frame_record_0.lights_0))
    {
        var weight_9 : vec3<f32>;
        var _S519 : vec3<f32> = sample_environment_0(pixel_sequence_0(_S516, frame_record_0.pass_number_0 * frame_record_0.environment_samples_0 + (_S515 - _S518), u32(3)), &(weight_9));
        sample_1.towards_0 = _S519;
        sample_1.irradiance_1 = weight_9 / vec3<f32>(f32(frame_record_0.environment_samples_0));
        return sample_1;
    }
    var _S520 : Light_0 = scene_light_0(frame_record_0.light_records_0 + u32(7) * _S515);
    sample_1.irradiance_1 = vec3<f32>(_S520.red_0, _S520.green_0, _S520.blue_0);
    sample_1.towards_0 = vec3<f32>(_S520.x_7, _S520.y_1, _S520.z_1);
    if((_S520.is_point_0) != u32(0))
    {
        var _S521 : vec3<f32> = sample_1.towards_0 - _S517;
        var _S522 : f32 = max(square_0(_S521), 9.999999960041972e-13f);
        sample_1.distance_1 = sqrt(_S522);
        sample_1.irradiance_1 = sample_1.irradiance_1 / vec3<f32>(_S522);
        sample_1.towards_0 = normalize(_S521);
    }
    return sample_1;
}

struct Estimate_0
{
     components_0 : Components_0,
     close_0 : CloseUp_0,
     albedos_14 : FamilyAlbedos_0,
     behind_4 : LayersBehind_0,
};

struct Regime_0
{
     prefiltered_0 : f32,
     threads_2 : f32,
     points_0 : f32,
};

fn regime_of_0( _S523 : u32,  _S524 : Footprint_0,  _S525 : f32) -> Regime_0
{
    var _S526 : f32 = Footprint_spread_side_0(_S524);
    var _S527 : f32 = clamp((binary_logarithm_0(max(_S526, 9.99999971718068537e-10f)) - fabrics_0[_S523].lobes_0.unit_level_0 - -0.51457315683364868f) / 1.51457309722900391f, 0.0f, 1.0f);
    var regime_0 : Regime_0;
    var _S528 : f32 = _S527 * _S527 * (3.0f - 2.0f * _S527);
    regime_0.prefiltered_0 = _S528;
    var _S529 : f32 = _S526 * fabrics_0[_S523].lobes_0.threads_per_mm_0;
    regime_0.threads_2 = _S529;
    regime_0.points_0 = select(0.0f, clamp(_S529 * 12.0f, 1.0f, max(mix(8.0f, 4.0f, _S528) / _S525, 1.0f)), _S528 < 1.0f);
    return regime_0;
}

fn varies_at_0( _S530 : u32,  _S531 : f32) -> bool
{
    return (((((fabrics_0[_S530].fibre_noise_0) > 0.0f) | (((fabrics_0[_S530].colour_noise_0) > 0.0f)))) | (((((fabrics_0[_S530].has_detail_0) != u32(0)) & ((_S531 >= 0.0f))))));
}

struct Hit_0
{
     x_21 : f32,
     y_14 : f32,
     hole_7 : bool,
     height_9 : f32,
};

fn whole_plane_0( _S532 : u32) -> Plane_0
{
    var plane_9 : Plane_0;
    plane_9.warp_2 = fabrics_0[_S532].warp_0;
    plane_9.weft_2 = fabrics_0[_S532].weft_0;
    plane_9.run_words_1 = fabrics_0[_S532].run_words_0;
    plane_9.ends_2 = fabrics_0[_S532].ends_1;
    plane_9.end_numbers_0 = u32(0);
    plane_9.pick_numbers_0 = u32(0);
    plane_9.max_heights_1 = fabrics_0[_S532].max_heights_0;
    plane_9.max_height_columns_1 = fabrics_0[_S532].max_height_columns_0;
    plane_9.height_low_1 = fabrics_0[_S532].height_low_0;
    plane_9.height_high_1 = fabrics_0[_S532].height_high_0;
    plane_9.front_level_0 = 0.0f;
    plane_9.back_level_0 = 0.0f;
    plane_9.start_x_0 = 0.0f;
    plane_9.start_y_0 = 0.0f;
    plane_9.fine_x_0 = 0.0f;
    plane_9.fine_y_0 = 0.0f;
    return plane_9;
}

fn plane_order_0( _S533 : u32,  _S534 : f32,  _S535 : f32,  _S536 : bool) -> u32
{
    var _S537 : u32 = select(u32(0), locate_varied_0(fabrics_0[_S533].plane_axes_0 + u32(1), _S535).thread_1 * fabrics_0[_S533].ends_1 + locate_varied_0(fabrics_0[_S533].plane_axes_0, _S534).thread_1, (fabrics_0[_S533].stacks_0) > u32(1));
    return fabrics_0[_S533].plane_orders_0 + u32(2) * fabrics_0[_S533].planes_0 * (u32(2) * ((((words_0[fabrics_0[_S533].regions_0 + _S537 / u32(4)] >> ((u32(8) * (_S537 % u32(4)))))) & (u32(255)))) + select(u32(0), u32(1), _S536));
}

fn first_bounds_0( _S538 : u32,  _S539 : u32,  _S540 : f32,  _S541 : f32,  _S542 : bool,  _S543 : bool,  _S544 : bool) -> vec3<f32>
{
    var _S545 : vec3<f32> = bounds_in_0(plane_at_0(fabrics_0[_S538].plane_records_0 + words_0[_S539] * u32(16)), _S540, _S541, _S542, _S543, _S544);
    var _S546 : Cell_0 = locate_varied_0(fabrics_0[_S538].plane_axes_0, _S540);
    var _S547 : Cell_0 = locate_varied_0(fabrics_0[_S538].plane_axes_0 + u32(1), _S541);
    var _S548 : bool = (fabrics_0[_S538].stacks_0) == u32(1);
    return vec3<f32>(_S545.x + table_number_0(_S539 + u32(1)), min(_S545.y, select(select(_S546.below_0, _S546.above_0, _S543), 1.0e+06f, _S548)), min(_S545.z, select(select(_S547.below_0, _S547.above_0, _S544), 1.0e+06f, _S548)));
}

fn plane_shown_0( _S549 : u32,  _S550 : f32,  _S551 : f32,  _S552 : bool,  _S553 : bool,  _S554 : bool) -> PlaneHere_0
{
    var here_6 : PlaneHere_0;
    here_6.plane_5 = whole_plane_0(_S549);
    here_6.number_2 = u32(0);
    here_6.level_1 = 0.0f;
    here_6.edge_x_0 = 1.0e+06f;
    here_6.edge_y_0 = 1.0e+06f;
    here_6.bounds_0 = vec3<f32>(0.0f);
    if(!is_layered_0(_S549))
    {
        return here_6;
    }
    var _S555 : u32 = plane_order_0(_S549, _S550, _S551, _S552);
    var _S556 : vec3<f32> = first_bounds_0(_S549, _S555, _S550, _S551, _S552, _S553, _S554);
    here_6.bounds_0 = _S556;
    var _S557 : bool = (fabrics_0[_S549].stacks_0) == u32(1);
    here_6.edge_x_0 = select(_S556.y, 1.0e+06f, _S557);
    here_6.edge_y_0 = select(_S556.z, 1.0e+06f, _S557);
    var is_hole_0 : bool = true;
    var rank_1 : u32 = u32(0);
    for(;;)
    {
        if(((rank_1 < (fabrics_0[_S549].planes_0)) & (is_hole_0)))
        {
        }
        else
        {
            break;
        }
        var _S558 : u32 = _S555 + u32(2) * rank_1;
        var _S559 : u32 = words_0[_S558];
        here_6.number_2 = _S559;
        here_6.level_1 = table_number_0(_S558 + u32(1));
        here_6.plane_5 = plane_at_0(fabrics_0[_S549].plane_records_0 + _S559 * u32(16));
        var _S560 : Cell_0 = locate_varied_0(here_6.plane_5.warp_2, _S550 - here_6.plane_5.start_x_0);
        var _S561 : Cell_0 = locate_varied_0(here_6.plane_5.weft_2, _S551 - here_6.plane_5.start_y_0);
        var is_hole_1 : bool = !((((abs(_S560.across_0)) < (_S560.half_width_1)) | (((abs(_S561.across_0)) < (_S561.half_width_1)))));
        here_6.edge_x_0 = min(here_6.edge_x_0, select(1.0e+06f, hole_edge_0(_S560, _S553), is_hole_1));
        here_6.edge_y_0 = min(here_6.edge_y_0, select(1.0e+06f, hole_edge_0(_S561, _S554), is_hole_1));
        var _S562 : u32 = rank_1 + u32(1);
        is_hole_0 = is_hole_1;
        rank_1 = _S562;
    }
    return here_6;
}

fn sample_at_0( _S563 : u32,  _S564 : f32,  _S565 : f32,  _S566 : bool) -> Sample_0
{
    return sample_in_0(plane_shown_0(_S563, _S564, _S565, _S566, true, true), _S564, _S565, _S566);
}

fn steps_per_length_0( _S567 : u32,  _S568 : SearchQuality_0,  _S569 : vec3<f32>) -> f32
{
    return max(max(abs(_S569.x) * fabrics_0[_S567].threads_per_x_0, abs(_S569.y) * fabrics_0[_S567].threads_per_y_0) * _S568.steps_per_thread_0, abs(_S569.z) * fabrics_0[_S567].per_relief_0 * _S568.steps_per_relief_0);
}

fn plane_count_0( _S570 : u32) -> u32
{
    return select(u32(1), fabrics_0[_S570].planes_0, is_layered_0(_S570));
}

fn probe_0( _S571 : u32,  _S572 : f32,  _S573 : f32,  _S574 : bool,  _S575 : bool,  _S576 : bool) -> Probe_0
{
    var _S577 : PlaneHere_0 = plane_shown_0(_S571, _S572, _S573, _S574, _S575, _S576);
    var _S578 : Sample_0 = sample_in_0(_S577, _S572, _S573, _S574);
    var probe_1 : Probe_0;
    probe_1.height_5 = _S578.height_4;
    probe_1.hole_4 = _S578.shown_2.hole_3;
    probe_1.slope_x_1 = _S578.slope_x_0;
    probe_1.slope_y_1 = _S578.slope_y_0;
    var _S579 : bool = !is_layered_0(_S571);
    probe_1.yarn_1 = select(_S578.crossing_3.weft_3.thread_1 * u32(2), _S578.crossing_3.warp_3.thread_1 * u32(2) + u32(1), _S578.shown_2.is_warp_2) * plane_count_0(_S571) + _S577.number_2;
    probe_1.cell_max_0 = select(_S577.bounds_0.x, cell_maximum_0(_S577.plane_5, _S578.crossing_3), _S579);
    probe_1.side_x_0 = select(_S577.bounds_0.y, select(_S578.crossing_3.warp_3.below_0, _S578.crossing_3.warp_3.above_0, _S575), _S579);
    probe_1.side_y_0 = select(_S577.bounds_0.z, select(_S578.crossing_3.weft_3.below_0, _S578.crossing_3.weft_3.above_0, _S576), _S579);
    probe_1.edge_x_1 = min(_S577.edge_x_0, outline_distance_0(_S578.crossing_3.warp_3, _S578.shown_2, _S578.run_2, !_S578.shown_2.is_warp_2, _S575));
    probe_1.edge_y_1 = min(_S577.edge_y_0, outline_distance_0(_S578.crossing_3.weft_3, _S578.shown_2, _S578.run_2, _S578.shown_2.is_warp_2, _S576));
    return probe_1;
}

fn is_free_0( _S580 : u32,  _S581 : SearchQuality_0,  _S582 : vec3<f32>,  _S583 : vec3<f32>,  _S584 : bool,  _S585 : f32) -> bool
{
    var _S586 : f32 = _S583.z;
    if(_S586 <= 0.0f)
    {
        return false;
    }
    var _S587 : f32 = 1.0f / max(_S581.shadow_share_0 * steps_per_length_0(_S580, _S581, _S583), 9.99999971718068537e-10f);
    var _S588 : StepControl_0 = step_control_0(_S583.xy, _S587);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_4 : u32 = u32(0);
    var distance_2 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        if(((count_4 < u32(1024)) & (((_S582.z + _S586 * distance_2) < _S585))))
        {
        }
        else
        {
            break;
        }
        var _S589 : vec3<f32> = _S582 + _S583 * vec3<f32>(distance_2);
        var _S590 : Probe_0 = probe_0(_S580, _S589.x, _S589.y, _S584, _S588.right_1, _S588.up_1);
        var _S591 : f32 = _S589.z;
        var _S592 : f32 = _S591 - _S590.height_5;
        var _S593 : f32 = _S586 - _S590.slope_x_1 * _S583.x - _S590.slope_y_1 * _S583.y;
        if(((!_S590.hole_4) & ((_S592 < 0.0f))))
        {
            return false;
        }
        var _S594 : f32 = way_back_to_dip_0(previous_3, _S592, _S593, last_step_0, _S590);
        if(_S594 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S594;
            distance_2 = distance_2 - _S594;
            last_step_0 = last_step_1;
            count_4 = count_4 + u32(1);
            continue;
        }
        var _S595 : bool = _S591 > (_S590.cell_max_0);
        var last_step_2 : f32 = select(StepControl_to_next_sample_0(_S588, _S590, _S592, _S593), max(StepControl_to_cell_exit_0(_S588, _S590.side_x_0, _S590.side_y_0), _S587), _S595);
        var distance_3 : f32 = distance_2 + last_step_2;
        previous_3 = after_sample_0(_S592, _S593, _S590, _S595);
        distance_2 = distance_3;
        last_step_0 = last_step_2;
        count_4 = count_4 + u32(1);
    }
    return true;
}

fn passes_through_0( _S596 : u32,  _S597 : SearchQuality_0,  _S598 : f32,  _S599 : f32,  _S600 : vec3<f32>,  _S601 : bool) -> bool
{
    if(!sample_at_0(_S596, _S598, _S599, _S601).shown_2.hole_3)
    {
        return false;
    }
    var _S602 : vec3<f32> = vec3<f32>(_S598, _S599, 0.0f);
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
        var _S603 : bool = is_free_0(_S596, _S597, _S602, select_vector_1(side_2 == u32(0), _S600, vec3<f32>(- _S600.x, - _S600.y, _S600.z)), _S601 != (side_2 == u32(1)), fabrics_0[_S596].height_high_0);
        var _S604 : u32 = side_2 + u32(1);
        passes_0 = _S603;
        side_2 = _S604;
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

fn plane_of_0( _S605 : u32,  _S606 : u32) -> Plane_0
{
    if(!is_layered_0(_S605))
    {
        return whole_plane_0(_S605);
    }
    return plane_at_0(fabrics_0[_S605].plane_records_0 + _S606 * u32(16));
}

fn max_height_along_0( _S607 : u32,  _S608 : f32,  _S609 : f32,  _S610 : f32,  _S611 : vec3<f32>,  _S612 : bool) -> f32
{
    var _S613 : f32 = _S611.x;
    var _S614 : f32 = _S611.y;
    var _S615 : u32 = select(u32(0), u32(1), _S613 > 0.0f) + select(u32(0), u32(2), _S614 > 0.0f);
    var _S616 : f32 = max(abs(_S613) * fabrics_0[_S607].threads_per_x_0, abs(_S614) * fabrics_0[_S607].threads_per_y_0) / _S611.z;
    var levels_4 : vec4<f32> = vec4<f32>(-1.00000001504746622e+30f);
    var number_5 : u32 = u32(0);
    for(;;)
    {
        if(number_5 < (plane_count_0(_S607)))
        {
        }
        else
        {
            break;
        }
        var _S617 : Plane_0 = plane_of_0(_S607, number_5);
        var _S618 : u32 = (words_0[_S617.max_heights_1 + u32(4) * (locate_0(_S617.weft_2, _S609 - _S617.start_y_0).thread_1 / u32(2) * _S617.max_height_columns_1 + locate_0(_S617.warp_2, _S608 - _S617.start_x_0).thread_1 / u32(2)) + _S615] >> (u32(select(i32(0), i32(4), _S612))));
        var _S619 : vec4<f32> = max(levels_4, vec4<f32>(f32((_S618 & (u32(15)))), f32((((_S618 >> (u32(8)))) & (u32(15)))), f32((((_S618 >> (u32(16)))) & (u32(15)))), f32((((_S618 >> (u32(24)))) & (u32(15))))) * vec4<f32>(0.06666667014360428f) * vec4<f32>(_S617.height_high_1) + vec4<f32>(select(_S617.front_level_0, _S617.back_level_0, _S612)));
        var _S620 : u32 = number_5 + u32(1);
        levels_4 = _S619;
        number_5 = _S620;
    }
    var max_height_0 : f32 = fabrics_0[_S607].height_high_0;
    var number_6 : i32 = i32(3);
    for(;;)
    {
        if(number_6 >= i32(0))
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S610) * _S616) <= (PYRAMID_RADII_0[number_6]))
        {
            max_height_0 = min(max_height_0, levels_4[number_6]);
        }
        number_6 = number_6 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S621 : u32,  _S622 : f32,  _S623 : f32,  _S624 : bool,  _S625 : bool,  _S626 : bool) -> vec3<f32>
{
    if(is_layered_0(_S621))
    {
        return first_bounds_0(_S621, plane_order_0(_S621, _S622, _S623, _S624), _S622, _S623, _S624, _S625, _S626);
    }
    return bounds_in_0(whole_plane_0(_S621), _S622, _S623, _S624, _S625, _S626);
}

fn first_sample_height_0( _S627 : u32,  _S628 : ViewRay_0,  _S629 : StepControl_0,  _S630 : bool) -> f32
{
    var _S631 : f32 = max_height_along_0(_S627, _S628.origin_0.x, _S628.origin_0.y, 0.0f, vec3<f32>(_S628.slope_1, 1.0f), _S630);
    var count_5 : u32 = u32(0);
    var height_11 : f32 = _S631;
    for(;;)
    {
        if(count_5 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S632 : vec2<f32> = ViewRay_at_0(_S628, height_11);
        var _S633 : vec3<f32> = cell_bounds_0(_S627, _S632.x, _S632.y, _S630, _S629.right_1, _S629.up_1);
        var _S634 : f32 = height_11 - _S633.x;
        var _S635 : f32 = StepControl_to_cell_exit_0(_S629, _S633.y, _S633.z);
        var height_12 : f32 = height_11 - clamp(_S634, 0.0f, _S635);
        if(_S634 <= _S635)
        {
            height_11 = height_12;
            break;
        }
        count_5 = count_5 + u32(1);
        height_11 = height_12;
    }
    return height_11;
}

fn search_down_0( _S636 : u32,  _S637 : ViewRay_0,  _S638 : StepControl_0,  _S639 : bool) -> ViewRayEnd_0
{
    var _S640 : f32 = fabrics_0[_S636].height_low_0 - (fabrics_0[_S636].height_high_0 - fabrics_0[_S636].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_10 = first_sample_height_0(_S636, _S637, _S638, _S639);
    end_1.last_step_3 = _S638.epsilon_0;
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
        var _S641 : vec2<f32> = ViewRay_at_0(_S637, end_1.height_10);
        var _S642 : Probe_0 = probe_0(_S636, _S641.x, _S641.y, _S639, _S638.right_1, _S638.up_1);
        var _S643 : f32 = end_1.height_10 - _S642.height_5;
        var _S644 : f32 = ViewRay_rate_0(_S637, _S642);
        end_1.depth_2 = - _S643;
        end_1.rate_4 = _S644;
        var _S645 : bool = !_S642.hole_4;
        end_1.smooth_0 = ((((end_1.previous_4.known_0) & (_S645))) & (((end_1.previous_4.yarn_0) == (_S642.yarn_1))));
        if((((_S645 & ((_S643 <= 0.0f)))) | (((end_1.height_10) <= _S640))))
        {
            break;
        }
        var _S646 : f32 = way_back_to_dip_0(end_1.previous_4, _S643, _S644, end_1.last_step_3, _S642);
        if(_S646 >= 0.0f)
        {
            end_1.height_10 = end_1.height_10 + _S646;
            end_1.last_step_3 = end_1.last_step_3 - _S646;
            count_6 = count_6 + u32(1);
            continue;
        }
        var _S647 : f32 = min(StepControl_to_cell_exit_0(_S638, _S642.side_x_0, _S642.side_y_0), end_1.height_10 - _S642.cell_max_0);
        var _S648 : f32 = StepControl_to_next_sample_0(_S638, _S642, _S643, _S644);
        end_1.previous_4 = after_sample_0(_S643, _S644, _S642, _S647 > _S648);
        var _S649 : f32 = max(_S647, _S648);
        end_1.last_step_3 = _S649;
        end_1.height_10 = end_1.height_10 - _S649;
        count_6 = count_6 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S650 : u32,  _S651 : ViewRay_0,  _S652 : StepControl_0,  _S653 : bool,  _S654 : ViewRayEnd_0,  _S655 : u32) -> f32
{
    var _S656 : f32 = fabrics_0[_S650].height_high_0 - fabrics_0[_S650].height_low_0;
    var above_2 : f32 = _S654.height_10 + _S654.last_step_3;
    var above_gap_1 : f32 = clamp(_S654.previous_4.clearance_0, 0.0f, _S656);
    var under_gap_1 : f32 = clamp(_S654.depth_2, 0.0f, _S656);
    var middle_0 : f32 = select(between_0(above_2, _S654.height_10, above_gap_1, under_gap_1), above_2 - cubic_root_0(above_gap_1, - under_gap_1, _S654.previous_4.rate_0 * _S654.last_step_3, _S654.rate_4 * _S654.last_step_3) * _S654.last_step_3, _S654.smooth_0);
    var side_3 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S654.height_10;
    var above_3 : f32 = above_2;
    var i_2 : u32 = u32(0);
    for(;;)
    {
        if(i_2 < _S655)
        {
        }
        else
        {
            break;
        }
        var _S657 : vec2<f32> = ViewRay_at_0(_S651, middle_0);
        var _S658 : Probe_0 = probe_0(_S650, _S657.x, _S657.y, _S653, _S652.right_1, _S652.up_1);
        var _S659 : f32 = clamp(middle_0 - select(_S658.height_5, -1.0e+09f, _S658.hole_4), - _S656, _S656);
        if(_S659 <= 0.0f)
        {
            var _S660 : f32 = select(above_gap_2, 0.5f * above_gap_2, side_3 > 0.0f);
            var _S661 : f32 = - _S659;
            under_1 = middle_0;
            above_gap_2 = _S660;
            under_gap_2 = _S661;
            side_3 = 1.0f;
        }
        else
        {
            var _S662 : f32 = select(under_gap_2, 0.5f * under_gap_2, side_3 < 0.0f);
            above_3 = middle_0;
            above_gap_2 = _S659;
            under_gap_2 = _S662;
            side_3 = -1.0f;
        }
        var _S663 : f32 = select(between_0(above_3, under_1, above_gap_2, under_gap_2), clamp(middle_0 + _S659 / min(ViewRay_rate_0(_S651, _S658), -9.99999997475242708e-07f), under_1, above_3), _S654.smooth_0);
        var _S664 : u32 = i_2 + u32(1);
        middle_0 = _S663;
        i_2 = _S664;
    }
    return select(under_1, middle_0, _S654.smooth_0);
}

fn first_hit_of_yarn_0( _S665 : u32,  _S666 : SearchQuality_0,  _S667 : f32,  _S668 : f32,  _S669 : vec3<f32>,  _S670 : bool) -> Hit_0
{
    var _S671 : f32 = max(_S669.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S667, _S668);
    var _S672 : vec2<f32> = _S669.xy / vec2<f32>(_S671);
    ray_0.slope_1 = _S672;
    var _S673 : StepControl_0 = step_control_0((vec2<f32>(0) - _S672), 1.0f / max(steps_per_length_0(_S665, _S666, _S669) / _S671, 9.99999971718068537e-10f));
    var _S674 : ViewRayEnd_0 = search_down_0(_S665, ray_0, _S673, _S670);
    var hit_0 : Hit_0;
    hit_0.hole_7 = false;
    var _S675 : f32 = refined_height_0(_S665, ray_0, _S673, _S670, _S674, _S666.refinements_0);
    hit_0.height_9 = _S675;
    var _S676 : vec2<f32> = ViewRay_at_0(ray_0, _S675);
    hit_0.x_21 = _S676.x;
    hit_0.y_14 = _S676.y;
    return hit_0;
}

fn first_hit_0( _S677 : u32,  _S678 : SearchQuality_0,  _S679 : f32,  _S680 : f32,  _S681 : vec3<f32>,  _S682 : bool) -> Hit_0
{
    if(!passes_through_0(_S677, _S678, _S679, _S680, _S681, _S682))
    {
        return first_hit_of_yarn_0(_S677, _S678, _S679, _S680, _S681, _S682);
    }
    var hit_1 : Hit_0;
    hit_1.x_21 = _S679;
    hit_1.y_14 = _S680;
    hit_1.height_9 = 0.0f;
    hit_1.hole_7 = true;
    return hit_1;
}

fn surface_of_0( _S683 : u32,  _S684 : Sample_0,  _S685 : f32,  _S686 : f32,  _S687 : bool) -> SurfacePoint_0
{
    var _S688 : u32 = select(fabrics_0[_S683].weft_0, fabrics_0[_S683].warp_0, _S684.shown_2.is_warp_2);
    var _S689 : f32 = families_0[_S688].twist_sine_0 * select(1.0f, -1.0f, _S687);
    var _S690 : f32 = families_0[_S688].twist_cosine_0;
    var _S691 : f32 = select(-1.0f, 1.0f, _S684.shown_2.is_warp_2);
    var _S692 : vec2<f32> = fibre_direction_0(_S684.slope_across_0, _S691 * _S684.slope_along_0, _S689, families_0[_S688].twist_cosine_0);
    var _S693 : f32 = _S692.x;
    var _S694 : f32 = _S692.y;
    var _S695 : f32 = select(_S684.slope_y_0, _S684.slope_x_0, _S684.shown_2.is_warp_2) * _S693 + _S691 * select(_S684.slope_x_0, _S684.slope_y_0, _S684.shown_2.is_warp_2) * _S694;
    var _S696 : f32 = select(_S684.crossing_3.weft_3.half_width_1, _S684.crossing_3.warp_3.half_width_1, _S684.shown_2.is_warp_2) * 1.0154266357421875f;
    var _S697 : f32 = _S696 * arc_sine_0(clamp(_S684.section_1.across_3 / _S696, -1.0f, 1.0f));
    var _S698 : f32 = select(_S684.here_0.plane_5.start_x_0 - _S685, _S686 - _S684.here_0.plane_5.start_y_0, _S684.shown_2.is_warp_2);
    var point_4 : SurfacePoint_0;
    point_4.hole_0 = _S684.shown_2.hole_3;
    point_4.is_warp_0 = _S684.shown_2.is_warp_2;
    point_4.warp_thread_0 = _S684.crossing_3.warp_3.thread_1;
    point_4.weft_thread_0 = _S684.crossing_3.weft_3.thread_1;
    if(is_layered_0(_S683))
    {
        point_4.warp_thread_0 = words_0[_S684.here_0.plane_5.end_numbers_0 + point_4.warp_thread_0];
        point_4.weft_thread_0 = words_0[_S684.here_0.plane_5.pick_numbers_0 + point_4.weft_thread_0];
    }
    point_4.height_2 = _S684.height_4;
    point_4.plane_0 = _S684.here_0.level_1;
    point_4.layer_0 = _S684.here_0.number_2;
    point_4.normal_1 = normalize(vec3<f32>(- _S684.slope_x_0, - _S684.slope_y_0, 1.0f));
    point_4.tangent_0 = normalize(select_vector_1(_S684.shown_2.is_warp_2, vec3<f32>(_S693, _S694, _S695), vec3<f32>(- _S694, _S693, _S695)));
    point_4.across_1 = _S684.section_1.across_3;
    point_4.fibre_across_0 = _S697 * _S690 + _S698 * _S689;
    point_4.fibre_along_0 = _S698 * _S690 - _S697 * _S689;
    var _S699 : f32 = run_share_0(_S684.shown_2.word_0);
    point_4.shown_share_0 = select(1.0f - _S699, _S699, _S684.shown_2.on_top_0);
    point_4.x_8 = _S685;
    point_4.y_2 = _S686;
    return point_4;
}

fn surface_met_0( _S700 : u32,  _S701 : f32,  _S702 : f32,  _S703 : f32,  _S704 : vec3<f32>,  _S705 : bool) -> SurfacePoint_0
{
    var _S706 : Sample_0 = sample_at_0(_S700, _S701, _S702, _S705);
    var point_5 : SurfacePoint_0 = surface_of_0(_S700, _S706, _S701, _S702, _S705);
    var _S707 : u32 = select(fabrics_0[_S700].weft_0, fabrics_0[_S700].warp_0, point_5.is_warp_0);
    var _S708 : f32 = select(_S706.crossing_3.weft_3.half_width_1, _S706.crossing_3.warp_3.half_width_1, point_5.is_warp_0) * 1.0154266357421875f;
    var _S709 : f32 = _S706.dive_1.z;
    var _S710 : f32 = _S706.slope_along_0 - (1.0f - _S709) * _S706.dive_1.y / families_0[_S707].height_scale_0;
    var _S711 : f32 = rsqrt_0(_S710 * _S710 + 1.0f);
    var _S712 : f32 = _S704.x;
    var _S713 : f32 = _S704.y;
    var _S714 : f32 = select(_S713, _S712, point_5.is_warp_0);
    var _S715 : f32 = _S704.z;
    var _S716 : f32 = (_S715 / families_0[_S707].height_scale_0 - _S710 * select(_S712, _S713, point_5.is_warp_0)) * _S711;
    var _S717 : f32 = square_1(_S708);
    var _S718 : f32 = sqrt(max(_S717 - square_1(point_5.across_1), 0.0f)) - (_S706.height_4 + _S709 * _S706.dive_1.x - _S703) / families_0[_S707].height_scale_0 * _S711;
    var _S719 : f32 = square_1(_S714) + square_1(_S716) + 9.999999960041972e-13f;
    var _S720 : f32 = point_5.across_1 * _S714 + _S718 * _S716;
    var _S721 : f32 = square_1(point_5.across_1) + square_1(_S718) - _S717;
    var _S722 : f32 = sqrt(max(square_1(_S720) - _S719 * _S721, 0.0f));
    var _S723 : f32 = clamp(select((_S722 - _S720) / _S719, - _S721 / max(_S720 + _S722, 9.999999960041972e-13f), _S720 > 0.0f), - _S708, _S708);
    var _S724 : f32 = point_5.across_1 + _S723 * _S714;
    point_5.across_1 = _S724;
    var _S725 : vec2<f32> = normalize(vec2<f32>(_S724, _S718 + _S723 * _S716));
    var _S726 : f32 = select(-1.0f, 1.0f, point_5.is_warp_0);
    var _S727 : f32 = families_0[_S707].twist_sine_0 * select(1.0f, -1.0f, _S705);
    var _S728 : f32 = _S725.x;
    var _S729 : f32 = _S727 * _S728 * _S711;
    var _S730 : f32 = _S725.y;
    var _S731 : f32 = - _S727 * _S730;
    var _S732 : f32 = families_0[_S707].twist_cosine_0 * _S711 - _S726 * _S710 * _S729;
    var _S733 : f32 = families_0[_S707].height_scale_0 * (families_0[_S707].twist_cosine_0 * _S726 * _S710 * _S711 + _S729);
    var _S734 : f32 = families_0[_S707].height_scale_0 * _S728;
    var _S735 : f32 = - families_0[_S707].height_scale_0 * _S710 * _S711 * _S730;
    point_5.normal_1 = normalize(vec3<f32>(select(_S735, _S734, point_5.is_warp_0), select(_S734, _S735, point_5.is_warp_0), _S711 * _S730));
    point_5.tangent_0 = normalize(vec3<f32>(select(- _S732, _S731, point_5.is_warp_0), select(_S731, _S732, point_5.is_warp_0), _S733));
    var _S736 : f32 = _S708 * angle_of_0(_S725);
    var _S737 : f32 = select(- _S701 - _S723 * _S712, _S702 + _S723 * _S713, point_5.is_warp_0);
    point_5.fibre_across_0 = _S736 * families_0[_S707].twist_cosine_0 + _S737 * _S727;
    point_5.fibre_along_0 = _S737 * families_0[_S707].twist_cosine_0 - _S736 * _S727;
    var _S738 : f32 = 0.00999999977648258f * _S708;
    var _S739 : f32 = - _S738;
    var _S740 : bool = _S723 < _S739;
    var _S741 : f32 = select(_S738, _S739, _S714 < 0.0f);
    var _S742 : f32 = max(_S723, 0.0f);
    point_5.x_8 = point_5.x_8 + select(_S742 * _S712, select(0.0f, _S741, point_5.is_warp_0), _S740);
    point_5.y_2 = point_5.y_2 + select(_S742 * _S713, select(_S741, 0.0f, point_5.is_warp_0), _S740);
    point_5.height_2 = select(_S703 + _S723 * _S715, _S703, _S740);
    return point_5;
}

fn hairs_over_0( _S743 : u32,  _S744 : SurfacePoint_0,  _S745 : bool,  _S746 : f32) -> Hairs_0
{
    var hairs_2 : Hairs_0;
    hairs_2.place_1 = vec2<f32>(_S744.x_8, _S744.y_2);
    hairs_2.below_1 = fabrics_0[_S743].height_high_0 - _S744.height_2;
    hairs_2.back_7 = _S745;
    hairs_2.size_3 = _S746;
    return hairs_2;
}

fn has_hairs_0( _S747 : u32) -> bool
{
    return (((families_0[fabrics_0[_S747].warp_0].hairiness_0) > 0.0f) | (((families_0[fabrics_0[_S747].weft_0].hairiness_0) > 0.0f)));
}

fn hair_towards_0( _S748 : u32,  _S749 : Hairs_0,  _S750 : vec3<f32>,  _S751 : f32) -> Hair_0
{
    var _S752 : f32 = fabrics_0[_S748].fibre_size_0;
    var _S753 : f32 = 17.0f * fabrics_0[_S748].fibre_size_0;
    var _S754 : f32 = fade_0(_S751, _S753);
    var _S755 : vec2<f32> = _S750.xy / vec2<f32>(max(_S750.z, 0.3333333432674408f));
    var _S756 : u32 = hash_key_0(select(u32(0), u32(1), _S749.back_7), ((fabrics_0[_S748].seed_0) ^ (u32(1013904242))));
    var _S757 : f32 = fabrics_0[_S748].fibre_size_0 / max(_S751, 0.07000000029802322f * fabrics_0[_S748].fibre_size_0);
    const _S758 : vec2<f32> = vec2<f32>(0.0f, 1.0f);
    var cover_3 : f32 = 0.0f;
    var hair_across_0 : vec2<f32> = _S758;
    var hair_away_0 : f32 = 0.0f;
    var is_warp_7 : bool = false;
    var number_7 : u32 = u32(0);
    for(;;)
    {
        if(((_S754 > 0.0f) & ((number_7 < u32(18)))))
        {
        }
        else
        {
            break;
        }
        var _S759 : u32 = number_7 / u32(9);
        var _S760 : u32 = number_7 / u32(3) - u32(3) * _S759;
        var _S761 : vec2<f32> = (vec2<f32>(((f32(_S759) * 6.0f + 2.0f) * _S752 + _S749.below_1)) * _S755 + _S749.place_1) / vec2<f32>(_S753);
        var _S762 : vec2<f32> = floor(_S761) + vec2<f32>(f32(number_7 - u32(3) * _S760 - u32(9) * _S759), f32(_S760)) - vec2<f32>(1.0f);
        var _S763 : u32 = hash_bits_0(_S756 + _S759, u32(i32(_S762.x)) * u32(65536) + u32(i32(_S762.y)));
        var _S764 : u32 = hash_bits_0(_S756, _S763);
        var _S765 : vec2<f32> = _S761 - _S762 - vec2<f32>(share_of_0(_S763), share_of_0((_S763 >> (u32(10)))));
        var _S766 : vec2<f32> = sine_cosine_0(3.14159274101257324f * share_of_0((_S763 >> (u32(20)))));
        var _S767 : f32 = mix(5.0f, 16.0f, share_of_0((_S764 >> (u32(10))))) / 17.0f;
        var _S768 : f32 = _S765.x;
        var _S769 : f32 = _S766.y;
        var _S770 : f32 = _S765.y;
        var _S771 : f32 = _S766.x;
        var _S772 : f32 = (_S768 * _S769 + _S770 * _S771) / _S767;
        var _S773 : f32 = 0.69999998807907104f * (2.0f * share_of_0((_S764 >> (u32(20)))) - 1.0f);
        var _S774 : f32 = 0.5f * (2.0f * share_of_0((_S763 ^ (_S764))) - 1.0f);
        var _S775 : f32 = _S772 * (3.0f * _S774 * _S772 + 2.0f * _S773);
        var _S776 : f32 = rsqrt_0(_S775 * _S775 + 1.0f);
        var _S777 : f32 = (_S770 * _S769 - _S768 * _S771 - _S767 * _S772 * _S772 * (_S774 * _S772 + _S773)) * _S776 * 17.0f;
        var _S778 : f32 = 0.2800000011920929f * max(1.0f - square_1(square_1(_S772)), 0.0f) * _S757;
        var _S779 : f32 = clamp(_S778 + 0.5f - abs(_S777) * _S757, 0.0f, min(2.0f * _S778, 1.0f));
        var _S780 : bool = ((((_S764 >> (u32(30)))) & (u32(1)))) == u32(1);
        var _S781 : bool = (((((share_of_0(_S764)) < (families_0[select(fabrics_0[_S748].weft_0, fabrics_0[_S748].warp_0, _S780)].hairiness_0)) & (((abs(_S772)) < 1.0f)))) & ((_S779 > cover_3)));
        var _S782 : vec2<f32> = vec2<f32>(- _S771 - _S775 * _S769, _S769 - _S775 * _S771) * vec2<f32>(_S776);
        var _S783 : f32 = select(cover_3, _S779, _S781);
        var _S784 : vec2<f32> = vec2<f32>(select(hair_across_0.x, _S782.x, _S781), select(hair_across_0.y, _S782.y, _S781));
        var _S785 : f32 = select(hair_away_0, _S777, _S781);
        var _S786 : bool = select(is_warp_7, _S780, _S781);
        var _S787 : u32 = number_7 + u32(1);
        cover_3 = _S783;
        hair_across_0 = _S784;
        hair_away_0 = _S785;
        is_warp_7 = _S786;
        number_7 = _S787;
    }
    var _S788 : f32 = clamp(hair_away_0 * 2.85714292526245117f, -0.80000001192092896f, 0.80000001192092896f);
    var hair_1 : Hair_0;
    hair_1.cover_1 = _S754 * cover_3;
    hair_1.normal_5 = vec3<f32>(vec2<f32>(_S788) * hair_across_0, sqrt(1.0f - _S788 * _S788));
    hair_1.tangent_4 = vec3<f32>(hair_across_0.y, - hair_across_0.x, 0.0f);
    hair_1.is_warp_5 = is_warp_7;
    hair_1.shade_0 = _S754 * 0.03255363181233406f * (families_0[fabrics_0[_S748].warp_0].hairiness_0 + families_0[fabrics_0[_S748].weft_0].hairiness_0);
    return hair_1;
}

fn thread_of_family_0( _S789 : u32,  _S790 : SurfacePoint_0) -> i32
{
    var _S791 : u32 = select(fabrics_0[_S789].weft_0, fabrics_0[_S789].warp_0, _S790.is_warp_0);
    return i32(floor((select(_S790.y_2, _S790.x_8, _S790.is_warp_0) - _S790.across_1) / families_0[_S791].period_0)) * i32(families_0[_S791].count_0) + i32(select(_S790.weft_thread_0, _S790.warp_thread_0, _S790.is_warp_0));
}

fn thread_number_0( _S792 : u32,  _S793 : SurfacePoint_0) -> u32
{
    return u32(thread_of_family_0(_S792, _S793)) * u32(2) + select(u32(0), u32(1), _S793.is_warp_0);
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

fn fibre_noise_at_0( _S794 : u32,  _S795 : u32,  _S796 : SurfacePoint_0,  _S797 : u32,  _S798 : f32) -> FibreNoise_0
{
    var _S799 : f32 = 5.0f * fabrics_0[_S794].fibre_size_0;
    var _S800 : vec2<f32> = wave_noise_0(hash_key_0(_S797, ((fabrics_0[_S794].seed_0) ^ (u32(458671337)))), _S796.fibre_along_0 / (25.0f * fabrics_0[_S794].fibre_size_0));
    var _S801 : f32 = _S796.fibre_across_0 + families_0[_S795].fibre_tilt_0 * 0.5f * 25.0f * fabrics_0[_S794].fibre_size_0 * _S800.x;
    var _S802 : vec3<f32> = fibre_cell_0(_S801, _S796.fibre_along_0, fabrics_0[_S794].fibre_size_0);
    var _S803 : vec3<f32> = fibre_cell_0(_S801, _S796.fibre_along_0, _S799);
    var noise_0 : FibreNoise_0;
    noise_0.bundle_0 = cell_noise_0(hash_key_0(_S797, ((fabrics_0[_S794].seed_0) ^ (u32(1757159915)))), _S803);
    noise_0.bundle_offset_0 = _S803.z;
    noise_0.bundle_weight_0 = fade_0(_S798, _S799);
    noise_0.fibre_0 = cell_noise_0(hash_key_0(_S797, ((fabrics_0[_S794].seed_0) ^ (u32(48610963)))), _S802);
    noise_0.fibre_weight_0 = fade_0(_S798, fabrics_0[_S794].fibre_size_0);
    noise_0.offset_2 = _S802.z;
    noise_0.slope_2 = 0.5f * _S800.y;
    return noise_0;
}

fn turned_frame_0( _S804 : u32,  _S805 : u32,  _S806 : SurfacePoint_0,  _S807 : bool,  _S808 : u32,  _S809 : f32) -> YarnFrame_0
{
    var frame_2 : YarnFrame_0;
    frame_2.normal_7 = _S806.normal_1;
    frame_2.tangent_6 = _S806.tangent_0;
    frame_2.loss_0 = 0.0f;
    frame_2.shade_2 = 0.0f;
    if((families_0[_S805].has_plies_0) > 0.0f)
    {
        var _S810 : f32 = fade_0(_S809, 1.0f / families_0[_S805].plies_per_mm_0);
        var _S811 : f32 = _S810 * 0.62000000476837158f * ply_offset_0(_S805, _S806, _S807);
        var _S812 : vec3<f32> = cross(frame_2.tangent_6, frame_2.normal_7);
        var _S813 : vec3<f32> = vec3<f32>(families_0[_S805].ply_cosine_0);
        var _S814 : vec3<f32> = vec3<f32>(select(families_0[_S805].ply_sine_0, - families_0[_S805].ply_sine_0, _S807));
        var _S815 : vec3<f32> = _S813 * _S812 + _S814 * frame_2.tangent_6;
        var _S816 : vec3<f32> = vec3<f32>(sqrt(1.0f - _S811 * _S811));
        var _S817 : vec3<f32> = vec3<f32>(_S811);
        frame_2.tangent_6 = _S813 * (_S813 * frame_2.tangent_6 - _S814 * _S812) + _S814 * (_S816 * _S815 - _S817 * frame_2.normal_7);
        frame_2.normal_7 = _S816 * frame_2.normal_7 + _S817 * _S815;
        frame_2.loss_0 = _S810 * _S810 * 0.62000000476837158f * 0.62000000476837158f / 3.0f;
    }
    var _S818 : f32 = families_0[_S805].fibre_tilt_0;
    if((families_0[_S805].fibre_tilt_0) > 0.0f)
    {
        var _S819 : FibreNoise_0 = fibre_noise_at_0(_S804, _S805, _S806, _S808, _S809);
        var _S820 : f32 = 1.09858846664428711f * _S818 * (_S819.bundle_weight_0 * _S819.bundle_0.x + _S819.fibre_weight_0 * (_S819.fibre_0.x + _S819.offset_2));
        var _S821 : f32 = _S818 * (1.42099642753601074f * (_S819.bundle_weight_0 * _S819.bundle_0.y + _S819.fibre_weight_0 * _S819.fibre_0.y) - _S819.bundle_weight_0 * _S819.slope_2);
        var _S822 : f32 = square_1(_S819.fibre_weight_0);
        frame_2.loss_0 = frame_2.loss_0 + 0.5f * _S818 * _S818 * ((0.24761904776096344f * (square_1(_S819.bundle_weight_0) + _S822) + _S822 / 3.0f) * 1.09858846664428711f * 1.09858846664428711f);
        var _S823 : vec3<f32> = cross(frame_2.tangent_6, frame_2.normal_7);
        var _S824 : vec2<f32> = sine_cosine_0(_S820);
        var _S825 : vec2<f32> = sine_cosine_0(_S821);
        var _S826 : vec3<f32> = vec3<f32>(_S824.y);
        var _S827 : vec3<f32> = vec3<f32>(_S824.x);
        var _S828 : vec3<f32> = _S826 * _S823 - _S827 * frame_2.normal_7;
        frame_2.normal_7 = _S826 * frame_2.normal_7 + _S827 * _S823;
        frame_2.tangent_6 = vec3<f32>(_S825.y) * frame_2.tangent_6 + vec3<f32>(_S825.x) * _S828;
    }
    return frame_2;
}

fn uncoloured_point_0( _S829 : u32,  _S830 : SurfacePoint_0,  _S831 : vec3<f32>,  _S832 : bool,  _S833 : bool,  _S834 : f32) -> YarnPoint_0
{
    var _S835 : u32 = fabrics_0[_S829].warp_0;
    var _S836 : u32 = fabrics_0[_S829].weft_0;
    var _S837 : u32 = select(fabrics_0[_S829].weft_0, fabrics_0[_S829].warp_0, _S830.is_warp_0);
    var _S838 : bool = (((fabrics_0[_S829].has_detail_0) != u32(0)) & ((_S834 >= 0.0f)));
    var _S839 : vec3<f32> = vec3<f32>(0.0f);
    var _S840 : vec2<f32> = vec2<f32>(0.0f);
    var point_6 : YarnPoint_0 = YarnPoint_x24init_0(false, false, false, 0.0f, 0.0f, 0.0f, _S839, _S839, _S839, 0.0f, 0.0f, Albedos_x24init_0(_S839, _S839, _S839, _S839), Hairs_x24init_0(_S840, 0.0f, false, 0.0f), 0.0f, _S840, 0.0f);
    point_6.hairs_0 = hairs_over_0(_S829, _S830, _S832, _S834);
    point_6.hair_cover_0 = 1.0f;
    var _S841 : Hair_0 = Hair_x24init_0(0.0f, _S839, _S839, false, 0.0f);
    point_6.is_warp_3 = _S830.is_warp_0;
    var _S842 : bool = (_S838 & ((has_hairs_0(_S829))));
    var hair_2 : Hair_0;
    if(_S842)
    {
        var _S843 : Hair_0 = hair_towards_0(_S829, point_6.hairs_0, _S831, _S834);
        point_6.hair_cover_0 = _S843.cover_1;
        point_6.is_warp_3 = select(_S830.is_warp_0, _S843.is_warp_5, (_S843.cover_1) > 0.5f);
        hair_2 = _S843;
    }
    else
    {
        hair_2 = _S841;
    }
    var _S844 : u32 = select(_S836, _S835, point_6.is_warp_3);
    point_6.back_9 = _S832;
    point_6.hole_5 = _S833;
    point_6.x_14 = _S830.x_8;
    point_6.y_7 = _S830.y_2;
    point_6.place_3 = vec2<f32>(_S830.x_8, _S830.y_2);
    point_6.plane_6 = _S830.plane_0;
    point_6.height_7 = _S830.height_2 + hair_2.cover_1 * point_6.hairs_0.below_1;
    point_6.normal_3 = _S830.normal_1;
    point_6.tangent_2 = _S830.tangent_0;
    point_6.surface_normal_0 = normalize(mix(_S830.normal_1, vec3<f32>(0.0f, 0.0f, 1.0f), vec3<f32>(hair_2.cover_1)));
    point_6.diffuse_gain_0 = 1.0f;
    if(_S838)
    {
        var _S845 : YarnFrame_0 = turned_frame_0(_S829, _S837, _S830, _S832, thread_number_0(_S829, _S830), _S834);
        var frame_3 : YarnFrame_0;
        if(_S842)
        {
            frame_3 = under_hair_0(_S845, hair_2);
        }
        else
        {
            frame_3 = _S845;
        }
        point_6.normal_3 = frame_3.normal_7;
        point_6.tangent_2 = frame_3.tangent_6;
        point_6.diffuse_gain_0 = diffuse_gain_2(frame_3, fabrics_0[_S829].diffuse_blend_0);
    }
    point_6.roughness_1 = families_0[_S844].roughness_0;
    return point_6;
}

fn surface_at_0( _S846 : u32,  _S847 : f32,  _S848 : f32,  _S849 : bool) -> SurfacePoint_0
{
    return surface_of_0(_S846, sample_at_0(_S846, _S847, _S848, _S849), _S847, _S848, _S849);
}

fn unoccluded_0( _S850 : u32,  _S851 : SearchQuality_0,  _S852 : f32,  _S853 : f32,  _S854 : f32,  _S855 : vec3<f32>,  _S856 : bool) -> bool
{
    if((_S855.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S850, _S851, vec3<f32>(_S852, _S853, _S854 + fabrics_0[_S850].lift_0), _S855, _S856, max_height_along_0(_S850, _S852, _S853, _S854, _S855, _S856));
}

fn is_lit_0( _S857 : u32,  _S858 : SearchQuality_0,  _S859 : YarnPoint_0,  _S860 : vec3<f32>) -> bool
{
    if(_S859.hole_5)
    {
        return true;
    }
    var _S861 : vec3<f32> = to_face_frame_0(_S860, _S859.back_9);
    var _S862 : f32 = _S861.z;
    var _S863 : bool = _S862 < 0.0f;
    var normal_12 : vec3<f32>;
    var height_13 : f32;
    if(_S863)
    {
        var _S864 : SurfacePoint_0 = surface_at_0(_S857, _S859.x_14, _S859.y_7, !_S859.back_9);
        normal_12 = _S864.normal_1;
        height_13 = _S864.height_2;
    }
    else
    {
        normal_12 = _S859.surface_normal_0;
        height_13 = _S859.height_7;
    }
    var _S865 : vec3<f32> = vec3<f32>(_S861.xy, abs(_S862));
    if((dot(normal_12, _S865)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S857, _S858, _S859.x_14, _S859.y_7, height_13, _S865, (_S859.back_9) != _S863);
}

fn hairs_lit_0( _S866 : u32,  _S867 : Hairs_0,  _S868 : vec3<f32>) -> f32
{
    return 1.0f - 0.5f * hair_towards_0(_S866, _S867, _S868, _S867.size_3 + fabrics_0[_S866].fibre_size_0).cover_1;
}

fn under_hairs_0( _S869 : u32,  _S870 : YarnPoint_0,  _S871 : vec3<f32>) -> f32
{
    if((((_S870.hair_cover_0) >= 1.0f) | (((_S871.z) <= 0.0f))))
    {
        return 1.0f;
    }
    return mix(hairs_lit_0(_S869, _S870.hairs_0, _S871), 1.0f, _S870.hair_cover_0);
}

fn components_of_point_0( _S872 : u32,  _S873 : SearchQuality_0,  _S874 : YarnPoint_0,  _S875 : vec3<f32>,  _S876 : vec3<f32>) -> Components_0
{
    var result_6 : Components_0 = no_components_0();
    result_6.hole_2 = select(0.0f, 1.0f, _S874.hole_5);
    var _S877 : bool;
    if(_S874.hole_5)
    {
        _S877 = true;
    }
    else
    {
        _S877 = !is_lit_0(_S872, _S873, _S874, _S875);
    }
    if(_S877)
    {
        return result_6;
    }
    var _S878 : vec3<f32> = to_face_frame_0(_S875, _S874.back_9);
    var _S879 : vec3<f32> = to_face_frame_0(_S876, _S874.back_9);
    var _S880 : bool = (_S878.z) < 0.0f;
    var _S881 : f32 = under_hairs_0(_S872, _S874, _S878);
    var _S882 : f32 = _S881 * _S874.diffuse_gain_0 * diffuse_reflection_0(select_vector_1(_S880, (vec3<f32>(0) - _S878), _S878), _S874.normal_3, fabrics_0[_S872].diffuse_blend_0);
    var _S883 : f32;
    if(_S880)
    {
        _S883 = transmission_1(_S878, _S879, _S874.normal_3, _S874.tangent_2, _S874.roughness_1, fabrics_0[_S872].optical_depth_0);
    }
    else
    {
        _S883 = reflection_0(_S878, _S879, _S874.normal_3, _S874.tangent_2, _S874.roughness_1, fabrics_0[_S872].optical_depth_0);
    }
    var _S884 : f32 = _S881 * _S883;
    result_6.diffuse_warp_0 = select(0.0f, _S882, _S874.is_warp_3);
    result_6.diffuse_weft_0 = select(_S882, 0.0f, _S874.is_warp_3);
    result_6.specular_warp_0 = select(0.0f, _S884, _S874.is_warp_3);
    result_6.specular_weft_0 = select(_S884, 0.0f, _S874.is_warp_3);
    result_6.light_visibility_1 = 1.0f;
    return result_6;
}

fn openness_number_0( _S885 : u32,  _S886 : u32) -> f32
{
    return table_number_0(fabrics_0[_S885].openness_0 + _S886);
}

fn blocked_of_terms_0( _S887 : u32,  _S888 : u32,  _S889 : array<f32, i32(6)>,  _S890 : u32) -> Blocked_0
{
    var shares_2 : array<f32, i32(3)>;
    var share_5 : u32 = u32(0);
    for(;;)
    {
        if(share_5 < u32(3))
        {
        }
        else
        {
            break;
        }
        shares_2[share_5] = 0.0f;
        var term_2 : u32 = u32(0);
        for(;;)
        {
            if(term_2 < _S890)
            {
            }
            else
            {
                break;
            }
            shares_2[share_5] = shares_2[share_5] + openness_number_0(_S887, _S888 + share_5 * _S890 + term_2) * _S889[term_2];
            term_2 = term_2 + u32(1);
        }
        shares_2[share_5] = saturate(shares_2[share_5]);
        share_5 = share_5 + u32(1);
    }
    var blocked_2 : Blocked_0;
    blocked_2.by_warp_0 = shares_2[i32(0)] * shares_2[i32(2)];
    blocked_2.by_weft_0 = shares_2[i32(0)] * (1.0f - shares_2[i32(2)]);
    blocked_2.far_0 = shares_2[i32(1)];
    return blocked_2;
}

fn blocked_at_0( _S891 : u32,  _S892 : bool,  _S893 : bool,  _S894 : f32,  _S895 : f32) -> Blocked_0
{
    var _S896 : f32 = _S895 * openness_number_0(_S891, u32(158));
    var terms_5 : array<f32, i32(6)> = array<f32, i32(6)>( 1.0f, _S894, _S896, _S894 * _S894, _S894 * _S896, _S896 * _S896 );
    return blocked_of_terms_0(_S891, u32(60) + (select(u32(0), u32(2), _S893) + select(u32(1), u32(0), _S892)) * u32(18), terms_5, u32(6));
}

fn with_blocked_0( _S897 : u32,  _S898 : Blocked_0,  _S899 : YarnPoint_0,  _S900 : bool,  _S901 : f32) -> Blocked_0
{
    if(((_S899.hole_5) | (((_S899.is_warp_3) != _S900))))
    {
        return _S898;
    }
    var _S902 : Blocked_0 = blocked_at_0(_S897, _S900, _S899.back_9, _S899.surface_normal_0.z, _S899.height_7 - _S899.plane_6);
    var result_7 : Blocked_0;
    result_7.by_warp_0 = _S898.by_warp_0 + _S901 * _S902.by_warp_0;
    result_7.by_weft_0 = _S898.by_weft_0 + _S901 * _S902.by_weft_0;
    result_7.far_0 = _S898.far_0 + _S901 * _S902.far_0;
    return result_7;
}

struct CoverageTaps_0
{
     nodes_1 : array<u32, i32(9)>,
};

fn pyramid_level_0( _S903 : u32,  _S904 : f32) -> vec3<f32>
{
    var _S905 : u32 = fabrics_0[_S903].lobes_0.levels_0 + u32(4) * u32(min(_S904, fabrics_0[_S903].lobes_0.last_level_0));
    return vec3<f32>(table_number_0(_S905), table_number_0(_S905 + u32(1)), table_number_0(_S905 + u32(2)));
}

fn coverage_taps_0( _S906 : u32,  _S907 : Footprint_0,  _S908 : bool) -> CoverageTaps_0
{
    var _S909 : Lobes_std430_0 = fabrics_0[_S906].lobes_0;
    var _S910 : f32 = Footprint_spread_side_0(_S907) * fabrics_0[_S906].lobes_0.inverse_base_size_0;
    var _S911 : vec3<f32> = pyramid_level_0(_S906, floor(binary_logarithm_0(max(0.68000000715255737f * _S910, 1.0f))));
    var _S912 : f32 = 1.0f / max(_S910, 9.99999997475242708e-07f);
    var _S913 : vec2<f32> = vec2<f32>(families_0[fabrics_0[_S906].warp_0].inverse_period_0, families_0[fabrics_0[_S906].weft_0].inverse_period_0);
    var _S914 : vec2<f32> = _S907.centre_0 * _S913;
    var _S915 : vec2<f32> = vec2<f32>(min(max(sqrt(clamp(1.29999995231628418f * (1.0f - _S912 * _S912), 0.0f, 1.0f)), 0.3333333432674408f * _S912), 1.0f));
    var _S916 : vec2<f32> = _S907.dx_0 * _S913 * _S915;
    var _S917 : vec2<f32> = _S907.dy_0 * _S913 * _S915;
    var taps_4 : CoverageTaps_0;
    var number_8 : u32 = u32(0);
    for(;;)
    {
        if(number_8 < u32(9))
        {
        }
        else
        {
            break;
        }
        var _S918 : vec2<f32> = _S914 + vec2<f32>(TAP_OFFSETS_0[number_8].x) * _S916 + vec2<f32>(TAP_OFFSETS_0[number_8].y) * _S917;
        var _S919 : f32 = _S911.y;
        taps_4.nodes_1[number_8] = select(u32(0), _S909.face_nodes_0, _S908) + u32(wrapped_cell_0(_S918.y, _S911.z) * _S919 + wrapped_cell_0(_S918.x, _S919) + _S911.x);
        number_8 = number_8 + u32(1);
    }
    return taps_4;
}

fn joint_ratios_0( _S920 : u32,  _S921 : vec3<f32>,  _S922 : vec3<f32>,  _S923 : bool) -> vec2<f32>
{
    var _S924 : NodeTaps_0 = node_taps_of_0(_S922, u32(16));
    var _S925 : NodeTaps_0 = node_taps_of_0(_S921, u32(16));
    var _S926 : u32 = fabrics_0[_S920].lobes_0.joint_0 + u32(2) * (select(u32(0), u32(2), _S923) + select(u32(0), u32(1), (_S921.z) < 0.0f)) * u32(512);
    var _S927 : u32 = _S926 + u32(512);
    return clamp(vec2<f32>(1.0f) + vec2<f32>(dot(joint_terms_0(_S924, _S926, u32(0)), joint_terms_0(_S925, _S927, u32(0))), dot(joint_terms_0(_S924, _S926, u32(1)), joint_terms_0(_S925, _S927, u32(1)))), vec2<f32>(0.0f), vec2<f32>(4.0f));
}

fn coverage_of_pack_0( _S928 : u32,  _S929 : CoverageTaps_0,  _S930 : u32) -> vec4<f32>
{
    var number_9 : u32 = u32(0);
    var even_1 : u32 = u32(0);
    var odd_1 : u32 = u32(0);
    for(;;)
    {
        if(number_9 < u32(9))
        {
        }
        else
        {
            break;
        }
        var _S931 : u32 = words_0[fabrics_0[_S928].lobes_0.coverage_0 + _S929.nodes_1[number_9] * fabrics_0[_S928].lobes_0.packs_0 + _S930];
        var even_2 : u32 = even_1 + ((_S931 & (u32(16711935))));
        var odd_2 : u32 = odd_1 + ((((_S931 >> (u32(8)))) & (u32(16711935))));
        number_9 = number_9 + u32(1);
        even_1 = even_2;
        odd_1 = odd_2;
    }
    return bytes_of_sums_0(even_1, odd_1) / vec4<f32>(9.0f);
}

fn coverage_of_holes_0( _S932 : u32,  _S933 : CoverageTaps_0) -> f32
{
    var number_10 : u32 = u32(0);
    var total_4 : u32 = u32(0);
    for(;;)
    {
        if(number_10 < u32(9))
        {
        }
        else
        {
            break;
        }
        var total_5 : u32 = total_4 + ((((words_0[fabrics_0[_S932].lobes_0.coverage_holes_0 + _S933.nodes_1[number_10] / u32(4)] >> ((u32(8) * (_S933.nodes_1[number_10] % u32(4)))))) & (u32(255))));
        number_10 = number_10 + u32(1);
        total_4 = total_5;
    }
    return f32(total_4) / 9.0f;
}

fn prefiltered_hole_0( _S934 : u32,  _S935 : CoverageTaps_0,  _S936 : NodeTaps_0,  _S937 : bool) -> f32
{
    var _S938 : f32 = interpolate_table_0(_S936, fabrics_0[_S934].lobes_0.projected_area_0 + fabrics_0[_S934].lobes_0.packs_0, fabrics_0[_S934].lobes_0.packs_0 + u32(1)).x;
    return min(coverage_of_holes_0(_S934, _S935) * _S938 * _S938 * select(fabrics_0[_S934].lobes_0.front_hole_weight_0, fabrics_0[_S934].lobes_0.back_hole_weight_0, _S937), 1.0f);
}

fn prefiltered_components_0( _S939 : u32,  _S940 : Footprint_0,  _S941 : vec3<f32>,  _S942 : vec3<f32>,  _S943 : bool) -> Components_0
{
    var _S944 : CoverageTaps_0 = coverage_taps_0(_S939, _S940, _S943);
    var _S945 : NodeTaps_0 = node_taps_0(_S942);
    var view_nodes_0 : NodeTaps_0 = _S945;
    var _S946 : NodeTaps_0 = node_taps_0(_S941);
    var light_nodes_0 : NodeTaps_0 = _S946;
    var _S947 : u32 = select(u32(0), u32(1), _S943);
    view_nodes_0.nodes_0 = view_nodes_0.nodes_0 + vec4<u32>((_S947 * u32(256)));
    light_nodes_0.nodes_0 = light_nodes_0.nodes_0 + vec4<u32>(((u32(2) * _S947 + select(u32(0), u32(1), (_S941.z) < 0.0f)) * u32(256)));
    var _S948 : vec3<f32> = half_vector_0(_S941, _S942);
    var _S949 : vec2<f32> = joint_ratios_0(_S939, _S941, _S942, _S943);
    var _S950 : Lobes_std430_0 = fabrics_0[_S939].lobes_0;
    var _S951 : u32 = select(fabrics_0[_S939].lobes_0.front_warp_packs_0, fabrics_0[_S939].lobes_0.back_warp_packs_0, _S943);
    var sums_9 : Components_0;
    sums_9.diffuse_warp_0 = 0.0f;
    sums_9.diffuse_weft_0 = 0.0f;
    sums_9.specular_warp_0 = 0.0f;
    sums_9.specular_weft_0 = 0.0f;
    sums_9.light_visibility_1 = 0.0f;
    var pack_0 : u32 = u32(0);
    var total_6 : f32 = 0.0f;
    for(;;)
    {
        if(pack_0 < (_S950.packs_0))
        {
        }
        else
        {
            break;
        }
        var _S952 : vec4<f32> = coverage_of_pack_0(_S939, _S944, pack_0);
        var _S953 : vec4<f32> = interpolate_table_0(view_nodes_0, _S950.projected_area_0 + pack_0, _S950.packs_0 + u32(1));
        var _S954 : vec4<f32> = interpolate_table_0(light_nodes_0, _S950.light_visibility_0 + pack_0, _S950.packs_0) / vec4<f32>(255.0f);
        var _S955 : vec4<f32> = interpolate_table_0(light_nodes_0, _S950.irradiance_0 + pack_0, _S950.packs_0) * vec4<f32>(0.00124827399849892f);
        var _S956 : bool = pack_0 < _S951;
        var _S957 : f32 = families_0[select(fabrics_0[_S939].weft_0, fabrics_0[_S939].warp_0, _S956)].roughness_0;
        var number_11 : u32 = u32(0);
        var diffuse_0 : f32 = 0.0f;
        var specular_0 : f32 = 0.0f;
        var lit_1 : f32 = 0.0f;
        for(;;)
        {
            if(number_11 < u32(4))
            {
            }
            else
            {
                break;
            }
            var _S958 : Group_0 = group_at_0(_S950.moments_0 + u32(12) * (u32(4) * (_S947 * _S950.packs_0 + pack_0) + number_11), _S957);
            var _S959 : f32 = _S952[number_11] * _S953[number_11] * _S953[number_11] * _S958.weight_2;
            var diffuse_1 : f32 = diffuse_0 + _S959 * _S955[number_11];
            var specular_1 : f32 = specular_0 + _S959 * layer_value_0(_S958, _S948, _S941, _S942, fabrics_0[_S939].optical_depth_0) * _S954[number_11];
            var lit_2 : f32 = lit_1 + _S959 * _S954[number_11];
            var total_7 : f32 = total_6 + _S959;
            number_11 = number_11 + u32(1);
            diffuse_0 = diffuse_1;
            specular_0 = specular_1;
            lit_1 = lit_2;
            total_6 = total_7;
        }
        sums_9.diffuse_warp_0 = sums_9.diffuse_warp_0 + select(0.0f, diffuse_0, _S956);
        sums_9.diffuse_weft_0 = sums_9.diffuse_weft_0 + select(diffuse_0, 0.0f, _S956);
        sums_9.specular_warp_0 = sums_9.specular_warp_0 + select(0.0f, specular_0, _S956);
        sums_9.specular_weft_0 = sums_9.specular_weft_0 + select(specular_0, 0.0f, _S956);
        sums_9.light_visibility_1 = sums_9.light_visibility_1 + lit_1 * select(_S949.y, _S949.x, _S956);
        pack_0 = pack_0 + u32(1);
    }
    var _S960 : f32 = prefiltered_hole_0(_S939, _S944, view_nodes_0, _S943);
    sums_9.hole_2 = _S960;
    var _S961 : f32 = 1.0f - _S960;
    var _S962 : f32 = _S961 / max(total_6, 9.999999960041972e-13f);
    var _S963 : f32 = _S962 * _S949.x;
    sums_9.diffuse_warp_0 = sums_9.diffuse_warp_0 * _S963;
    var _S964 : f32 = _S962 * _S949.y;
    sums_9.diffuse_weft_0 = sums_9.diffuse_weft_0 * _S964;
    sums_9.specular_warp_0 = sums_9.specular_warp_0 * _S963;
    sums_9.specular_weft_0 = sums_9.specular_weft_0 * _S964;
    sums_9.light_visibility_1 = min(sums_9.light_visibility_1 * _S962, _S961);
    return sums_9;
}

fn yarns_over_0( _S965 : u32,  _S966 : Footprint_0,  _S967 : bool) -> Yarns_0
{
    var _S968 : vec2<f32> = _S966.dx_0;
    var _S969 : vec2<f32> = _S966.dy_0;
    var _S970 : vec2<f32> = sqrt(_S968 * _S968 + _S969 * _S969);
    var _S971 : f32 = Footprint_spread_side_0(_S966);
    var _S972 : vec4<f32> = vec4<f32>(0.0f);
    var yarns_0 : Yarns_0 = Yarns_x24init_0(_S972, _S972, vec3<f32>(0.0f));
    var _S973 : bool = (fabrics_0[_S965].is_irregular_0) != u32(0);
    var number_12 : u32 = u32(0);
    for(;;)
    {
        if(number_12 < select(u32(0), u32(2), _S973))
        {
        }
        else
        {
            break;
        }
        var _S974 : bool = number_12 == u32(0);
        var _S975 : u32 = select(fabrics_0[_S965].weft_0, fabrics_0[_S965].warp_0, _S974);
        var _S976 : vec2<f32> = select_vector_0(_S974, _S966.centre_0, _S966.centre_0.yx);
        var _S977 : vec2<f32> = select_vector_0(_S974, _S970, _S970.yx);
        var _S978 : f32 = _S976.x;
        var _S979 : Cell_0 = locate_0(_S975, _S978);
        var yarn_3 : vec4<f32> = irregular_over_0(_S975, irregular_key_0(_S965, number_12), irregular_thread_0(_S975, _S978, _S979) + _S979.below_0 / (_S979.below_0 + _S979.above_0), _S977.x * (families_0[_S975].count_0 / families_0[_S975].period_0), _S976.y, _S977.y);
        yarn_3[i32(1)] = yarn_3[i32(1)] * (1.0f - moved_share_0(_S975, _S971));
        yarns_0.warp_4 = yarns_0.weft_4;
        yarns_0.weft_4 = yarn_3;
        number_12 = number_12 + u32(1);
    }
    var _S980 : vec2<f32> = vec2<f32>(families_0[fabrics_0[_S965].warp_0].cover_0, families_0[fabrics_0[_S965].weft_0].cover_0);
    var _S981 : f32 = select(fabrics_0[_S965].warp_on_top_0, 1.0f - fabrics_0[_S965].warp_on_top_0, _S967);
    var _S982 : vec3<f32> = shown_of_covers_0(_S980, _S981);
    var _S983 : vec3<f32> = select_vector_1(_S973, shown_of_covers_0(saturate(_S980 + _S980 * vec2<f32>(yarns_0.warp_4.y, yarns_0.weft_4.y)), _S981) / max(_S982, vec3<f32>(0.00009999999747379f)), vec3<f32>(1.0f));
    yarns_0.shares_0 = _S983;
    yarns_0.shares_0[i32(2)] = select(1.0f, _S983.z, (_S982.z) > 0.00009999999747379f);
    return yarns_0;
}

fn with_shares_0( _S984 : u32,  _S985 : Components_0,  _S986 : Yarns_0) -> Components_0
{
    var result_8 : Components_0;
    var _S987 : f32 = min(_S985.hole_2 * _S986.shares_0.z, 1.0f);
    result_8.hole_2 = _S987;
    var _S988 : f32 = _S986.shares_0.x;
    result_8.diffuse_warp_0 = _S985.diffuse_warp_0 * _S988;
    var _S989 : f32 = _S986.shares_0.y;
    result_8.diffuse_weft_0 = _S985.diffuse_weft_0 * _S989;
    result_8.specular_warp_0 = _S985.specular_warp_0 * _S988;
    result_8.specular_weft_0 = _S985.specular_weft_0 * _S989;
    result_8.light_visibility_1 = _S985.light_visibility_1 * select(1.0f, (1.0f - _S987) / max(1.0f - _S985.hole_2, 9.99999997475242708e-07f), (fabrics_0[_S984].is_irregular_0) != u32(0));
    return result_8;
}

struct NearestLayer_0
{
     number_13 : u32,
     weight_10 : f32,
};

fn stack_share_0( _S990 : u32,  _S991 : vec2<f32>,  _S992 : vec2<f32>,  _S993 : u32) -> f32
{
    if((fabrics_0[_S990].stacks_0) == u32(1))
    {
        return 1.0f;
    }
    var _S994 : u32 = fabrics_0[_S990].plane_axes_0 + u32(1);
    var _S995 : Stretch_0 = stretch_of_0(fabrics_0[_S990].plane_axes_0, _S991.x, _S992.x);
    var _S996 : Stretch_0 = stretch_of_0(_S994, _S991.y, _S992.y);
    return clamp(integral_on_top_0(fabrics_0[_S990].plane_axes_0, _S995, _S996, u32(families_0[_S994].count_0), _S993) / (lengths_0(fabrics_0[_S990].plane_axes_0, _S995).x * lengths_0(_S994, _S996).x), 0.0f, 1.0f);
}

fn layered_albedos_0( _S997 : u32,  _S998 : Footprint_0,  _S999 : NearestLayer_0,  _S1000 : bool,  _S1001 : vec3<f32>,  _S1002 : vec3<f32>) -> LayeredAlbedos_0
{
    var _S1003 : vec2<f32> = _S998.dx_0;
    var _S1004 : vec2<f32> = _S998.dy_0;
    var _S1005 : vec2<f32> = sqrt(_S1003 * _S1003 + _S1004 * _S1004);
    var _S1006 : vec3<f32> = vec3<f32>(0.0f);
    var _S1007 : Albedos_0 = Albedos_x24init_0(_S1006, _S1006, _S1006, _S1006);
    var _S1008 : LayersBehind_0 = LayersBehind_x24init_0(_S1006, _S1006);
    var found_1 : LayeredAlbedos_0 = LayeredAlbedos_x24init_0(FamilyAlbedos_x24init_0(_S1007, _S1007), _S1008);
    var _S1009 : LayerSums_0 = LayerSums_x24init_0(_S1007, 0.0f, _S1008);
    var warp_10 : LayerSums_0 = _S1009;
    var weft_10 : LayerSums_0 = _S1009;
    var number_14 : u32 = u32(0);
    for(;;)
    {
        if(number_14 < (plane_count_0(_S997)))
        {
        }
        else
        {
            break;
        }
        var _S1010 : FamilyAlbedos_0 = albedos_in_0(plane_of_0(_S997, number_14), _S998.centre_0, _S1005, _S1000);
        if(!is_layered_0(_S997))
        {
            found_1.albedos_2 = _S1010;
            return found_1;
        }
        var _S1011 : f32 = select(1.0f - _S999.weight_10, 1.0f, number_14 == (_S999.number_13));
        var stack_0 : u32 = u32(0);
        for(;;)
        {
            if(stack_0 < (fabrics_0[_S997].stacks_0))
            {
            }
            else
            {
                break;
            }
            var _S1012 : f32 = stack_share_0(_S997, _S998.centre_0, _S1005, stack_0);
            var _S1013 : u32 = fabrics_0[_S997].plane_shares_0 + u32(144) * (u32(2) * (stack_0 * fabrics_0[_S997].planes_0 + number_14) + select(u32(0), u32(1), _S1000));
            var _S1014 : LayerSums_0 = with_seen_0(warp_10, _S1010.warp_6, families_0[fabrics_0[_S997].warp_0].layer_through_0, _S1013, _S1012, _S1011, _S1001, _S1002);
            var _S1015 : LayerSums_0 = with_seen_0(weft_10, _S1010.weft_6, families_0[fabrics_0[_S997].weft_0].layer_through_0, _S1013 + u32(72), _S1012, _S1011, _S1001, _S1002);
            var _S1016 : u32 = stack_0 + u32(1);
            warp_10 = _S1014;
            weft_10 = _S1015;
            stack_0 = _S1016;
        }
        number_14 = number_14 + u32(1);
    }
    found_1.albedos_2.warp_6 = divided_0(warp_10.albedos_4, warp_10.weight_3);
    found_1.albedos_2.weft_6 = divided_0(weft_10.albedos_4, weft_10.weight_3);
    found_1.behind_0.reflected_0 = warp_10.behind_2.reflected_0 + weft_10.behind_2.reflected_0;
    found_1.behind_0.transmitted_0 = warp_10.behind_2.transmitted_0 + weft_10.behind_2.transmitted_0;
    return found_1;
}

fn toned_0( _S1017 : u32,  _S1018 : u32,  _S1019 : Albedos_0,  _S1020 : vec4<f32>) -> Albedos_0
{
    var _S1021 : vec3<f32> = _S1019.diffuse_reflect_0 + _S1019.diffuse_transmit_0;
    var _S1022 : vec3<f32> = vec3<f32>(1.0f);
    var _S1023 : vec3<f32> = _S1022 - vec3<f32>(fabrics_0[_S1017].layer_bound_0) * max(_S1019.specular_reflect_0, _S1019.specular_transmit_0);
    var _S1024 : vec3<f32> = vec3<f32>(0.0f);
    var _S1025 : vec3<f32> = max(_S1022 - _S1021, _S1024) / (_S1022 + _S1021);
    var _S1026 : vec3<f32> = vec3<f32>(9.99999997475242708e-07f);
    var _S1027 : vec3<f32> = (_S1023 / max(_S1021, _S1026) - _S1022) / max(vec3<f32>(0.89999997615814209f) * _S1025, _S1026);
    var _S1028 : vec3<f32> = _S1022 - vec3<f32>((saturate(min(min(_S1027.x, _S1027.y), _S1027.z)) * _S1020.z)) * _S1025;
    var _S1029 : vec3<f32> = min(vec3<f32>(families_0[_S1018].nep_red_0, families_0[_S1018].nep_green_0, families_0[_S1018].nep_blue_0), _S1023);
    var found_2 : Albedos_0 = _S1019;
    var _S1030 : f32 = _S1020.w;
    var _S1031 : vec3<f32> = _S1028 * _S1019.diffuse_transmit_0 * vec3<f32>((1.0f - _S1030));
    found_2.diffuse_transmit_0 = _S1031;
    found_2.diffuse_reflect_0 = clamp(mix(_S1028 * _S1019.diffuse_reflect_0, _S1029, vec3<f32>(_S1030)), _S1024, max(_S1023 - _S1031, _S1024));
    return found_2;
}

fn with_tones_0( _S1032 : u32,  _S1033 : FamilyAlbedos_0,  _S1034 : Yarns_0) -> FamilyAlbedos_0
{
    if((fabrics_0[_S1032].is_irregular_0) == u32(0))
    {
        return _S1033;
    }
    var result_9 : FamilyAlbedos_0;
    result_9.warp_6 = toned_0(_S1032, fabrics_0[_S1032].warp_0, _S1033.warp_6, _S1034.warp_4);
    result_9.weft_6 = toned_0(_S1032, fabrics_0[_S1032].weft_0, _S1033.weft_6, _S1034.weft_4);
    return result_9;
}

fn detail_gain_0( _S1035 : u32,  _S1036 : u32,  _S1037 : SurfacePoint_0,  _S1038 : bool,  _S1039 : u32,  _S1040 : f32) -> vec2<f32>
{
    var _S1041 : vec2<f32> = vec2<f32>(0.0f);
    var gain_2 : vec2<f32>;
    if((families_0[_S1036].has_plies_0) > 0.0f)
    {
        gain_2 = groove_0(0.94999998807907104f * fade_0(_S1040, 1.0f / families_0[_S1036].plies_per_mm_0), ply_offset_0(_S1036, _S1037, _S1038));
    }
    else
    {
        gain_2 = _S1041;
    }
    if((families_0[_S1036].fibre_tone_0) > 0.0f)
    {
        var _S1042 : FibreNoise_0 = fibre_noise_at_0(_S1035, _S1036, _S1037, _S1039, _S1040);
        var _S1043 : f32 = 4.5f * families_0[_S1036].fibre_tone_0;
        gain_2 = gain_2 + vec2<f32>(families_0[_S1036].fibre_tone_0) * vec2<f32>(_S1042.bundle_weight_0 * _S1042.bundle_0.y + _S1042.fibre_weight_0 * _S1042.fibre_0.y, _S1042.bundle_weight_0 + _S1042.fibre_weight_0) + (groove_0(_S1043 * (_S1042.bundle_weight_0 * (0.5f * (_S1042.bundle_0.x - 1.0f) + 1.0f)), _S1042.bundle_offset_0) + groove_0(_S1043 * _S1042.fibre_weight_0, _S1042.offset_2));
    }
    if((families_0[_S1036].slub_0) > 0.0f)
    {
        gain_2 = gain_2 + vec2<f32>((0.15000000596046448f * families_0[_S1036].slub_0 * fade_0(_S1040, 1.0f / families_0[_S1036].slubs_per_mm_0))) * vec2<f32>(wave_noise_0(hash_key_0(_S1039, ((fabrics_0[_S1035].seed_0) ^ (u32(1373058189)))), select(- _S1037.x_8, _S1037.y_2, _S1037.is_warp_0) * families_0[_S1036].slubs_per_mm_0).x, 1.0f);
    }
    return vec2<f32>(max(gain_2.x, -0.94999998807907104f), gain_2.y);
}

fn vary_albedos_0( _S1044 : u32,  _S1045 : Albedos_0,  _S1046 : u32,  _S1047 : u32,  _S1048 : vec2<f32>) -> Albedos_0
{
    var _S1049 : vec3<f32> = max(_S1045.specular_reflect_0, _S1045.specular_transmit_0);
    var _S1050 : vec3<f32> = _S1045.diffuse_reflect_0 + _S1045.diffuse_transmit_0;
    var _S1051 : vec3<f32> = vec3<f32>(fabrics_0[_S1044].layer_bound_0);
    var _S1052 : vec3<f32> = vec3<f32>(1.0f);
    var _S1053 : vec3<f32> = _S1052 - _S1051 * _S1049;
    var colour_1 : f32 = bounded_gain_0(thread_gain_0(_S1046, fabrics_0[_S1044].colour_noise_0, fabrics_0[_S1044].seed_0), _S1050, _S1053);
    var _S1054 : vec3<f32> = vec3<f32>((colour_1 * (1.0f + flattened_0(_S1048.y, vec3<f32>(colour_1) * _S1050, _S1053) * _S1048.x)));
    var _S1055 : f32 = bounded_gain_0(fibre_gain_0(_S1046, _S1047, fabrics_0[_S1044].fibre_noise_0, fabrics_0[_S1044].seed_0), _S1049, min((_S1052 - _S1054 * _S1050) / _S1051, vec3<f32>(1.0f)));
    var varied_0 : Albedos_0;
    varied_0.diffuse_reflect_0 = _S1054 * _S1045.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S1054 * _S1045.diffuse_transmit_0;
    var _S1056 : vec3<f32> = vec3<f32>(_S1055);
    varied_0.specular_reflect_0 = _S1056 * _S1045.specular_reflect_0;
    varied_0.specular_transmit_0 = _S1056 * _S1045.specular_transmit_0;
    return varied_0;
}

fn varied_at_0( _S1057 : u32,  _S1058 : SurfacePoint_0,  _S1059 : Albedos_0,  _S1060 : bool,  _S1061 : f32,  _S1062 : f32) -> Albedos_0
{
    var _S1063 : u32 = thread_number_0(_S1057, _S1058);
    var _S1064 : vec3<f32> = fibre_cell_0(_S1058.fibre_across_0, _S1058.fibre_along_0, fabrics_0[_S1057].fibre_size_0);
    var _S1065 : vec2<f32> = vec2<f32>(0.0f);
    var gain_3 : vec2<f32>;
    if((((fabrics_0[_S1057].has_detail_0) != u32(0)) & ((_S1061 >= 0.0f))))
    {
        gain_3 = detail_gain_0(_S1057, select(fabrics_0[_S1057].weft_0, fabrics_0[_S1057].warp_0, _S1058.is_warp_0), _S1058, _S1060, _S1063, _S1061) * vec2<f32>(1.0f - _S1062, 1.0f);
    }
    else
    {
        gain_3 = _S1065;
    }
    return vary_albedos_0(_S1057, _S1059, _S1063, u32(i32(_S1064.x)) * u32(65536) + u32(i32(floor(_S1064.y))), gain_3);
}

fn lobes_estimate_of_pass_0( _S1066 : u32,  _S1067 : Footprint_0,  _S1068 : f32,  _S1069 : vec2<f32>,  _S1070 : vec3<f32>,  _S1071 : vec3<f32>) -> Estimate_0
{
    var _S1072 : f32;
    var _S1073 : Regime_0 = regime_of_0(_S1066, _S1067, _S1068);
    var _S1074 : bool = (_S1071.z) < 0.0f;
    var _S1075 : vec3<f32> = to_face_frame_0(_S1071, _S1074);
    var _S1076 : f32 = Footprint_spread_side_0(_S1067);
    var _S1077 : bool = varies_at_0(_S1066, _S1076);
    var _S1078 : f32 = 1.0f - _S1073.prefiltered_0;
    var _S1079 : bool = ((_S1078 > 0.0f) & (((((((_S1077 | (((fabrics_0[_S1066].is_coloured_0) != u32(0))))) | ((is_layered_0(_S1066))))) | (((fabrics_0[_S1066].is_irregular_0) != u32(0)))))));
    var box_0 : Footprint_0 = _S1067;
    var _S1080 : vec3<f32> = vec3<f32>(0.0f);
    var _S1081 : SurfacePoint_0 = SurfacePoint_x24init_0(false, false, u32(0), u32(0), 0.0f, _S1080, _S1080, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, u32(0));
    var _S1082 : Components_0 = no_components_0();
    var close_1 : CloseUp_0 = no_close_up_0();
    var _S1083 : u32 = select(u32(1), u32(0), _S1079);
    var points_1 : Components_0 = _S1082;
    var central_0 : SurfacePoint_0 = _S1081;
    var central_weight_0 : f32 = 0.0f;
    var number_15 : u32 = _S1083;
    for(;;)
    {
        var _S1084 : f32 = f32(number_15);
        _S1072 = _S1073.points_0;
        if(_S1084 < (_S1073.points_0 + 1.0f))
        {
        }
        else
        {
            break;
        }
        var _S1085 : bool = number_15 == u32(0);
        var _S1086 : u32 = number_15 - u32(1);
        var _S1087 : vec2<f32> = POINT_OFFSETS_0[select(_S1086, u32(0), _S1085)] + _S1069;
        var _S1088 : vec2<f32> = select_vector_0(_S1085, vec2<f32>(0.0f), _S1087 - round(_S1087));
        var _S1089 : vec2<f32> = _S1067.centre_0 + vec2<f32>(_S1088.x) * _S1067.dx_0 + vec2<f32>(_S1088.y) * _S1067.dy_0;
        var _S1090 : SearchQuality_0 = quality_of_0(select(_S1073.threads_2, 0.0f, _S1085));
        var _S1091 : Hit_0 = first_hit_0(_S1066, _S1090, _S1089.x, _S1089.y, _S1075, _S1074);
        var _S1092 : SurfacePoint_0 = surface_met_0(_S1066, _S1091.x_21, _S1091.y_14, _S1091.height_9, _S1075, _S1074);
        if(_S1085)
        {
            var central_weight_1 : f32 = select(_S1078, 0.0f, _S1091.hole_7);
            box_0.centre_0 = mix(_S1067.centre_0, vec2<f32>(_S1091.x_21, _S1091.y_14), vec2<f32>(central_weight_1));
            central_0 = _S1092;
            central_weight_0 = central_weight_1;
            number_15 = number_15 + u32(1);
            continue;
        }
        var _S1093 : YarnPoint_0 = uncoloured_point_0(_S1066, _S1092, _S1075, _S1074, _S1091.hole_7, _S1076);
        var _S1094 : f32 = min(_S1073.points_0 - f32(_S1086), 1.0f);
        var _S1095 : Components_0 = with_added_0(points_1, components_of_point_0(_S1066, _S1090, _S1093, _S1070, _S1071), _S1094);
        if((fabrics_0[_S1066].openness_0) != u32(4294967295))
        {
            close_1.warp_1 = with_blocked_0(_S1066, close_1.warp_1, _S1093, true, _S1094);
            close_1.weft_1 = with_blocked_0(_S1066, close_1.weft_1, _S1093, false, _S1094);
        }
        points_1 = _S1095;
        number_15 = number_15 + u32(1);
    }
    close_1.weight_0 = _S1078;
    var _S1096 : f32 = max(_S1072, 1.0f);
    close_1.warp_1 = scaled_0(close_1.warp_1, 1.0f / _S1096);
    close_1.weft_1 = scaled_0(close_1.weft_1, 1.0f / _S1096);
    var estimate_0 : Estimate_0;
    estimate_0.close_0 = close_1;
    estimate_0.components_0 = with_added_0(_S1082, points_1, _S1078 / _S1096);
    if((_S1073.prefiltered_0) > 0.0f)
    {
        var _S1097 : Components_0 = prefiltered_components_0(_S1066, _S1067, to_face_frame_0(_S1070, _S1074), _S1075, _S1074);
        estimate_0.components_0 = with_added_0(estimate_0.components_0, _S1097, _S1073.prefiltered_0);
    }
    var _S1098 : Yarns_0 = yarns_over_0(_S1066, box_0, _S1074);
    estimate_0.components_0 = with_shares_0(_S1066, estimate_0.components_0, _S1098);
    var nearest_0 : NearestLayer_0;
    nearest_0.number_13 = central_0.layer_0;
    nearest_0.weight_10 = central_weight_0;
    var _S1099 : LayeredAlbedos_0 = layered_albedos_0(_S1066, box_0, nearest_0, _S1074, to_face_frame_0(_S1070, _S1074), _S1075);
    estimate_0.behind_4 = _S1099.behind_0;
    estimate_0.albedos_14 = with_tones_0(_S1066, _S1099.albedos_2, _S1098);
    if((_S1077 & ((central_weight_0 > 0.0f))))
    {
        var _S1100 : SurfacePoint_0 = central_0;
        var _S1101 : Albedos_0;
        if(central_0.is_warp_0)
        {
            _S1101 = estimate_0.albedos_14.warp_6;
        }
        else
        {
            _S1101 = estimate_0.albedos_14.weft_6;
        }
        var _S1102 : bool;
        if((fabrics_0[_S1066].has_detail_0) != u32(0))
        {
            _S1102 = has_hairs_0(_S1066);
        }
        else
        {
            _S1102 = false;
        }
        var cover_4 : f32;
        if(_S1102)
        {
            cover_4 = hair_towards_0(_S1066, hairs_over_0(_S1066, central_0, _S1074, _S1076), _S1075, _S1076).cover_1;
        }
        else
        {
            cover_4 = 0.0f;
        }
        var _S1103 : Albedos_0 = lerp_albedos_0(_S1101, varied_at_0(_S1066, central_0, _S1101, _S1074, _S1076, cover_4), central_weight_0);
        if(_S1100.is_warp_0)
        {
            estimate_0.albedos_14.warp_6 = _S1103;
        }
        else
        {
            estimate_0.albedos_14.weft_6 = _S1103;
        }
    }
    return estimate_0;
}

fn diffuse_kept_0( _S1104 : u32,  _S1105 : vec3<f32>,  _S1106 : vec3<f32>) -> f32
{
    return (1.0f - fabrics_0[_S1104].grazing_loss_0 * fourth_power_0(max(1.0f - abs(_S1105.z), 0.0f))) * (1.0f - fabrics_0[_S1104].grazing_loss_0 * fourth_power_0(max(1.0f - abs(_S1106.z), 0.0f)));
}

fn highlight_rise_0( _S1107 : u32,  _S1108 : vec3<f32>,  _S1109 : vec3<f32>) -> f32
{
    var _S1110 : f32 = 1.0f - sqrt(clamp(0.5f * dot(_S1108, _S1109) + 0.5f, 9.99999993922529029e-09f, 1.0f));
    return fabrics_0[_S1107].grazing_gain_0 * fourth_power_0(_S1110) * _S1110;
}

fn towards_grazing_0( _S1111 : u32,  _S1112 : Albedos_0,  _S1113 : vec3<f32>,  _S1114 : vec3<f32>) -> Albedos_0
{
    var _S1115 : f32 = diffuse_kept_0(_S1111, _S1113, _S1114);
    var result_10 : Albedos_0 = _S1112;
    var _S1116 : vec3<f32> = vec3<f32>(_S1115);
    result_10.diffuse_reflect_0 = result_10.diffuse_reflect_0 * _S1116;
    result_10.diffuse_transmit_0 = result_10.diffuse_transmit_0 * _S1116;
    result_10.specular_reflect_0 = result_10.specular_reflect_0 + vec3<f32>(highlight_rise_0(_S1111, _S1113, _S1114));
    return result_10;
}

fn scattered_by_0( _S1117 : u32,  _S1118 : Albedos_0,  _S1119 : u32,  _S1120 : vec3<f32>) -> Scattered_0
{
    var _S1121 : u32 = u32(159) + u32(2) * _S1119;
    var yarn_4 : Scattered_0;
    yarn_4.back_14 = _S1120 * _S1118.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S1117, _S1121)) * _S1118.specular_reflect_0;
    yarn_4.through_1 = _S1120 * _S1118.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S1117, _S1121 + u32(1))) * _S1118.specular_transmit_0;
    return yarn_4;
}

fn sent_0( _S1122 : u32,  _S1123 : u32,  _S1124 : vec3<f32>,  _S1125 : vec3<f32>,  _S1126 : vec3<f32>,  _S1127 : vec3<f32>,  _S1128 : ptr<function, vec3<f32>>,  _S1129 : ptr<function, vec3<f32>>)
{
    var _S1130 : u32 = u32(146) + u32(4) * _S1123;
    var _S1131 : f32 = openness_number_0(_S1122, _S1130 + u32(1));
    var _S1132 : f32 = openness_number_0(_S1122, _S1130 + u32(2));
    var _S1133 : vec3<f32> = vec3<f32>(1.0f);
    var _S1134 : vec3<f32> = _S1133 - _S1126 * vec3<f32>(openness_number_0(_S1122, _S1130));
    var _S1135 : vec3<f32> = _S1133 - _S1127 * vec3<f32>(openness_number_0(_S1122, _S1130 + u32(3)));
    var _S1136 : vec3<f32> = _S1133 / (_S1134 * _S1135 - _S1126 * _S1127 * vec3<f32>((_S1131 * _S1132)));
    (*_S1128) = (_S1124 * _S1135 + _S1126 * vec3<f32>(_S1131) * _S1125) * _S1136;
    (*_S1129) = (_S1125 * _S1134 + _S1127 * vec3<f32>(_S1132) * _S1124) * _S1136;
    return;
}

fn face_sends_0( _S1137 : u32,  _S1138 : u32,  _S1139 : Scattered_0,  _S1140 : Scattered_0) -> FaceSends_0
{
    var _S1141 : u32 = u32(2) * _S1138;
    var _S1142 : u32 = u32(142) + _S1141;
    var _S1143 : f32 = openness_number_0(_S1137, _S1142);
    var _S1144 : f32 = openness_number_0(_S1137, _S1142 + u32(1));
    var _S1145 : vec3<f32> = vec3<f32>((1.0f - _S1143)) * _S1139.back_14;
    var _S1146 : vec3<f32> = vec3<f32>((1.0f - _S1144)) * _S1140.back_14;
    var sends_1 : FaceSends_0;
    var _S1147 : u32 = u32(154) + _S1141;
    var _S1148 : f32 = openness_number_0(_S1137, _S1147);
    sends_1.blocks_warp_0 = _S1148;
    var _S1149 : f32 = openness_number_0(_S1137, _S1147 + u32(1));
    sends_1.blocks_weft_0 = _S1149;
    sends_1.open_0 = _S1148 * _S1143 + _S1149 * _S1144;
    var _S1150 : vec3<f32> = vec3<f32>(_S1143) * _S1139.back_14;
    var _S1151 : vec3<f32> = vec3<f32>(_S1144) * _S1140.back_14;
    var _S1152 : vec3<f32> = sends_1.sky_warp_0;
    var _S1153 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S1137, _S1138, _S1150, _S1151, _S1145, _S1146, &(_S1152), &(_S1153));
    sends_1.sky_warp_0 = _S1152;
    sends_1.sky_weft_0 = _S1153;
    var _S1154 : vec3<f32> = sends_1.crossing_warp_0;
    var _S1155 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S1137, _S1138, _S1139.through_1, _S1140.through_1, _S1145, _S1146, &(_S1154), &(_S1155));
    sends_1.crossing_warp_0 = _S1154;
    sends_1.crossing_weft_0 = _S1155;
    return sends_1;
}

fn interior_between_0( _S1156 : u32,  _S1157 : u32,  _S1158 : u32,  _S1159 : vec3<f32>,  _S1160 : bool) -> Interior_0
{
    var _S1161 : Scattered_0 = scattered_by_0(_S1156, table_albedos_0(_S1157), u32(0), _S1159);
    var _S1162 : Scattered_0 = scattered_by_0(_S1156, table_albedos_0(_S1158), u32(1), _S1159);
    var _S1163 : FaceSends_0 = face_sends_0(_S1156, select(u32(0), u32(1), _S1160), _S1161, _S1162);
    var _S1164 : FaceSends_0 = face_sends_0(_S1156, select(u32(1), u32(0), _S1160), _S1161, _S1162);
    var _S1165 : vec3<f32> = vec3<f32>(_S1163.blocks_warp_0);
    var _S1166 : vec3<f32> = vec3<f32>(_S1163.blocks_weft_0);
    var _S1167 : vec3<f32> = _S1165 * _S1163.crossing_warp_0 + _S1166 * _S1163.crossing_weft_0;
    var _S1168 : vec3<f32> = vec3<f32>(_S1164.blocks_warp_0);
    var _S1169 : vec3<f32> = vec3<f32>(_S1164.blocks_weft_0);
    var _S1170 : vec3<f32> = _S1168 * _S1164.crossing_warp_0 + _S1169 * _S1164.crossing_weft_0;
    var _S1171 : f32 = 1.0f - _S1163.open_0;
    var _S1172 : f32 = 1.0f - _S1164.open_0;
    var _S1173 : vec3<f32> = vec3<f32>(1.0f);
    var _S1174 : vec3<f32> = _S1173 / (_S1173 - _S1167 * _S1170 * vec3<f32>((_S1171 * _S1172)));
    var _S1175 : vec3<f32> = _S1170 * (vec3<f32>(_S1163.open_0) + vec3<f32>(_S1171) * (_S1165 * _S1163.sky_warp_0 + _S1166 * _S1163.sky_weft_0)) * _S1174;
    var _S1176 : vec3<f32> = _S1167 * (vec3<f32>(_S1164.open_0) + vec3<f32>(_S1172) * (_S1168 * _S1164.sky_warp_0 + _S1169 * _S1164.sky_weft_0)) * _S1174;
    var _S1177 : FaceRadiance_0 = face_radiance_0(_S1163, _S1164.open_0, _S1175, _S1176);
    var _S1178 : FaceRadiance_0 = face_radiance_0(_S1164, _S1163.open_0, _S1176, _S1175);
    var interior_1 : Interior_0;
    interior_1.warp_9 = _S1177.warp_8;
    interior_1.weft_9 = _S1177.weft_8;
    interior_1.leaked_1 = _S1177.leaked_0;
    interior_1.far_1 = _S1178.mean_1;
    interior_1.far_leaked_0 = _S1178.leaked_0;
    return interior_1;
}

fn interior_of_0( _S1179 : u32,  _S1180 : vec3<f32>,  _S1181 : bool) -> Interior_0
{
    return interior_between_0(_S1179, families_0[fabrics_0[_S1179].warp_0].cloth_mean_0, families_0[fabrics_0[_S1179].weft_0].cloth_mean_0, _S1180, _S1181);
}

fn blocked_from_0( _S1182 : u32,  _S1183 : vec3<f32>,  _S1184 : bool,  _S1185 : bool) -> Blocked_0
{
    var terms_6 : array<f32, i32(6)>;
    view_terms_0(_S1183, &(terms_6));
    return blocked_of_terms_0(_S1182, (select(u32(0), u32(2), _S1185) + select(u32(1), u32(0), _S1184)) * u32(15), terms_6, u32(5));
}

fn warp_seen_from_0( _S1186 : u32,  _S1187 : vec3<f32>,  _S1188 : bool) -> f32
{
    var terms_7 : array<f32, i32(6)>;
    view_terms_1(_S1187, &(terms_7));
    var term_3 : u32 = u32(0);
    var share_6 : f32 = 0.0f;
    for(;;)
    {
        if(term_3 < u32(5))
        {
        }
        else
        {
            break;
        }
        var share_7 : f32 = share_6 + openness_number_0(_S1186, u32(132) + select(u32(0), u32(5), _S1188) + term_3) * terms_7[term_3];
        term_3 = term_3 + u32(1);
        share_6 = share_7;
    }
    return saturate(share_6);
}

fn bounced_of_families_0( _S1189 : u32,  _S1190 : FamilyAlbedos_0,  _S1191 : vec3<f32>,  _S1192 : Interior_0,  _S1193 : Blocked_0,  _S1194 : Blocked_0) -> Bounced_0
{
    return sum_of_0(bounced_by_0(_S1193, scattered_by_0(_S1189, _S1190.warp_6, u32(0), _S1191), _S1192), bounced_by_0(_S1194, scattered_by_0(_S1189, _S1190.weft_6, u32(1), _S1191), _S1192));
}

fn bounced_far_0( _S1195 : u32,  _S1196 : FamilyAlbedos_0,  _S1197 : vec3<f32>,  _S1198 : Interior_0,  _S1199 : vec3<f32>,  _S1200 : bool,  _S1201 : f32,  _S1202 : f32,  _S1203 : f32) -> Bounced_0
{
    var _S1204 : Blocked_0 = blocked_from_0(_S1195, _S1199, true, _S1200);
    var _S1205 : Blocked_0 = blocked_from_0(_S1195, _S1199, false, _S1200);
    var _S1206 : f32 = _S1201 / max(1.0f - _S1204.by_warp_0 - _S1204.by_weft_0, 0.10000000149011612f);
    var _S1207 : f32 = (0.0020000000949949f * warp_seen_from_0(_S1195, _S1199, _S1200) + _S1206) / (_S1206 + _S1202 / max(1.0f - _S1205.by_warp_0 - _S1205.by_weft_0, 0.10000000149011612f) + 0.0020000000949949f);
    var _S1208 : f32 = 1.0f - _S1203;
    return bounced_of_families_0(_S1195, _S1196, _S1197, _S1198, scaled_0(_S1204, _S1207 * _S1208), scaled_0(_S1205, (1.0f - _S1207) * _S1208));
}

fn bounced_over_0( _S1209 : u32,  _S1210 : Components_0,  _S1211 : CloseUp_0,  _S1212 : FamilyAlbedos_0,  _S1213 : vec3<f32>,  _S1214 : vec3<f32>) -> Bounced_0
{
    var _S1215 : bool = (_S1214.z) < 0.0f;
    var _S1216 : Interior_0 = interior_of_0(_S1209, _S1213, _S1215);
    var bounced_2 : Bounced_0 = bounced_far_0(_S1209, _S1212, _S1213, _S1216, to_face_frame_0(_S1214, _S1215), _S1215, _S1210.diffuse_warp_0, _S1210.diffuse_weft_0, _S1210.hole_2);
    if((_S1211.weight_0) > 0.0f)
    {
        var _S1217 : Bounced_0 = bounced_of_families_0(_S1209, _S1212, _S1213, _S1216, _S1211.warp_1, _S1211.weft_1);
        var _S1218 : vec3<f32> = vec3<f32>(_S1211.weight_0);
        bounced_2.reflected_2 = mix(bounced_2.reflected_2, _S1217.reflected_2, _S1218);
        bounced_2.transmitted_2 = mix(bounced_2.transmitted_2, _S1217.transmitted_2, _S1218);
    }
    return bounced_2;
}

fn composed_before_0( _S1219 : u32,  _S1220 : Components_0,  _S1221 : CloseUp_0,  _S1222 : FamilyAlbedos_0,  _S1223 : LayersBehind_0,  _S1224 : vec3<f32>,  _S1225 : vec3<f32>,  _S1226 : vec3<f32>) -> vec3<f32>
{
    var _S1227 : Albedos_0 = towards_grazing_0(_S1219, tinted_0(_S1222.warp_6, _S1224), _S1225, _S1226);
    var _S1228 : Albedos_0 = towards_grazing_0(_S1219, tinted_0(_S1222.weft_6, _S1224), _S1225, _S1226);
    var _S1229 : vec3<f32> = vec3<f32>(_S1220.diffuse_warp_0);
    var _S1230 : vec3<f32> = vec3<f32>(_S1220.diffuse_weft_0);
    var _S1231 : vec3<f32> = vec3<f32>(_S1220.specular_warp_0);
    var _S1232 : vec3<f32> = vec3<f32>(_S1220.specular_weft_0);
    var _S1233 : vec3<f32> = _S1227.diffuse_reflect_0 * _S1229 + _S1228.diffuse_reflect_0 * _S1230 + _S1227.specular_reflect_0 * _S1231 + _S1228.specular_reflect_0 * _S1232;
    var _S1234 : f32 = _S1225.z;
    var _S1235 : f32 = _S1226.z;
    var _S1236 : bool = (_S1234 * _S1235) < 0.0f;
    var body_0 : vec3<f32>;
    if(_S1236)
    {
        body_0 = _S1227.diffuse_transmit_0 * _S1229 + _S1228.diffuse_transmit_0 * _S1230 + _S1227.specular_transmit_0 * _S1231 + _S1228.specular_transmit_0 * _S1232;
    }
    else
    {
        body_0 = _S1233;
    }
    if((fabrics_0[_S1219].openness_0) != u32(4294967295))
    {
        body_0 = body_0 + bounced_value_0(bounced_over_0(_S1219, _S1220, _S1221, _S1222, _S1224, _S1226), _S1225, _S1226) * vec3<f32>(diffuse_kept_0(_S1219, _S1225, _S1226));
    }
    if(is_layered_0(_S1219))
    {
        body_0 = body_0 + _S1224 * select_vector_1(_S1236, _S1223.transmitted_0, _S1223.reflected_0) * vec3<f32>((abs(_S1234) * 0.31830987334251404f)) * vec3<f32>(diffuse_kept_0(_S1219, _S1225, _S1226));
    }
    var _S1237 : f32 = fabrics_0[_S1219].sheen_strength_0;
    if((fabrics_0[_S1219].sheen_strength_0) <= 0.0f)
    {
        return body_0;
    }
    var _S1238 : bool = _S1235 < 0.0f;
    var _S1239 : vec2<f32> = sheen_with_transmittance_0(to_face_frame_0(_S1225, _S1238), to_face_frame_0(_S1226, _S1238), _S1237, fabrics_0[_S1219].sheen_roughness_0);
    return vec3<f32>(_S1239.y) * body_0 + vec3<f32>(((_S1220.light_visibility_1 + _S1220.hole_2) * _S1239.x));
}

fn light_of_footprint_0( _S1240 : u32,  _S1241 : VisiblePoint_0,  _S1242 : vec2<u32>,  _S1243 : vec3<f32>) -> vec4<f32>
{
    var footprint_0 : Footprint_0;
    footprint_0.dx_0 = _S1241.draft_dx_0;
    footprint_0.dy_0 = _S1241.draft_dy_0;
    footprint_0.centre_0 = irregular_place_0(_S1240, _S1241.draft_0, Footprint_spread_side_0(footprint_0));
    var _S1244 : vec2<f32> = fract(vec2<f32>(f32(((frame_record_0.pass_number_0) & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
    var _S1245 : vec3<f32> = to_local_0(_S1241, _S1241.view_0);
    var _S1246 : u32 = light_sample_count_0();
    var _S1247 : vec3<f32> = vec3<f32>(0.0f);
    var number_16 : u32 = u32(0);
    var radiance_1 : vec3<f32> = _S1247;
    var hole_8 : f32 = 0.0f;
    for(;;)
    {
        if(number_16 < (max(_S1246, u32(1))))
        {
        }
        else
        {
            break;
        }
        var _S1248 : f32;
        if(number_16 < _S1246)
        {
            _S1248 = visibility_at_0(number_16, _S1242);
        }
        else
        {
            _S1248 = 0.0f;
        }
        var _S1249 : bool;
        if(_S1248 <= 0.0f)
        {
            _S1249 = number_16 > u32(0);
        }
        else
        {
            _S1249 = false;
        }
        if(_S1249)
        {
            number_16 = number_16 + u32(1);
            continue;
        }
        var _S1250 : LightSample_0 = light_sample_0(number_16, _S1242, _S1241.position_4);
        var _S1251 : vec3<f32> = to_local_0(_S1241, _S1250.towards_0);
        var _S1252 : Estimate_0 = lobes_estimate_of_pass_0(_S1240, footprint_0, 1.0f, _S1244, _S1251, _S1245);
        radiance_1 = radiance_1 + vec3<f32>(_S1248) * _S1250.irradiance_1 * composed_before_0(_S1240, _S1252.components_0, _S1252.close_0, _S1252.albedos_14, _S1252.behind_4, _S1243, _S1251, _S1245);
        hole_8 = _S1252.components_0.hole_2;
        number_16 = number_16 + u32(1);
    }
    var _S1253 : f32 = fabrics_0[_S1240].sheen_strength_0;
    if((fabrics_0[_S1240].sheen_strength_0) > 0.0f)
    {
        hole_8 = hole_8 * (1.0f - _S1253 * sheen_lobe_0(abs(_S1245.z), fabrics_0[_S1240].sheen_roughness_0).z);
    }
    return vec4<f32>(radiance_1, 1.0f - hole_8);
}

@compute
@workgroup_size(8, 8, 1)
fn shade_lobes(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S1254 : u32 = id_0.x;
    var _S1255 : bool;
    if(_S1254 >= (frame_record_0.width_0))
    {
        _S1255 = true;
    }
    else
    {
        _S1255 = (id_0.y) >= (frame_record_0.height_0);
    }
    if(_S1255)
    {
        return;
    }
    var _S1256 : u32 = id_0.y * frame_record_0.width_0 + _S1254;
    var _S1257 : u32 = layers_0[_S1256].face_0;
    if((layers_0[_S1256].face_0) == u32(0))
    {
        return;
    }
    var _S1258 : u32 = _S1257 - u32(1);
    var _S1259 : u32 = fabric_of_0(_S1258);
    var _S1260 : vec2<u32> = id_0.xy;
    var _S1261 : VisiblePoint_0 = visible_point_0(_S1259, _S1258, _S1260);
    var _S1262 : vec4<f32> = light_of_footprint_0(_S1259, _S1261, _S1260, filtered_albedo_0(_S1259, _S1261));
    accumulate_0(_S1256, _S1262);
    return;
}

