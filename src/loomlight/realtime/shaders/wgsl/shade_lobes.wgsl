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
};

fn SurfacePoint_x24init_0( hole_1 : bool,  is_warp_1 : bool,  warp_thread_1 : u32,  weft_thread_1 : u32,  height_3 : f32,  normal_2 : vec3<f32>,  tangent_1 : vec3<f32>,  across_2 : f32,  fibre_across_1 : f32,  fibre_along_1 : f32,  x_9 : f32,  y_3 : f32,  shown_share_1 : f32,  plane_1 : f32) -> SurfacePoint_0
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
    var _S281 : Cell_0 = locate_0(family_15, position_7);
    var _S282 : f32 = table_number_0(families_0[family_15].before_0 + u32(2) * _S281.thread_1 + u32(1));
    var bound_0 : Bound_0;
    bound_0.thread_9 = _S281.thread_1;
    bound_0.turns_2 = round((position_7 - families_0[family_15].start_0 - _S282 - _S281.below_0) * families_0[family_15].inverse_period_0);
    bound_0.cell_11 = _S281.below_0;
    var _S283 : f32 = 2.0f * _S281.half_width_1;
    bound_0.width_4 = _S283;
    bound_0.visible_0 = clamp((_S281.across_0 + _S281.half_width_1) / _S283, 0.0f, 1.0f);
    bound_0.gap_0 = min(_S281.below_0, _S281.below_0 - _S281.across_0 - _S281.half_width_1) + max(_S281.across_0 - _S281.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
     low_1 : Bound_0,
     high_1 : Bound_0,
};

fn stretch_of_0( family_16 : u32,  centre_1 : f32,  size_5 : f32) -> Stretch_0
{
    var _S284 : f32 = centre_1 - floor((centre_1 - families_0[family_16].start_0) * families_0[family_16].inverse_period_0) * families_0[family_16].period_0;
    var _S285 : f32 = 0.5f * max(size_5, families_0[family_16].smallest_box_0);
    var stretch_0 : Stretch_0;
    stretch_0.low_1 = bound_at_0(family_16, _S284 - _S285);
    stretch_0.high_1 = bound_at_0(family_16, _S284 + _S285);
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
    var _S286 : f32 = Stretch_turns_0(stretch_1);
    var _S287 : u32 = families_0[family_17].before_0 + u32(2) * stretch_1.low_1.thread_9;
    var _S288 : u32 = families_0[family_17].before_0 + u32(2) * stretch_1.high_1.thread_9;
    var _S289 : f32 = table_number_0(_S288) - table_number_0(_S287);
    var _S290 : f32 = table_number_0(_S288 + u32(1)) - table_number_0(_S287 + u32(1));
    return vec3<f32>(_S289 + stretch_1.high_1.visible_0 * stretch_1.high_1.width_4 - stretch_1.low_1.visible_0 * stretch_1.low_1.width_4 + _S286 * families_0[family_17].visible_total_0, _S290 - _S289 + stretch_1.high_1.gap_0 - stretch_1.low_1.gap_0 + _S286 * (families_0[family_17].period_0 - families_0[family_17].visible_total_0), _S290 + stretch_1.high_1.cell_11 - stretch_1.low_1.cell_11 + _S286 * families_0[family_17].period_0);
}

fn integrals_along_0( family_18 : u32,  stretch_2 : Stretch_0,  quantity_0 : u32) -> vec2<f32>
{
    var _S291 : u32 = u32(3) * families_0[family_18].quantities_0;
    var _S292 : u32 = families_0[family_18].colour_threads_0 + _S291 * stretch_2.low_1.thread_9 + quantity_0;
    var _S293 : u32 = families_0[family_18].colour_threads_0 + _S291 * stretch_2.high_1.thread_9 + quantity_0;
    var _S294 : u32 = families_0[family_18].colour_threads_0 + _S291 * u32(families_0[family_18].count_0) + quantity_0;
    var _S295 : f32 = table_number_0(_S292);
    var _S296 : f32 = table_number_0(_S293);
    var _S297 : f32 = Stretch_turns_0(stretch_2);
    var _S298 : u32 = u32(2) * families_0[family_18].quantities_0;
    return vec2<f32>(table_number_0(_S293 + families_0[family_18].quantities_0) - table_number_0(_S292 + families_0[family_18].quantities_0) + _S296 * stretch_2.high_1.visible_0 * stretch_2.high_1.width_4 - _S295 * stretch_2.low_1.visible_0 * stretch_2.low_1.width_4 + _S297 * table_number_0(_S294 + families_0[family_18].quantities_0), table_number_0(_S293 + _S298) - table_number_0(_S292 + _S298) + _S296 * stretch_2.high_1.cell_11 - _S295 * stretch_2.low_1.cell_11 + _S297 * table_number_0(_S294 + _S298));
}

fn Stretch_wraps_0( this_7 : Stretch_0) -> bool
{
    return (this_7.high_1.thread_9) < (this_7.low_1.thread_9);
}

fn Stretch_differences_0( this_8 : Stretch_0,  entries_0 : vec4<u32>,  whole_0 : u32) -> vec4<u32>
{
    var _S299 : u32 = entries_0.z;
    var _S300 : u32 = entries_0.x;
    return vec4<u32>(_S299 - _S300 + select(u32(0), whole_0, Stretch_wraps_0(this_8)), entries_0.w - _S299, entries_0.y - _S300, whole_0);
}

fn row_differences_0( across_5 : Stretch_0,  row_3 : u32,  count_3 : u32,  quantities_1 : u32) -> vec4<u32>
{
    var _S301 : u32 = row_3 + across_5.low_1.thread_9 * quantities_1;
    var _S302 : u32 = row_3 + across_5.high_1.thread_9 * quantities_1;
    return Stretch_differences_0(across_5, vec4<u32>(words_0[_S301], words_0[_S301 + quantities_1], words_0[_S302], words_0[_S302 + quantities_1]), words_0[row_3 + count_3 * quantities_1]);
}

fn Stretch_weights_0( this_9 : Stretch_0) -> vec4<f32>
{
    return vec4<f32>(1.0f, this_9.high_1.visible_0, - this_9.low_1.visible_0, Stretch_turns_0(this_9) - select(0.0f, 1.0f, Stretch_wraps_0(this_9)));
}

fn integral_on_top_0( family_19 : u32,  across_6 : Stretch_0,  along_3 : Stretch_0,  crossing_count_0 : u32,  quantity_1 : u32) -> f32
{
    var _S303 : u32 = u32(families_0[family_19].count_0);
    var _S304 : u32 = (_S303 + u32(1)) * families_0[family_19].quantities_0;
    var _S305 : u32 = families_0[family_19].colour_areas_0 + quantity_1;
    var _S306 : vec4<u32> = row_differences_0(across_6, _S305 + along_3.low_1.thread_9 * _S304, _S303, families_0[family_19].quantities_0);
    var _S307 : vec4<u32> = row_differences_0(across_6, _S305 + along_3.high_1.thread_9 * _S304, _S303, families_0[family_19].quantities_0);
    var _S308 : vec4<u32> = row_differences_0(across_6, _S305 + crossing_count_0 * _S304, _S303, families_0[family_19].quantities_0);
    var _S309 : vec4<f32> = Stretch_weights_0(across_6);
    return dot(vec4<f32>(dot(vec4<f32>(vec4<i32>(_S307 - _S306 + select_vector_2(Stretch_wraps_0(along_3), _S308, vec4<u32>(vec4<i32>(i32(0)))))), _S309), dot(vec4<f32>(vec4<i32>(row_differences_0(across_6, _S305 + (along_3.high_1.thread_9 + u32(1)) * _S304, _S303, families_0[family_19].quantities_0) - _S307)), _S309), dot(vec4<f32>(vec4<i32>(row_differences_0(across_6, _S305 + (along_3.low_1.thread_9 + u32(1)) * _S304, _S303, families_0[family_19].quantities_0) - _S306)), _S309), dot(vec4<f32>(vec4<i32>(_S308)), _S309)), Stretch_weights_0(along_3)) * families_0[family_19].area_unit_0;
}

fn with_added_albedos_0( albedos_3 : Albedos_0,  weight_3 : f32,  row_4 : u32) -> Albedos_0
{
    var _S310 : Albedos_0 = table_albedos_0(row_4);
    var sum_0 : Albedos_0;
    var _S311 : vec3<f32> = vec3<f32>(weight_3);
    sum_0.diffuse_reflect_0 = albedos_3.diffuse_reflect_0 + _S311 * _S310.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_3.diffuse_transmit_0 + _S311 * _S310.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_3.specular_reflect_0 + _S311 * _S310.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_3.specular_transmit_0 + _S311 * _S310.specular_transmit_0;
    return sum_0;
}

fn mean_albedos_0( family_20 : u32,  crossing_4 : u32,  own_1 : Stretch_0,  other_2 : Stretch_0,  back_12 : bool) -> Albedos_0
{
    var albedos_4 : Albedos_0 = table_albedos_0(families_0[family_20].colour_mean_0);
    if((families_0[family_20].quantities_0) == u32(1))
    {
        return albedos_4;
    }
    var _S312 : vec3<f32> = lengths_0(crossing_4, other_2);
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
        var _S313 : vec2<f32> = integrals_along_0(family_20, own_1, quantity_2);
        var _S314 : f32 = integral_on_top_0(family_20, own_1, other_2, u32(families_0[crossing_4].count_0), quantity_2);
        var _S315 : f32 = _S313.x;
        var _S316 : f32 = _S315 * _S312.x;
        var _S317 : f32 = select(_S314, _S316 - _S314, back_12);
        var _S318 : bool = quantity_2 == u32(0);
        if(_S318)
        {
            is_exposed_0 = _S317 > (16.0f * families_0[family_20].area_unit_0 * min(_S316 / families_0[family_20].crossing_area_0, 1.0f) + 0.00000999999974738f * _S316);
        }
        var _S319 : f32 = _S315 * _S312.y + select(0.0f, _S317, is_exposed_0) + 0.000244140625f * _S312.z * _S313.y;
        if(_S318)
        {
            weight_4 = 1.0f / max(_S319, 9.99999968265522539e-21f);
        }
        else
        {
            albedos_4 = with_added_albedos_0(albedos_4, _S319 * weight_4, families_0[family_20].colour_axes_0 + u32(12) * (quantity_2 - u32(1)));
        }
        quantity_2 = quantity_2 + u32(1);
    }
    albedos_4.diffuse_reflect_0 = saturate(albedos_4.diffuse_reflect_0);
    albedos_4.diffuse_transmit_0 = saturate(albedos_4.diffuse_transmit_0);
    albedos_4.specular_reflect_0 = saturate(albedos_4.specular_reflect_0);
    albedos_4.specular_transmit_0 = saturate(albedos_4.specular_transmit_0);
    return albedos_4;
}

fn albedos_in_0( plane_8 : Plane_0,  centre_2 : vec2<f32>,  size_6 : vec2<f32>,  back_13 : bool) -> FamilyAlbedos_0
{
    var _S320 : Stretch_0 = stretch_of_0(plane_8.warp_2, centre_2.x - plane_8.start_x_0, size_6.x);
    var _S321 : Stretch_0 = stretch_of_0(plane_8.weft_2, centre_2.y - plane_8.start_y_0, size_6.y);
    var albedos_5 : FamilyAlbedos_0;
    albedos_5.warp_6 = mean_albedos_0(plane_8.warp_2, plane_8.weft_2, _S320, _S321, back_13);
    albedos_5.weft_6 = mean_albedos_0(plane_8.weft_2, plane_8.warp_2, _S321, _S320, back_13);
    return albedos_5;
}

struct PlaneShares_0
{
     area_0 : f32,
     passed_0 : vec3<f32>,
     added_0 : vec3<f32>,
};

fn PlaneShares_x24init_0( area_1 : f32,  passed_1 : vec3<f32>,  added_1 : vec3<f32>) -> PlaneShares_0
{
    var _S322 : PlaneShares_0;
    _S322.area_0 = area_1;
    _S322.passed_0 = passed_1;
    _S322.added_0 = added_1;
    return _S322;
}

fn with_shares_at_0( sums_6 : PlaneShares_0,  share_4 : f32,  first_6 : u32) -> PlaneShares_0
{
    var result_2 : PlaneShares_0;
    result_2.area_0 = sums_6.area_0 + share_4 * table_number_0(first_6);
    var _S323 : vec3<f32> = vec3<f32>(share_4);
    result_2.passed_0 = sums_6.passed_0 + _S323 * vec3<f32>(table_number_0(first_6 + u32(1)), table_number_0(first_6 + u32(2)), table_number_0(first_6 + u32(3)));
    result_2.added_0 = sums_6.added_0 + _S323 * vec3<f32>(table_number_0(first_6 + u32(4)), table_number_0(first_6 + u32(5)), table_number_0(first_6 + u32(6)));
    return result_2;
}

fn with_plane_0( sums_7 : Albedos_0,  albedos_6 : Albedos_0,  shares_2 : PlaneShares_0) -> Albedos_0
{
    var result_3 : Albedos_0;
    var _S324 : vec3<f32> = vec3<f32>(shares_2.area_0);
    result_3.diffuse_reflect_0 = sums_7.diffuse_reflect_0 + _S324 * albedos_6.diffuse_reflect_0 + shares_2.added_0;
    result_3.diffuse_transmit_0 = sums_7.diffuse_transmit_0 + shares_2.passed_0 * albedos_6.diffuse_transmit_0;
    result_3.specular_reflect_0 = sums_7.specular_reflect_0 + _S324 * albedos_6.specular_reflect_0;
    result_3.specular_transmit_0 = sums_7.specular_transmit_0 + shares_2.passed_0 * albedos_6.specular_transmit_0;
    return result_3;
}

fn divided_0( sums_8 : Albedos_0,  area_2 : f32) -> Albedos_0
{
    var result_4 : Albedos_0;
    var _S325 : vec3<f32> = vec3<f32>((1.0f / max(area_2, 9.99999997475242708e-07f)));
    result_4.diffuse_reflect_0 = sums_8.diffuse_reflect_0 * _S325;
    result_4.diffuse_transmit_0 = sums_8.diffuse_transmit_0 * _S325;
    result_4.specular_reflect_0 = sums_8.specular_reflect_0 * _S325;
    result_4.specular_transmit_0 = sums_8.specular_transmit_0 * _S325;
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
    var _S326 : vec3<f32> = room_0 / max(albedo_1, vec3<f32>(9.99999997475242708e-07f));
    return min(gain_1, max(min(min(_S326.x, _S326.y), _S326.z), 0.0f));
}

fn flattened_0( largest_0 : f32,  albedo_2 : vec3<f32>,  room_1 : vec3<f32>) -> f32
{
    var _S327 : vec3<f32> = room_1 / max(albedo_2, vec3<f32>(9.99999997475242708e-07f)) - vec3<f32>(1.0f);
    return min(max(min(min(_S327.x, _S327.y), _S327.z), 0.0f) / max(largest_0, 9.99999997475242708e-07f), 1.0f);
}

fn fibre_gain_0( thread_11 : u32,  cell_12 : u32,  amount_1 : f32,  seed_2 : u32) -> f32
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_11, cell_12, (seed_2 ^ (u32(2654435769))))), 10.0f) - 1.0f) + 1.0f;
}

fn lerp_albedos_0( first_7 : Albedos_0,  second_1 : Albedos_0,  weight_5 : f32) -> Albedos_0
{
    var albedos_7 : Albedos_0;
    var _S328 : vec3<f32> = vec3<f32>(weight_5);
    albedos_7.diffuse_reflect_0 = mix(first_7.diffuse_reflect_0, second_1.diffuse_reflect_0, _S328);
    albedos_7.diffuse_transmit_0 = mix(first_7.diffuse_transmit_0, second_1.diffuse_transmit_0, _S328);
    albedos_7.specular_reflect_0 = mix(first_7.specular_reflect_0, second_1.specular_reflect_0, _S328);
    albedos_7.specular_transmit_0 = mix(first_7.specular_transmit_0, second_1.specular_transmit_0, _S328);
    return albedos_7;
}

fn tinted_0( albedos_8 : Albedos_0,  tint_0 : vec3<f32>) -> Albedos_0
{
    var result_5 : Albedos_0 = albedos_8;
    result_5.diffuse_reflect_0 = result_5.diffuse_reflect_0 * tint_0;
    result_5.diffuse_transmit_0 = result_5.diffuse_transmit_0 * tint_0;
    return result_5;
}

fn fourth_power_0( value_1 : f32) -> f32
{
    var _S329 : f32 = value_1 * value_1;
    return _S329 * _S329;
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

fn face_radiance_0( sends_0 : FaceSends_0,  open_of_other_0 : f32,  passed_2 : vec3<f32>,  from_other_0 : vec3<f32>) -> FaceRadiance_0
{
    var _S330 : vec3<f32> = vec3<f32>((1.0f - open_of_other_0)) * passed_2;
    var found_0 : FaceRadiance_0;
    var _S331 : vec3<f32> = sends_0.sky_warp_0 + _S330 * sends_0.crossing_warp_0;
    found_0.warp_8 = _S331;
    var _S332 : vec3<f32> = sends_0.sky_weft_0 + _S330 * sends_0.crossing_weft_0;
    found_0.weft_8 = _S332;
    found_0.mean_1 = vec3<f32>(sends_0.blocks_warp_0) * _S331 + vec3<f32>(sends_0.blocks_weft_0) * _S332;
    found_0.leaked_0 = from_other_0;
    return found_0;
}

fn view_terms_0( view_6 : vec3<f32>,  terms_0 : ptr<function, array<f32, i32(6)>>)
{
    var _S333 : f32 = 1.0f - view_6.z;
    var _S334 : f32 = _S333 * _S333;
    (*terms_0)[i32(0)] = 1.0f;
    var _S335 : f32 = view_6.x;
    var _S336 : f32 = _S335 * _S335;
    var _S337 : f32 = view_6.y;
    var _S338 : f32 = _S337 * _S337;
    (*terms_0)[i32(1)] = sqrt(max(_S336 + _S338, 9.999999960041972e-13f));
    (*terms_0)[i32(2)] = _S334;
    (*terms_0)[i32(3)] = _S334 * _S334;
    (*terms_0)[i32(4)] = _S336 - _S338;
    (*terms_0)[i32(5)] = 0.0f;
    return;
}

fn view_terms_1( view_7 : vec3<f32>,  terms_1 : ptr<function, array<f32, i32(6)>>)
{
    var _S339 : f32 = 1.0f - view_7.z;
    var _S340 : f32 = _S339 * _S339;
    (*terms_1)[i32(0)] = 1.0f;
    var _S341 : f32 = view_7.x;
    var _S342 : f32 = _S341 * _S341;
    var _S343 : f32 = view_7.y;
    var _S344 : f32 = _S343 * _S343;
    (*terms_1)[i32(1)] = sqrt(max(_S342 + _S344, 9.999999960041972e-13f));
    (*terms_1)[i32(2)] = _S340;
    (*terms_1)[i32(3)] = _S340 * _S340;
    (*terms_1)[i32(4)] = _S342 - _S344;
    (*terms_1)[i32(5)] = 0.0f;
    return;
}

struct Bounced_0
{
     reflected_0 : vec3<f32>,
     transmitted_0 : vec3<f32>,
     is_covered_0 : bool,
};

struct Scattered_0
{
     back_14 : vec3<f32>,
     through_0 : vec3<f32>,
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
    var _S345 : vec3<f32> = vec3<f32>((blocked_1.by_warp_0 + blocked_1.by_weft_0)) * interior_0.leaked_1;
    var _S346 : vec3<f32> = vec3<f32>(blocked_1.far_0) * yarn_2.through_0;
    var bounced_0 : Bounced_0;
    bounced_0.reflected_0 = yarn_2.back_14 * (vec3<f32>(blocked_1.by_warp_0) * interior_0.warp_9 + vec3<f32>(blocked_1.by_weft_0) * interior_0.weft_9) + _S346 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S346 * interior_0.far_1 + yarn_2.back_14 * _S345;
    bounced_0.is_covered_0 = false;
    return bounced_0;
}

fn sum_of_0( first_8 : Bounced_0,  second_2 : Bounced_0) -> Bounced_0
{
    var sum_1 : Bounced_0;
    sum_1.reflected_0 = first_8.reflected_0 + second_2.reflected_0;
    sum_1.transmitted_0 = first_8.transmitted_0 + second_2.transmitted_0;
    sum_1.is_covered_0 = false;
    return sum_1;
}

fn bounced_value_0( bounced_1 : Bounced_0,  light_7 : vec3<f32>,  view_8 : vec3<f32>) -> vec3<f32>
{
    var _S347 : f32 = light_7.z;
    return select_vector_1((_S347 * view_8.z) < 0.0f, bounced_1.transmitted_0, bounced_1.reflected_0) * vec3<f32>((abs(_S347) * 0.31830987334251404f));
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
    var _S348 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S349 : f32 = 2.0f * sqrt(_S348) - 1.0f;
    var _S350 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_10, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S349, _S350), 0.00999999977648258f, 1.0f), clamp((1.0f - _S348) * sheen_shear_0(_S349, _S350), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S349, _S350), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_8 : vec3<f32>,  view_9 : vec3<f32>,  scale_0 : f32,  shear_0 : f32) -> f32
{
    var _S351 : f32 = light_8.z;
    if(((_S351 <= 0.0f) | (((view_9.z) <= 0.0f))))
    {
        return 0.0f;
    }
    var _S352 : vec2<f32> = view_9.xy;
    var _S353 : f32 = dot(_S352, _S352);
    var _S354 : vec2<f32> = select_vector_0(_S353 > 9.99999968265522539e-21f, _S352 * vec2<f32>(rsqrt_0(max(_S353, 9.99999968265522539e-21f))), vec2<f32>(1.0f, 0.0f));
    var _S355 : f32 = scale_0 * dot(light_8.xy, _S354) + shear_0 * _S351;
    var _S356 : f32 = scale_0 * (light_8.y * _S354.x - light_8.x * _S354.y);
    var _S357 : f32 = _S355 * _S355 + _S356 * _S356 + _S351 * _S351;
    return 0.31830987334251404f * scale_0 * scale_0 * _S351 / max(_S357 * _S357, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_9 : vec3<f32>,  view_10 : vec3<f32>,  strength_0 : f32,  roughness_11 : f32) -> vec2<f32>
{
    var _S358 : vec3<f32> = sheen_lobe_0(view_10.z, roughness_11);
    var _S359 : f32 = strength_0 * _S358.z;
    return vec2<f32>(_S359 * transformed_cosine_0(light_9, view_10, _S358.x, _S358.y), 1.0f - _S359);
}

fn accumulate_0( index_7 : u32,  light_10 : vec4<f32>)
{
    var _S360 : f32 = layers_0[index_7].share_0;
    radiance_0[index_7] = radiance_0[index_7] + vec4<f32>(layers_0[index_7].share_0) * light_10;
    layers_0[index_7].share_0 = _S360 * (1.0f - light_10.w);
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

fn uneven_shift_0( _S361 : u32,  _S362 : u32,  _S363 : u32,  _S364 : vec2<f32>) -> f32
{
    var _S365 : f32 = families_0[_S363].period_0 / families_0[_S363].count_0;
    var _S366 : u32 = hash_key_0(_S362, ((fabrics_0[_S361].seed_0) ^ (u32(625341585))));
    var _S367 : vec2<f32> = vec2<f32>(_S364.x, _S364.y / 4.0f) / vec2<f32>(_S365);
    return 0.20000000298023224f * sqrt(families_0[_S363].slub_0) * _S365 * (uneven_octave_0(_S366, _S367) * 0.66666668653488159f + uneven_octave_0(_S366 + u32(1), vec2<f32>(2.0f) * _S367 + vec2<f32>(0.5f, 0.0f)) / 3.0f);
}

fn uneven_place_0( _S368 : u32,  _S369 : vec2<f32>) -> vec2<f32>
{
    return select_vector_0((fabrics_0[_S368].has_detail_0) == u32(0), _S369, _S369 + vec2<f32>(uneven_shift_0(_S368, u32(0), fabrics_0[_S368].warp_0, _S369), uneven_shift_0(_S368, u32(1), fabrics_0[_S368].weft_0, _S369.yx)));
}

fn face_point_0( _S370 : u32,  _S371 : u32,  _S372 : f32,  _S373 : f32) -> VisiblePoint_0
{
    var _S374 : u32 = u32(3) * _S371;
    var _S375 : Vertex_0 = vertex_at_0(_S374);
    var _S376 : Vertex_0 = vertex_at_0(_S374 + u32(1));
    var _S377 : Vertex_0 = vertex_at_0(_S374 + u32(2));
    var _S378 : vec3<f32> = position_of_0(_S375);
    var _S379 : vec3<f32> = position_of_0(_S376) - _S378;
    var _S380 : vec3<f32> = position_of_0(_S377) - _S378;
    var _S381 : f32 = _S376.u_0 - _S375.u_0;
    var _S382 : f32 = _S376.v_0 - _S375.v_0;
    var _S383 : vec2<f32> = vec2<f32>(_S381, _S382);
    var _S384 : f32 = _S377.u_0 - _S375.u_0;
    var _S385 : f32 = _S377.v_0 - _S375.v_0;
    var _S386 : vec2<f32> = vec2<f32>(_S384, _S385);
    var _S387 : vec3<f32> = vec3<f32>(select(1.0f, -1.0f, (_S381 * _S385 - _S382 * _S384) < 0.0f));
    var _S388 : vec3<f32> = _S387 * (vec3<f32>(_S385) * _S379 - vec3<f32>(_S382) * _S380);
    var _S389 : vec3<f32> = _S387 * (vec3<f32>(_S381) * _S380 - vec3<f32>(_S384) * _S379);
    var point_2 : VisiblePoint_0;
    var _S390 : vec3<f32> = vec3<f32>(_S372);
    var _S391 : vec3<f32> = vec3<f32>(_S373);
    var _S392 : vec3<f32> = normalize(vec3<f32>((1.0f - _S372 - _S373)) * normal_of_0(_S375) + _S390 * normal_of_0(_S376) + _S391 * normal_of_0(_S377));
    point_2.normal_0 = _S392;
    var _S393 : vec3<f32> = normalize(_S388 - _S392 * vec3<f32>(dot(_S392, _S388)));
    point_2.axis_x_0 = _S393;
    point_2.axis_y_0 = cross(_S392, _S393);
    var _S394 : vec3<f32> = normalize(cross(_S379, _S380));
    point_2.face_normal_0 = select_vector_1((dot(_S394, _S392)) < 0.0f, (vec3<f32>(0) - _S394), _S394);
    point_2.position_4 = _S378 + _S390 * _S379 + _S391 * _S380;
    point_2.view_0 = _S392;
    var _S395 : vec2<f32> = vec2<f32>(_S375.u_0, _S375.v_0) + vec2<f32>(_S372) * _S383 + vec2<f32>(_S373) * _S386;
    point_2.uv_1 = _S395;
    var _S396 : bool = (dot(cross(_S388, _S389), _S392)) < 0.0f;
    var _S397 : vec2<f32> = vec2<f32>(fabrics_0[_S370].uv_width_0, select(fabrics_0[_S370].uv_height_0, - fabrics_0[_S370].uv_height_0, _S396));
    point_2.draft_per_uv_0 = _S397;
    point_2.draft_0 = uneven_place_0(_S370, _S395 * _S397 + vec2<f32>(0.0f, select(0.0f, fabrics_0[_S370].uv_height_0, _S396)));
    var _S398 : vec2<f32> = vec2<f32>(0.0f);
    point_2.draft_dx_0 = _S398;
    point_2.draft_dy_0 = _S398;
    return point_2;
}

fn visible_point_0( _S399 : u32,  _S400 : u32,  _S401 : vec2<u32>) -> VisiblePoint_0
{
    var _S402 : u32 = u32(3) * _S400;
    var _S403 : Vertex_0 = vertex_at_0(_S402);
    var _S404 : Vertex_0 = vertex_at_0(_S402 + u32(1));
    var _S405 : Vertex_0 = vertex_at_0(_S402 + u32(2));
    var _S406 : vec3<f32> = position_of_0(_S403);
    var _S407 : vec3<f32> = position_of_0(_S404) - _S406;
    var _S408 : vec3<f32> = position_of_0(_S405) - _S406;
    var _S409 : vec3<f32> = cross(_S407, _S408);
    var _S410 : f32 = f32(frame_record_0.width_0);
    var _S411 : vec3<f32> = camera_right_0() * vec3<f32>((2.0f / _S410));
    var _S412 : f32 = f32(frame_record_0.height_0);
    var _S413 : vec3<f32> = camera_up_0() * vec3<f32>((-2.0f / _S412));
    var _S414 : vec3<f32> = camera_forward_0() + vec3<f32>((f32(_S401.x) + 0.5f - 0.5f * _S410)) * _S411 + vec3<f32>((f32(_S401.y) + 0.5f - 0.5f * _S412)) * _S413;
    var _S415 : f32 = dot(_S414, _S409);
    var _S416 : f32 = 1.0f / select(1.00000000317107685e-30f, _S415, (abs(_S415)) > 1.00000000317107685e-30f);
    var _S417 : vec3<f32> = _S406 - camera_origin_0();
    var _S418 : vec3<f32> = vec3<f32>((dot(_S417, _S409) * _S416));
    var _S419 : vec3<f32> = _S414 * _S418 - _S417;
    var _S420 : vec3<f32> = _S418 * (_S411 - _S414 * vec3<f32>((dot(_S411, _S409) * _S416)));
    var _S421 : vec3<f32> = _S418 * (_S413 - _S414 * vec3<f32>((dot(_S413, _S409) * _S416)));
    var _S422 : vec3<f32> = vec3<f32>((1.0f / max(square_0(_S409), 1.00000000317107685e-30f)));
    var _S423 : vec3<f32> = cross(_S408, _S409) * _S422;
    var _S424 : vec3<f32> = cross(_S409, _S407) * _S422;
    var _S425 : vec2<f32> = vec2<f32>(_S404.u_0 - _S403.u_0, _S404.v_0 - _S403.v_0);
    var _S426 : vec2<f32> = vec2<f32>(_S405.u_0 - _S403.u_0, _S405.v_0 - _S403.v_0);
    var point_3 : VisiblePoint_0 = face_point_0(_S399, _S400, dot(_S419, _S423), dot(_S419, _S424));
    point_3.position_4 = _S406 + _S419;
    point_3.view_0 = (vec3<f32>(0) - normalize(_S414));
    point_3.draft_dx_0 = (vec2<f32>(dot(_S420, _S423)) * _S425 + vec2<f32>(dot(_S420, _S424)) * _S426) * point_3.draft_per_uv_0;
    point_3.draft_dy_0 = (vec2<f32>(dot(_S421, _S423)) * _S425 + vec2<f32>(dot(_S421, _S424)) * _S426) * point_3.draft_per_uv_0;
    return point_3;
}

fn filtered_albedo_0( _S427 : u32,  _S428 : VisiblePoint_0) -> vec3<f32>
{
    var _S429 : u32 = fabrics_0[_S427].albedo_map_levels_0;
    if((fabrics_0[_S427].albedo_map_levels_0) == u32(0))
    {
        return vec3<f32>(1.0f);
    }
    var _S430 : vec2<f32> = vec2<f32>(fabrics_0[_S427].uv_width_0, fabrics_0[_S427].uv_height_0);
    var _S431 : vec2<f32> = _S428.draft_dx_0 / _S430;
    var _S432 : vec2<f32> = _S428.draft_dy_0 / _S430;
    var _S433 : u32 = _S429 - u32(1);
    var _S434 : u32 = (u32(1) << (_S433));
    var _S435 : f32 = clamp(0.5f * binary_logarithm_0(max(abs(_S431.x * _S432.y - _S431.y * _S432.x), 9.99999968265522539e-21f) * (square_1(f32(_S434)) / 3.0f)), 0.0f, f32(_S429) - 1.0f);
    var _S436 : u32 = min(u32(_S435), max(_S429, u32(2)) - u32(2));
    var _S437 : u32 = min(_S436 + u32(1), _S433);
    var _S438 : u32 = (u32(1) << ((u32(2) * _S429)));
    return mix(map_level_0(fabrics_0[_S427].albedo_map_0 + (_S438 - ((_S438 >> ((u32(2) * _S436))))) / u32(3), (_S434 >> (_S436)), _S428.uv_1), map_level_0(fabrics_0[_S427].albedo_map_0 + (_S438 - ((_S438 >> ((u32(2) * _S437))))) / u32(3), (_S434 >> (_S437)), _S428.uv_1), vec3<f32>(((exponential_0(1.38629436492919922f * (_S435 - f32(_S436))) - 1.0f) / 3.0f)));
}

fn is_layered_0( _S439 : u32) -> bool
{
    return (HAS_LAYERS_0 & (((fabrics_0[_S439].planes_0) != u32(0))));
}

fn irregular_key_0( _S440 : u32,  _S441 : u32) -> u32
{
    return hash_key_0(_S441, ((fabrics_0[_S440].seed_0) ^ (u32(1821285621))));
}

fn irregular_place_0( _S442 : u32,  _S443 : vec2<f32>,  _S444 : f32) -> vec2<f32>
{
    var _S445 : u32 = fabrics_0[_S442].warp_0;
    var _S446 : u32 = fabrics_0[_S442].weft_0;
    var _S447 : bool = (((((fabrics_0[_S442].is_irregular_0) != u32(0)) & ((!is_layered_0(_S442))))) & (((max(moved_share_0(fabrics_0[_S442].warp_0, _S444), moved_share_0(fabrics_0[_S442].weft_0, _S444))) > 0.0f)));
    var number_4 : u32 = u32(0);
    var moved_0 : vec2<f32> = _S443;
    for(;;)
    {
        if(number_4 < select(u32(0), u32(2), _S447))
        {
        }
        else
        {
            break;
        }
        var _S448 : bool = number_4 == u32(0);
        var _S449 : u32 = select(_S446, _S445, _S448);
        var _S450 : vec2<f32> = select_vector_0(_S448, _S443, _S443.yx);
        var _S451 : u32 = irregular_key_0(_S442, number_4);
        var _S452 : f32 = _S450.x;
        var _S453 : Cell_0 = locate_0(_S449, _S452);
        var _S454 : f32 = irregular_thread_0(_S449, _S452, _S453);
        var _S455 : f32 = select(1.0f, -1.0f, (_S453.across_0) < 0.0f);
        var _S456 : vec2<f32> = vec2<f32>(0.0f);
        var other_3 : vec2<f32> = _S456;
        var own_2 : vec2<f32> = _S456;
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
            var _S457 : vec2<f32> = irregular_at_0(_S449, _S451, _S454 + _S455 * f32(neighbour_0), _S450.y).xy;
            var _S458 : u32 = neighbour_0 + u32(1);
            own_2 = other_3;
            other_3 = _S457;
            neighbour_0 = _S458;
        }
        var _S459 : f32 = _S453.below_0 + _S453.above_0;
        var _S460 : f32 = min(_S453.half_width_1 / _S459, 0.5f);
        var _S461 : f32 = min(_S460 * (2.0f + own_2.y + other_3.y), 1.0f);
        var _S462 : vec2<f32> = sqrt(max(vec2<f32>(1.0f) + vec2<f32>(own_2.x, other_3.x), vec2<f32>(0.25f)));
        var _S463 : f32 = _S462.x;
        var _S464 : f32 = _S461 * _S463 / (_S463 + _S462.y);
        var _S465 : f32 = abs(_S453.across_0) / _S459;
        var _S466 : f32 = 1.0f - _S461;
        var _S467 : f32 = _S465 - _S464;
        var _S468 : f32 = moved_share_0(_S449, _S444) * _S455 * _S459 * (select(select((_S467 - _S466) / max(_S461 - _S464, 9.99999997475242708e-07f) * _S460 + (1.0f - _S460), _S467 / max(_S466, 9.99999997475242708e-07f) * (1.0f - 2.0f * _S460) + _S460, _S467 < _S466), _S465 * _S460 / _S464, _S467 < 0.0f) - _S465);
        var moved_1 : vec2<f32> = moved_0 + select_vector_0(_S448, vec2<f32>(_S468, 0.0f), vec2<f32>(0.0f, _S468));
        number_4 = number_4 + u32(1);
        moved_0 = moved_1;
    }
    return moved_0;
}

fn light_sample_count_0() -> u32
{
    return frame_record_0.lights_0 + frame_record_0.environment_samples_0;
}

fn visibility_at_0( _S469 : u32,  _S470 : vec2<u32>) -> f32
{
    if((frame_record_0.casts_shadows_0) == u32(0))
    {
        return 1.0f;
    }
    return visibilities_0[(_S469 * frame_record_0.height_0 + _S470.y) * frame_record_0.width_0 + _S470.x];
}

struct LightSample_0
{
     towards_0 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_1 : f32,
};

fn environment_texel_0( _S471 : u32,  _S472 : u32) -> vec3<f32>
{
    var _S473 : u32 = frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + frame_record_0.environment_rows_0 * (frame_record_0.environment_columns_0 + u32(1)) + u32(3) * (_S471 * frame_record_0.environment_columns_0 + _S472);
    return vec3<f32>(scene_number_0(_S473), scene_number_0(_S473 + u32(1)), scene_number_0(_S473 + u32(2)));
}

fn sample_environment_0( _S474 : vec2<f32>,  _S475 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S476 : u32 = frame_record_0.environment_rows_0;
    var _S477 : Choice_0 = choose_0(frame_record_0.environment_table_0, frame_record_0.environment_rows_0, _S474.y);
    var _S478 : u32 = frame_record_0.environment_columns_0;
    var _S479 : Choice_0 = choose_0(frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + _S477.index_5 * (frame_record_0.environment_columns_0 + u32(1)), frame_record_0.environment_columns_0, _S474.x);
    var _S480 : vec3<f32> = environment_texel_0(_S477.index_5, _S479.index_5);
    (*_S475) = _S480 * vec3<f32>((frame_record_0.environment_total_0 / max(mean_0(_S480), 9.99999968265522539e-21f)));
    var _S481 : f32 = 3.14159274101257324f / f32(_S476);
    var _S482 : f32 = mix(sine_cosine_0(f32(_S477.index_5) * _S481).y, sine_cosine_0(f32(_S477.index_5 + u32(1)) * _S481).y, _S477.remainder_0);
    var _S483 : f32 = sqrt(max(1.0f - _S482 * _S482, 0.0f));
    var _S484 : vec2<f32> = sine_cosine_0((f32(_S479.index_5) + _S479.remainder_0) * (6.28318548202514648f / f32(_S478)));
    var _S485 : f32 = _S483 * _S484.x;
    var _S486 : f32 = - _S483 * _S484.y;
    return vec3<f32>(frame_record_0.environment_cosine_0 * _S485 + frame_record_0.environment_sine_0 * _S486, _S482, frame_record_0.environment_cosine_0 * _S486 - frame_record_0.environment_sine_0 * _S485);
}

fn light_sample_0( _S487 : u32,  _S488 : vec2<u32>,  _S489 : vec3<f32>) -> LightSample_0
{
    var sample_1 : LightSample_0;
    sample_1.distance_1 = 1.00000001504746622e+30f;
    var _S490 : u32 = frame_record_0.lights_0;
    if(_S487 >= (frame_record_0.lights_0))
    {
        var weight_6 : vec3<f32>;
        var _S491 : vec3<f32> = sample_environment_0(pixel_sequence_0(_S488, frame_record_0.pass_number_0 * frame_record_0.environment_samples_0 + (_S487 - _S490), u32(3)), &(weight_6));
        sample_1.towards_0 = _S491;
        sample_1.irradiance_1 = weight_6 / vec3<f32>(f32(frame_record_0.environment_samples_0));
        return sample_1;
    }
    var _S492 : Light_0 = scene_light_0(frame_record_0.light_records_0 + u32(7) * _S487);
    sample_1.irradiance_1 = vec3<f32>(_S492.red_0, _S492.green_0, _S492.blue_0);
    sample_1.towards_0 = vec3<f32>(_S492.x_7, _S492.y_1, _S492.z_1);
    if((_S492.is_point_0) != u32(0))
    {
        var _S493 : vec3<f32> = sample_1.towards_0 - _S489;
        var _S494 : f32 = max(square_0(_S493), 9.999999960041972e-13f);
        sample_1.distance_1 = sqrt(_S494);
        sample_1.irradiance_1 = sample_1.irradiance_1 / vec3<f32>(_S494);
        sample_1.towards_0 = normalize(_S493);
    }
    return sample_1;
}

struct Estimate_0
{
     components_0 : Components_0,
     close_0 : CloseUp_0,
     albedos_9 : FamilyAlbedos_0,
};

struct Regime_0
{
     prefiltered_0 : f32,
     threads_2 : f32,
     points_0 : f32,
};

fn regime_of_0( _S495 : u32,  _S496 : Footprint_0,  _S497 : f32) -> Regime_0
{
    var _S498 : f32 = Footprint_spread_side_0(_S496);
    var _S499 : f32 = clamp((binary_logarithm_0(max(_S498, 9.99999971718068537e-10f)) - fabrics_0[_S495].lobes_0.unit_level_0 - -0.51457315683364868f) / 1.51457309722900391f, 0.0f, 1.0f);
    var regime_0 : Regime_0;
    var _S500 : f32 = _S499 * _S499 * (3.0f - 2.0f * _S499);
    regime_0.prefiltered_0 = _S500;
    var _S501 : f32 = _S498 * fabrics_0[_S495].lobes_0.threads_per_mm_0;
    regime_0.threads_2 = _S501;
    regime_0.points_0 = select(0.0f, clamp(_S501 * 12.0f, 1.0f, max(mix(8.0f, 4.0f, _S500) / _S497, 1.0f)), _S500 < 1.0f);
    return regime_0;
}

fn varies_at_0( _S502 : u32,  _S503 : f32) -> bool
{
    return (((((fabrics_0[_S502].fibre_noise_0) > 0.0f) | (((fabrics_0[_S502].colour_noise_0) > 0.0f)))) | (((((fabrics_0[_S502].has_detail_0) != u32(0)) & ((_S503 >= 0.0f))))));
}

struct Hit_0
{
     x_21 : f32,
     y_14 : f32,
     hole_7 : bool,
     height_9 : f32,
};

fn whole_plane_0( _S504 : u32) -> Plane_0
{
    var plane_9 : Plane_0;
    plane_9.warp_2 = fabrics_0[_S504].warp_0;
    plane_9.weft_2 = fabrics_0[_S504].weft_0;
    plane_9.run_words_1 = fabrics_0[_S504].run_words_0;
    plane_9.ends_2 = fabrics_0[_S504].ends_1;
    plane_9.end_numbers_0 = u32(0);
    plane_9.pick_numbers_0 = u32(0);
    plane_9.max_heights_1 = fabrics_0[_S504].max_heights_0;
    plane_9.max_height_columns_1 = fabrics_0[_S504].max_height_columns_0;
    plane_9.height_low_1 = fabrics_0[_S504].height_low_0;
    plane_9.height_high_1 = fabrics_0[_S504].height_high_0;
    plane_9.front_level_0 = 0.0f;
    plane_9.back_level_0 = 0.0f;
    plane_9.start_x_0 = 0.0f;
    plane_9.start_y_0 = 0.0f;
    plane_9.fine_x_0 = 0.0f;
    plane_9.fine_y_0 = 0.0f;
    return plane_9;
}

fn plane_order_0( _S505 : u32,  _S506 : f32,  _S507 : f32,  _S508 : bool) -> u32
{
    var _S509 : u32 = select(u32(0), locate_varied_0(fabrics_0[_S505].plane_axes_0 + u32(1), _S507).thread_1 * fabrics_0[_S505].ends_1 + locate_varied_0(fabrics_0[_S505].plane_axes_0, _S506).thread_1, (fabrics_0[_S505].stacks_0) > u32(1));
    return fabrics_0[_S505].plane_orders_0 + u32(2) * fabrics_0[_S505].planes_0 * (u32(2) * ((((words_0[fabrics_0[_S505].regions_0 + _S509 / u32(4)] >> ((u32(8) * (_S509 % u32(4)))))) & (u32(255)))) + select(u32(0), u32(1), _S508));
}

fn first_bounds_0( _S510 : u32,  _S511 : u32,  _S512 : f32,  _S513 : f32,  _S514 : bool,  _S515 : bool,  _S516 : bool) -> vec3<f32>
{
    var _S517 : vec3<f32> = bounds_in_0(plane_at_0(fabrics_0[_S510].plane_records_0 + words_0[_S511] * u32(16)), _S512, _S513, _S514, _S515, _S516);
    var _S518 : Cell_0 = locate_varied_0(fabrics_0[_S510].plane_axes_0, _S512);
    var _S519 : Cell_0 = locate_varied_0(fabrics_0[_S510].plane_axes_0 + u32(1), _S513);
    var _S520 : bool = (fabrics_0[_S510].stacks_0) == u32(1);
    return vec3<f32>(_S517.x + table_number_0(_S511 + u32(1)), min(_S517.y, select(select(_S518.below_0, _S518.above_0, _S515), 1.0e+06f, _S520)), min(_S517.z, select(select(_S519.below_0, _S519.above_0, _S516), 1.0e+06f, _S520)));
}

fn plane_shown_0( _S521 : u32,  _S522 : f32,  _S523 : f32,  _S524 : bool,  _S525 : bool,  _S526 : bool) -> PlaneHere_0
{
    var here_6 : PlaneHere_0;
    here_6.plane_5 = whole_plane_0(_S521);
    here_6.number_2 = u32(0);
    here_6.level_1 = 0.0f;
    here_6.edge_x_0 = 1.0e+06f;
    here_6.edge_y_0 = 1.0e+06f;
    here_6.bounds_0 = vec3<f32>(0.0f);
    if(!is_layered_0(_S521))
    {
        return here_6;
    }
    var _S527 : u32 = plane_order_0(_S521, _S522, _S523, _S524);
    var _S528 : vec3<f32> = first_bounds_0(_S521, _S527, _S522, _S523, _S524, _S525, _S526);
    here_6.bounds_0 = _S528;
    var _S529 : bool = (fabrics_0[_S521].stacks_0) == u32(1);
    here_6.edge_x_0 = select(_S528.y, 1.0e+06f, _S529);
    here_6.edge_y_0 = select(_S528.z, 1.0e+06f, _S529);
    var is_hole_0 : bool = true;
    var rank_1 : u32 = u32(0);
    for(;;)
    {
        if(((rank_1 < (fabrics_0[_S521].planes_0)) & (is_hole_0)))
        {
        }
        else
        {
            break;
        }
        var _S530 : u32 = _S527 + u32(2) * rank_1;
        var _S531 : u32 = words_0[_S530];
        here_6.number_2 = _S531;
        here_6.level_1 = table_number_0(_S530 + u32(1));
        here_6.plane_5 = plane_at_0(fabrics_0[_S521].plane_records_0 + _S531 * u32(16));
        var _S532 : Cell_0 = locate_varied_0(here_6.plane_5.warp_2, _S522 - here_6.plane_5.start_x_0);
        var _S533 : Cell_0 = locate_varied_0(here_6.plane_5.weft_2, _S523 - here_6.plane_5.start_y_0);
        var is_hole_1 : bool = !((((abs(_S532.across_0)) < (_S532.half_width_1)) | (((abs(_S533.across_0)) < (_S533.half_width_1)))));
        here_6.edge_x_0 = min(here_6.edge_x_0, select(1.0e+06f, hole_edge_0(_S532, _S525), is_hole_1));
        here_6.edge_y_0 = min(here_6.edge_y_0, select(1.0e+06f, hole_edge_0(_S533, _S526), is_hole_1));
        var _S534 : u32 = rank_1 + u32(1);
        is_hole_0 = is_hole_1;
        rank_1 = _S534;
    }
    return here_6;
}

fn sample_at_0( _S535 : u32,  _S536 : f32,  _S537 : f32,  _S538 : bool) -> Sample_0
{
    return sample_in_0(plane_shown_0(_S535, _S536, _S537, _S538, true, true), _S536, _S537, _S538);
}

fn steps_per_length_0( _S539 : u32,  _S540 : SearchQuality_0,  _S541 : vec3<f32>) -> f32
{
    return max(max(abs(_S541.x) * fabrics_0[_S539].threads_per_x_0, abs(_S541.y) * fabrics_0[_S539].threads_per_y_0) * _S540.steps_per_thread_0, abs(_S541.z) * fabrics_0[_S539].per_relief_0 * _S540.steps_per_relief_0);
}

fn plane_count_0( _S542 : u32) -> u32
{
    return select(u32(1), fabrics_0[_S542].planes_0, is_layered_0(_S542));
}

fn probe_0( _S543 : u32,  _S544 : f32,  _S545 : f32,  _S546 : bool,  _S547 : bool,  _S548 : bool) -> Probe_0
{
    var _S549 : PlaneHere_0 = plane_shown_0(_S543, _S544, _S545, _S546, _S547, _S548);
    var _S550 : Sample_0 = sample_in_0(_S549, _S544, _S545, _S546);
    var probe_1 : Probe_0;
    probe_1.height_5 = _S550.height_4;
    probe_1.hole_4 = _S550.shown_2.hole_3;
    probe_1.slope_x_1 = _S550.slope_x_0;
    probe_1.slope_y_1 = _S550.slope_y_0;
    var _S551 : bool = !is_layered_0(_S543);
    probe_1.yarn_1 = select(_S550.crossing_3.weft_3.thread_1 * u32(2), _S550.crossing_3.warp_3.thread_1 * u32(2) + u32(1), _S550.shown_2.is_warp_2) * plane_count_0(_S543) + _S549.number_2;
    probe_1.cell_max_0 = select(_S549.bounds_0.x, cell_maximum_0(_S549.plane_5, _S550.crossing_3), _S551);
    probe_1.side_x_0 = select(_S549.bounds_0.y, select(_S550.crossing_3.warp_3.below_0, _S550.crossing_3.warp_3.above_0, _S547), _S551);
    probe_1.side_y_0 = select(_S549.bounds_0.z, select(_S550.crossing_3.weft_3.below_0, _S550.crossing_3.weft_3.above_0, _S548), _S551);
    probe_1.edge_x_1 = min(_S549.edge_x_0, outline_distance_0(_S550.crossing_3.warp_3, _S550.shown_2, _S550.run_2, !_S550.shown_2.is_warp_2, _S547));
    probe_1.edge_y_1 = min(_S549.edge_y_0, outline_distance_0(_S550.crossing_3.weft_3, _S550.shown_2, _S550.run_2, _S550.shown_2.is_warp_2, _S548));
    return probe_1;
}

fn is_free_0( _S552 : u32,  _S553 : SearchQuality_0,  _S554 : vec3<f32>,  _S555 : vec3<f32>,  _S556 : bool,  _S557 : f32) -> bool
{
    var _S558 : f32 = _S555.z;
    if(_S558 <= 0.0f)
    {
        return false;
    }
    var _S559 : f32 = 1.0f / max(_S553.shadow_share_0 * steps_per_length_0(_S552, _S553, _S555), 9.99999971718068537e-10f);
    var _S560 : StepControl_0 = step_control_0(_S555.xy, _S559);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_4 : u32 = u32(0);
    var distance_2 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        if(((count_4 < u32(1024)) & (((_S554.z + _S558 * distance_2) < _S557))))
        {
        }
        else
        {
            break;
        }
        var _S561 : vec3<f32> = _S554 + _S555 * vec3<f32>(distance_2);
        var _S562 : Probe_0 = probe_0(_S552, _S561.x, _S561.y, _S556, _S560.right_1, _S560.up_1);
        var _S563 : f32 = _S561.z;
        var _S564 : f32 = _S563 - _S562.height_5;
        var _S565 : f32 = _S558 - _S562.slope_x_1 * _S555.x - _S562.slope_y_1 * _S555.y;
        if(((!_S562.hole_4) & ((_S564 < 0.0f))))
        {
            return false;
        }
        var _S566 : f32 = way_back_to_dip_0(previous_3, _S564, _S565, last_step_0, _S562);
        if(_S566 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S566;
            distance_2 = distance_2 - _S566;
            last_step_0 = last_step_1;
            count_4 = count_4 + u32(1);
            continue;
        }
        var _S567 : bool = _S563 > (_S562.cell_max_0);
        var last_step_2 : f32 = select(StepControl_to_next_sample_0(_S560, _S562, _S564, _S565), max(StepControl_to_cell_exit_0(_S560, _S562.side_x_0, _S562.side_y_0), _S559), _S567);
        var distance_3 : f32 = distance_2 + last_step_2;
        previous_3 = after_sample_0(_S564, _S565, _S562, _S567);
        distance_2 = distance_3;
        last_step_0 = last_step_2;
        count_4 = count_4 + u32(1);
    }
    return true;
}

fn passes_through_0( _S568 : u32,  _S569 : SearchQuality_0,  _S570 : f32,  _S571 : f32,  _S572 : vec3<f32>,  _S573 : bool) -> bool
{
    if(!sample_at_0(_S568, _S570, _S571, _S573).shown_2.hole_3)
    {
        return false;
    }
    var _S574 : vec3<f32> = vec3<f32>(_S570, _S571, 0.0f);
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
        var _S575 : bool = is_free_0(_S568, _S569, _S574, select_vector_1(side_2 == u32(0), _S572, vec3<f32>(- _S572.x, - _S572.y, _S572.z)), _S573 != (side_2 == u32(1)), fabrics_0[_S568].height_high_0);
        var _S576 : u32 = side_2 + u32(1);
        passes_0 = _S575;
        side_2 = _S576;
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

fn plane_of_0( _S577 : u32,  _S578 : u32) -> Plane_0
{
    if(!is_layered_0(_S577))
    {
        return whole_plane_0(_S577);
    }
    return plane_at_0(fabrics_0[_S577].plane_records_0 + _S578 * u32(16));
}

fn max_height_along_0( _S579 : u32,  _S580 : f32,  _S581 : f32,  _S582 : f32,  _S583 : vec3<f32>,  _S584 : bool) -> f32
{
    var _S585 : f32 = _S583.x;
    var _S586 : f32 = _S583.y;
    var _S587 : u32 = select(u32(0), u32(1), _S585 > 0.0f) + select(u32(0), u32(2), _S586 > 0.0f);
    var _S588 : f32 = max(abs(_S585) * fabrics_0[_S579].threads_per_x_0, abs(_S586) * fabrics_0[_S579].threads_per_y_0) / _S583.z;
    var levels_4 : vec4<f32> = vec4<f32>(-1.00000001504746622e+30f);
    var number_5 : u32 = u32(0);
    for(;;)
    {
        if(number_5 < (plane_count_0(_S579)))
        {
        }
        else
        {
            break;
        }
        var _S589 : Plane_0 = plane_of_0(_S579, number_5);
        var _S590 : u32 = (words_0[_S589.max_heights_1 + u32(4) * (locate_0(_S589.weft_2, _S581 - _S589.start_y_0).thread_1 / u32(2) * _S589.max_height_columns_1 + locate_0(_S589.warp_2, _S580 - _S589.start_x_0).thread_1 / u32(2)) + _S587] >> (u32(select(i32(0), i32(4), _S584))));
        var _S591 : vec4<f32> = max(levels_4, vec4<f32>(f32((_S590 & (u32(15)))), f32((((_S590 >> (u32(8)))) & (u32(15)))), f32((((_S590 >> (u32(16)))) & (u32(15)))), f32((((_S590 >> (u32(24)))) & (u32(15))))) * vec4<f32>(0.06666667014360428f) * vec4<f32>(_S589.height_high_1) + vec4<f32>(select(_S589.front_level_0, _S589.back_level_0, _S584)));
        var _S592 : u32 = number_5 + u32(1);
        levels_4 = _S591;
        number_5 = _S592;
    }
    var max_height_0 : f32 = fabrics_0[_S579].height_high_0;
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
        if(((max_height_0 - _S582) * _S588) <= (PYRAMID_RADII_0[number_6]))
        {
            max_height_0 = min(max_height_0, levels_4[number_6]);
        }
        number_6 = number_6 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S593 : u32,  _S594 : f32,  _S595 : f32,  _S596 : bool,  _S597 : bool,  _S598 : bool) -> vec3<f32>
{
    if(is_layered_0(_S593))
    {
        return first_bounds_0(_S593, plane_order_0(_S593, _S594, _S595, _S596), _S594, _S595, _S596, _S597, _S598);
    }
    return bounds_in_0(whole_plane_0(_S593), _S594, _S595, _S596, _S597, _S598);
}

fn first_sample_height_0( _S599 : u32,  _S600 : ViewRay_0,  _S601 : StepControl_0,  _S602 : bool) -> f32
{
    var _S603 : f32 = max_height_along_0(_S599, _S600.origin_0.x, _S600.origin_0.y, 0.0f, vec3<f32>(_S600.slope_1, 1.0f), _S602);
    var count_5 : u32 = u32(0);
    var height_11 : f32 = _S603;
    for(;;)
    {
        if(count_5 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S604 : vec2<f32> = ViewRay_at_0(_S600, height_11);
        var _S605 : vec3<f32> = cell_bounds_0(_S599, _S604.x, _S604.y, _S602, _S601.right_1, _S601.up_1);
        var _S606 : f32 = height_11 - _S605.x;
        var _S607 : f32 = StepControl_to_cell_exit_0(_S601, _S605.y, _S605.z);
        var height_12 : f32 = height_11 - clamp(_S606, 0.0f, _S607);
        if(_S606 <= _S607)
        {
            height_11 = height_12;
            break;
        }
        count_5 = count_5 + u32(1);
        height_11 = height_12;
    }
    return height_11;
}

fn search_down_0( _S608 : u32,  _S609 : ViewRay_0,  _S610 : StepControl_0,  _S611 : bool) -> ViewRayEnd_0
{
    var _S612 : f32 = fabrics_0[_S608].height_low_0 - (fabrics_0[_S608].height_high_0 - fabrics_0[_S608].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_10 = first_sample_height_0(_S608, _S609, _S610, _S611);
    end_1.last_step_3 = _S610.epsilon_0;
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
        var _S613 : vec2<f32> = ViewRay_at_0(_S609, end_1.height_10);
        var _S614 : Probe_0 = probe_0(_S608, _S613.x, _S613.y, _S611, _S610.right_1, _S610.up_1);
        var _S615 : f32 = end_1.height_10 - _S614.height_5;
        var _S616 : f32 = ViewRay_rate_0(_S609, _S614);
        end_1.depth_2 = - _S615;
        end_1.rate_4 = _S616;
        var _S617 : bool = !_S614.hole_4;
        end_1.smooth_0 = ((((end_1.previous_4.known_0) & (_S617))) & (((end_1.previous_4.yarn_0) == (_S614.yarn_1))));
        if((((_S617 & ((_S615 <= 0.0f)))) | (((end_1.height_10) <= _S612))))
        {
            break;
        }
        var _S618 : f32 = way_back_to_dip_0(end_1.previous_4, _S615, _S616, end_1.last_step_3, _S614);
        if(_S618 >= 0.0f)
        {
            end_1.height_10 = end_1.height_10 + _S618;
            end_1.last_step_3 = end_1.last_step_3 - _S618;
            count_6 = count_6 + u32(1);
            continue;
        }
        var _S619 : f32 = min(StepControl_to_cell_exit_0(_S610, _S614.side_x_0, _S614.side_y_0), end_1.height_10 - _S614.cell_max_0);
        var _S620 : f32 = StepControl_to_next_sample_0(_S610, _S614, _S615, _S616);
        end_1.previous_4 = after_sample_0(_S615, _S616, _S614, _S619 > _S620);
        var _S621 : f32 = max(_S619, _S620);
        end_1.last_step_3 = _S621;
        end_1.height_10 = end_1.height_10 - _S621;
        count_6 = count_6 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S622 : u32,  _S623 : ViewRay_0,  _S624 : StepControl_0,  _S625 : bool,  _S626 : ViewRayEnd_0,  _S627 : u32) -> f32
{
    var _S628 : f32 = fabrics_0[_S622].height_high_0 - fabrics_0[_S622].height_low_0;
    var above_2 : f32 = _S626.height_10 + _S626.last_step_3;
    var above_gap_1 : f32 = clamp(_S626.previous_4.clearance_0, 0.0f, _S628);
    var under_gap_1 : f32 = clamp(_S626.depth_2, 0.0f, _S628);
    var middle_0 : f32 = select(between_0(above_2, _S626.height_10, above_gap_1, under_gap_1), above_2 - cubic_root_0(above_gap_1, - under_gap_1, _S626.previous_4.rate_0 * _S626.last_step_3, _S626.rate_4 * _S626.last_step_3) * _S626.last_step_3, _S626.smooth_0);
    var side_3 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S626.height_10;
    var above_3 : f32 = above_2;
    var i_2 : u32 = u32(0);
    for(;;)
    {
        if(i_2 < _S627)
        {
        }
        else
        {
            break;
        }
        var _S629 : vec2<f32> = ViewRay_at_0(_S623, middle_0);
        var _S630 : Probe_0 = probe_0(_S622, _S629.x, _S629.y, _S625, _S624.right_1, _S624.up_1);
        var _S631 : f32 = clamp(middle_0 - select(_S630.height_5, -1.0e+09f, _S630.hole_4), - _S628, _S628);
        if(_S631 <= 0.0f)
        {
            var _S632 : f32 = select(above_gap_2, 0.5f * above_gap_2, side_3 > 0.0f);
            var _S633 : f32 = - _S631;
            under_1 = middle_0;
            above_gap_2 = _S632;
            under_gap_2 = _S633;
            side_3 = 1.0f;
        }
        else
        {
            var _S634 : f32 = select(under_gap_2, 0.5f * under_gap_2, side_3 < 0.0f);
            above_3 = middle_0;
            above_gap_2 = _S631;
            under_gap_2 = _S634;
            side_3 = -1.0f;
        }
        var _S635 : f32 = select(between_0(above_3, under_1, above_gap_2, under_gap_2), clamp(middle_0 + _S631 / min(ViewRay_rate_0(_S623, _S630), -9.99999997475242708e-07f), under_1, above_3), _S626.smooth_0);
        var _S636 : u32 = i_2 + u32(1);
        middle_0 = _S635;
        i_2 = _S636;
    }
    return select(under_1, middle_0, _S626.smooth_0);
}

fn first_hit_of_yarn_0( _S637 : u32,  _S638 : SearchQuality_0,  _S639 : f32,  _S640 : f32,  _S641 : vec3<f32>,  _S642 : bool) -> Hit_0
{
    var _S643 : f32 = max(_S641.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S639, _S640);
    var _S644 : vec2<f32> = _S641.xy / vec2<f32>(_S643);
    ray_0.slope_1 = _S644;
    var _S645 : StepControl_0 = step_control_0((vec2<f32>(0) - _S644), 1.0f / max(steps_per_length_0(_S637, _S638, _S641) / _S643, 9.99999971718068537e-10f));
    var _S646 : ViewRayEnd_0 = search_down_0(_S637, ray_0, _S645, _S642);
    var hit_0 : Hit_0;
    hit_0.hole_7 = false;
    var _S647 : f32 = refined_height_0(_S637, ray_0, _S645, _S642, _S646, _S638.refinements_0);
    hit_0.height_9 = _S647;
    var _S648 : vec2<f32> = ViewRay_at_0(ray_0, _S647);
    hit_0.x_21 = _S648.x;
    hit_0.y_14 = _S648.y;
    return hit_0;
}

fn first_hit_0( _S649 : u32,  _S650 : SearchQuality_0,  _S651 : f32,  _S652 : f32,  _S653 : vec3<f32>,  _S654 : bool) -> Hit_0
{
    if(!passes_through_0(_S649, _S650, _S651, _S652, _S653, _S654))
    {
        return first_hit_of_yarn_0(_S649, _S650, _S651, _S652, _S653, _S654);
    }
    var hit_1 : Hit_0;
    hit_1.x_21 = _S651;
    hit_1.y_14 = _S652;
    hit_1.height_9 = 0.0f;
    hit_1.hole_7 = true;
    return hit_1;
}

fn surface_of_0( _S655 : u32,  _S656 : Sample_0,  _S657 : f32,  _S658 : f32,  _S659 : bool) -> SurfacePoint_0
{
    var _S660 : u32 = select(fabrics_0[_S655].weft_0, fabrics_0[_S655].warp_0, _S656.shown_2.is_warp_2);
    var _S661 : f32 = families_0[_S660].twist_sine_0 * select(1.0f, -1.0f, _S659);
    var _S662 : f32 = families_0[_S660].twist_cosine_0;
    var _S663 : f32 = select(-1.0f, 1.0f, _S656.shown_2.is_warp_2);
    var _S664 : vec2<f32> = fibre_direction_0(_S656.slope_across_0, _S663 * _S656.slope_along_0, _S661, families_0[_S660].twist_cosine_0);
    var _S665 : f32 = _S664.x;
    var _S666 : f32 = _S664.y;
    var _S667 : f32 = select(_S656.slope_y_0, _S656.slope_x_0, _S656.shown_2.is_warp_2) * _S665 + _S663 * select(_S656.slope_x_0, _S656.slope_y_0, _S656.shown_2.is_warp_2) * _S666;
    var _S668 : f32 = select(_S656.crossing_3.weft_3.half_width_1, _S656.crossing_3.warp_3.half_width_1, _S656.shown_2.is_warp_2) * 1.0154266357421875f;
    var _S669 : f32 = _S668 * arc_sine_0(clamp(_S656.section_1.across_3 / _S668, -1.0f, 1.0f));
    var _S670 : f32 = select(_S656.here_0.plane_5.start_x_0 - _S657, _S658 - _S656.here_0.plane_5.start_y_0, _S656.shown_2.is_warp_2);
    var point_4 : SurfacePoint_0;
    point_4.hole_0 = _S656.shown_2.hole_3;
    point_4.is_warp_0 = _S656.shown_2.is_warp_2;
    point_4.warp_thread_0 = _S656.crossing_3.warp_3.thread_1;
    point_4.weft_thread_0 = _S656.crossing_3.weft_3.thread_1;
    if(is_layered_0(_S655))
    {
        point_4.warp_thread_0 = words_0[_S656.here_0.plane_5.end_numbers_0 + point_4.warp_thread_0];
        point_4.weft_thread_0 = words_0[_S656.here_0.plane_5.pick_numbers_0 + point_4.weft_thread_0];
    }
    point_4.height_2 = _S656.height_4;
    point_4.plane_0 = _S656.here_0.level_1;
    point_4.normal_1 = normalize(vec3<f32>(- _S656.slope_x_0, - _S656.slope_y_0, 1.0f));
    point_4.tangent_0 = normalize(select_vector_1(_S656.shown_2.is_warp_2, vec3<f32>(_S665, _S666, _S667), vec3<f32>(- _S666, _S665, _S667)));
    point_4.across_1 = _S656.section_1.across_3;
    point_4.fibre_across_0 = _S669 * _S662 + _S670 * _S661;
    point_4.fibre_along_0 = _S670 * _S662 - _S669 * _S661;
    var _S671 : f32 = run_share_0(_S656.shown_2.word_0);
    point_4.shown_share_0 = select(1.0f - _S671, _S671, _S656.shown_2.on_top_0);
    point_4.x_8 = _S657;
    point_4.y_2 = _S658;
    return point_4;
}

fn surface_met_0( _S672 : u32,  _S673 : f32,  _S674 : f32,  _S675 : f32,  _S676 : vec3<f32>,  _S677 : bool) -> SurfacePoint_0
{
    var _S678 : Sample_0 = sample_at_0(_S672, _S673, _S674, _S677);
    var point_5 : SurfacePoint_0 = surface_of_0(_S672, _S678, _S673, _S674, _S677);
    var _S679 : u32 = select(fabrics_0[_S672].weft_0, fabrics_0[_S672].warp_0, point_5.is_warp_0);
    var _S680 : f32 = select(_S678.crossing_3.weft_3.half_width_1, _S678.crossing_3.warp_3.half_width_1, point_5.is_warp_0) * 1.0154266357421875f;
    var _S681 : f32 = _S678.dive_1.z;
    var _S682 : f32 = _S678.slope_along_0 - (1.0f - _S681) * _S678.dive_1.y / families_0[_S679].height_scale_0;
    var _S683 : f32 = rsqrt_0(_S682 * _S682 + 1.0f);
    var _S684 : f32 = _S676.x;
    var _S685 : f32 = _S676.y;
    var _S686 : f32 = select(_S685, _S684, point_5.is_warp_0);
    var _S687 : f32 = _S676.z;
    var _S688 : f32 = (_S687 / families_0[_S679].height_scale_0 - _S682 * select(_S684, _S685, point_5.is_warp_0)) * _S683;
    var _S689 : f32 = square_1(_S680);
    var _S690 : f32 = sqrt(max(_S689 - square_1(point_5.across_1), 0.0f)) - (_S678.height_4 + _S681 * _S678.dive_1.x - _S675) / families_0[_S679].height_scale_0 * _S683;
    var _S691 : f32 = square_1(_S686) + square_1(_S688) + 9.999999960041972e-13f;
    var _S692 : f32 = point_5.across_1 * _S686 + _S690 * _S688;
    var _S693 : f32 = square_1(point_5.across_1) + square_1(_S690) - _S689;
    var _S694 : f32 = sqrt(max(square_1(_S692) - _S691 * _S693, 0.0f));
    var _S695 : f32 = clamp(select((_S694 - _S692) / _S691, - _S693 / max(_S692 + _S694, 9.999999960041972e-13f), _S692 > 0.0f), - _S680, _S680);
    var _S696 : f32 = point_5.across_1 + _S695 * _S686;
    point_5.across_1 = _S696;
    var _S697 : vec2<f32> = normalize(vec2<f32>(_S696, _S690 + _S695 * _S688));
    var _S698 : f32 = select(-1.0f, 1.0f, point_5.is_warp_0);
    var _S699 : f32 = families_0[_S679].twist_sine_0 * select(1.0f, -1.0f, _S677);
    var _S700 : f32 = _S697.x;
    var _S701 : f32 = _S699 * _S700 * _S683;
    var _S702 : f32 = _S697.y;
    var _S703 : f32 = - _S699 * _S702;
    var _S704 : f32 = families_0[_S679].twist_cosine_0 * _S683 - _S698 * _S682 * _S701;
    var _S705 : f32 = families_0[_S679].height_scale_0 * (families_0[_S679].twist_cosine_0 * _S698 * _S682 * _S683 + _S701);
    var _S706 : f32 = families_0[_S679].height_scale_0 * _S700;
    var _S707 : f32 = - families_0[_S679].height_scale_0 * _S682 * _S683 * _S702;
    point_5.normal_1 = normalize(vec3<f32>(select(_S707, _S706, point_5.is_warp_0), select(_S706, _S707, point_5.is_warp_0), _S683 * _S702));
    point_5.tangent_0 = normalize(vec3<f32>(select(- _S704, _S703, point_5.is_warp_0), select(_S703, _S704, point_5.is_warp_0), _S705));
    var _S708 : f32 = _S680 * angle_of_0(_S697);
    var _S709 : f32 = select(- _S673 - _S695 * _S684, _S674 + _S695 * _S685, point_5.is_warp_0);
    point_5.fibre_across_0 = _S708 * families_0[_S679].twist_cosine_0 + _S709 * _S699;
    point_5.fibre_along_0 = _S709 * families_0[_S679].twist_cosine_0 - _S708 * _S699;
    var _S710 : f32 = 0.00999999977648258f * _S680;
    var _S711 : f32 = - _S710;
    var _S712 : bool = _S695 < _S711;
    var _S713 : f32 = select(_S710, _S711, _S686 < 0.0f);
    var _S714 : f32 = max(_S695, 0.0f);
    point_5.x_8 = point_5.x_8 + select(_S714 * _S684, select(0.0f, _S713, point_5.is_warp_0), _S712);
    point_5.y_2 = point_5.y_2 + select(_S714 * _S685, select(_S713, 0.0f, point_5.is_warp_0), _S712);
    point_5.height_2 = select(_S675 + _S695 * _S687, _S675, _S712);
    return point_5;
}

fn hairs_over_0( _S715 : u32,  _S716 : SurfacePoint_0,  _S717 : bool,  _S718 : f32) -> Hairs_0
{
    var hairs_2 : Hairs_0;
    hairs_2.place_1 = vec2<f32>(_S716.x_8, _S716.y_2);
    hairs_2.below_1 = fabrics_0[_S715].height_high_0 - _S716.height_2;
    hairs_2.back_7 = _S717;
    hairs_2.size_3 = _S718;
    return hairs_2;
}

fn has_hairs_0( _S719 : u32) -> bool
{
    return (((families_0[fabrics_0[_S719].warp_0].hairiness_0) > 0.0f) | (((families_0[fabrics_0[_S719].weft_0].hairiness_0) > 0.0f)));
}

fn hair_towards_0( _S720 : u32,  _S721 : Hairs_0,  _S722 : vec3<f32>,  _S723 : f32) -> Hair_0
{
    var _S724 : f32 = fabrics_0[_S720].fibre_size_0;
    var _S725 : f32 = 17.0f * fabrics_0[_S720].fibre_size_0;
    var _S726 : f32 = fade_0(_S723, _S725);
    var _S727 : vec2<f32> = _S722.xy / vec2<f32>(max(_S722.z, 0.3333333432674408f));
    var _S728 : u32 = hash_key_0(select(u32(0), u32(1), _S721.back_7), ((fabrics_0[_S720].seed_0) ^ (u32(1013904242))));
    var _S729 : f32 = fabrics_0[_S720].fibre_size_0 / max(_S723, 0.07000000029802322f * fabrics_0[_S720].fibre_size_0);
    const _S730 : vec2<f32> = vec2<f32>(0.0f, 1.0f);
    var cover_3 : f32 = 0.0f;
    var hair_across_0 : vec2<f32> = _S730;
    var hair_away_0 : f32 = 0.0f;
    var is_warp_7 : bool = false;
    var number_7 : u32 = u32(0);
    for(;;)
    {
        if(((_S726 > 0.0f) & ((number_7 < u32(18)))))
        {
        }
        else
        {
            break;
        }
        var _S731 : u32 = number_7 / u32(9);
        var _S732 : u32 = number_7 / u32(3) - u32(3) * _S731;
        var _S733 : vec2<f32> = (vec2<f32>(((f32(_S731) * 6.0f + 2.0f) * _S724 + _S721.below_1)) * _S727 + _S721.place_1) / vec2<f32>(_S725);
        var _S734 : vec2<f32> = floor(_S733) + vec2<f32>(f32(number_7 - u32(3) * _S732 - u32(9) * _S731), f32(_S732)) - vec2<f32>(1.0f);
        var _S735 : u32 = hash_bits_0(_S728 + _S731, u32(i32(_S734.x)) * u32(65536) + u32(i32(_S734.y)));
        var _S736 : u32 = hash_bits_0(_S728, _S735);
        var _S737 : vec2<f32> = _S733 - _S734 - vec2<f32>(share_of_0(_S735), share_of_0((_S735 >> (u32(10)))));
        var _S738 : vec2<f32> = sine_cosine_0(3.14159274101257324f * share_of_0((_S735 >> (u32(20)))));
        var _S739 : f32 = mix(5.0f, 16.0f, share_of_0((_S736 >> (u32(10))))) / 17.0f;
        var _S740 : f32 = _S737.x;
        var _S741 : f32 = _S738.y;
        var _S742 : f32 = _S737.y;
        var _S743 : f32 = _S738.x;
        var _S744 : f32 = (_S740 * _S741 + _S742 * _S743) / _S739;
        var _S745 : f32 = 0.69999998807907104f * (2.0f * share_of_0((_S736 >> (u32(20)))) - 1.0f);
        var _S746 : f32 = 0.5f * (2.0f * share_of_0((_S735 ^ (_S736))) - 1.0f);
        var _S747 : f32 = _S744 * (3.0f * _S746 * _S744 + 2.0f * _S745);
        var _S748 : f32 = rsqrt_0(_S747 * _S747 + 1.0f);
        var _S749 : f32 = (_S742 * _S741 - _S740 * _S743 - _S739 * _S744 * _S744 * (_S746 * _S744 + _S745)) * _S748 * 17.0f;
        var _S750 : f32 = 0.2800000011920929f * max(1.0f - square_1(square_1(_S744)), 0.0f) * _S729;
        var _S751 : f32 = clamp(_S750 + 0.5f - abs(_S749) * _S729, 0.0f, min(2.0f * _S750, 1.0f));
        var _S752 : bool = ((((_S736 >> (u32(30)))) & (u32(1)))) == u32(1);
        var _S753 : bool = (((((share_of_0(_S736)) < (families_0[select(fabrics_0[_S720].weft_0, fabrics_0[_S720].warp_0, _S752)].hairiness_0)) & (((abs(_S744)) < 1.0f)))) & ((_S751 > cover_3)));
        var _S754 : vec2<f32> = vec2<f32>(- _S743 - _S747 * _S741, _S741 - _S747 * _S743) * vec2<f32>(_S748);
        var _S755 : f32 = select(cover_3, _S751, _S753);
        var _S756 : vec2<f32> = vec2<f32>(select(hair_across_0.x, _S754.x, _S753), select(hair_across_0.y, _S754.y, _S753));
        var _S757 : f32 = select(hair_away_0, _S749, _S753);
        var _S758 : bool = select(is_warp_7, _S752, _S753);
        var _S759 : u32 = number_7 + u32(1);
        cover_3 = _S755;
        hair_across_0 = _S756;
        hair_away_0 = _S757;
        is_warp_7 = _S758;
        number_7 = _S759;
    }
    var _S760 : f32 = clamp(hair_away_0 * 2.85714292526245117f, -0.80000001192092896f, 0.80000001192092896f);
    var hair_1 : Hair_0;
    hair_1.cover_1 = _S726 * cover_3;
    hair_1.normal_5 = vec3<f32>(vec2<f32>(_S760) * hair_across_0, sqrt(1.0f - _S760 * _S760));
    hair_1.tangent_4 = vec3<f32>(hair_across_0.y, - hair_across_0.x, 0.0f);
    hair_1.is_warp_5 = is_warp_7;
    hair_1.shade_0 = _S726 * 0.03255363181233406f * (families_0[fabrics_0[_S720].warp_0].hairiness_0 + families_0[fabrics_0[_S720].weft_0].hairiness_0);
    return hair_1;
}

fn thread_of_family_0( _S761 : u32,  _S762 : SurfacePoint_0) -> i32
{
    var _S763 : u32 = select(fabrics_0[_S761].weft_0, fabrics_0[_S761].warp_0, _S762.is_warp_0);
    return i32(floor((select(_S762.y_2, _S762.x_8, _S762.is_warp_0) - _S762.across_1) / families_0[_S763].period_0)) * i32(families_0[_S763].count_0) + i32(select(_S762.weft_thread_0, _S762.warp_thread_0, _S762.is_warp_0));
}

fn thread_number_0( _S764 : u32,  _S765 : SurfacePoint_0) -> u32
{
    return u32(thread_of_family_0(_S764, _S765)) * u32(2) + select(u32(0), u32(1), _S765.is_warp_0);
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

fn fibre_noise_at_0( _S766 : u32,  _S767 : u32,  _S768 : SurfacePoint_0,  _S769 : u32,  _S770 : f32) -> FibreNoise_0
{
    var _S771 : f32 = 5.0f * fabrics_0[_S766].fibre_size_0;
    var _S772 : vec2<f32> = wave_noise_0(hash_key_0(_S769, ((fabrics_0[_S766].seed_0) ^ (u32(458671337)))), _S768.fibre_along_0 / (25.0f * fabrics_0[_S766].fibre_size_0));
    var _S773 : f32 = _S768.fibre_across_0 + families_0[_S767].fibre_tilt_0 * 0.5f * 25.0f * fabrics_0[_S766].fibre_size_0 * _S772.x;
    var _S774 : vec3<f32> = fibre_cell_0(_S773, _S768.fibre_along_0, fabrics_0[_S766].fibre_size_0);
    var _S775 : vec3<f32> = fibre_cell_0(_S773, _S768.fibre_along_0, _S771);
    var noise_0 : FibreNoise_0;
    noise_0.bundle_0 = cell_noise_0(hash_key_0(_S769, ((fabrics_0[_S766].seed_0) ^ (u32(1757159915)))), _S775);
    noise_0.bundle_offset_0 = _S775.z;
    noise_0.bundle_weight_0 = fade_0(_S770, _S771);
    noise_0.fibre_0 = cell_noise_0(hash_key_0(_S769, ((fabrics_0[_S766].seed_0) ^ (u32(48610963)))), _S774);
    noise_0.fibre_weight_0 = fade_0(_S770, fabrics_0[_S766].fibre_size_0);
    noise_0.offset_2 = _S774.z;
    noise_0.slope_2 = 0.5f * _S772.y;
    return noise_0;
}

fn turned_frame_0( _S776 : u32,  _S777 : u32,  _S778 : SurfacePoint_0,  _S779 : bool,  _S780 : u32,  _S781 : f32) -> YarnFrame_0
{
    var frame_2 : YarnFrame_0;
    frame_2.normal_7 = _S778.normal_1;
    frame_2.tangent_6 = _S778.tangent_0;
    frame_2.loss_0 = 0.0f;
    frame_2.shade_2 = 0.0f;
    if((families_0[_S777].has_plies_0) > 0.0f)
    {
        var _S782 : f32 = fade_0(_S781, 1.0f / families_0[_S777].plies_per_mm_0);
        var _S783 : f32 = _S782 * 0.62000000476837158f * ply_offset_0(_S777, _S778, _S779);
        var _S784 : vec3<f32> = cross(frame_2.tangent_6, frame_2.normal_7);
        var _S785 : vec3<f32> = vec3<f32>(families_0[_S777].ply_cosine_0);
        var _S786 : vec3<f32> = vec3<f32>(select(families_0[_S777].ply_sine_0, - families_0[_S777].ply_sine_0, _S779));
        var _S787 : vec3<f32> = _S785 * _S784 + _S786 * frame_2.tangent_6;
        var _S788 : vec3<f32> = vec3<f32>(sqrt(1.0f - _S783 * _S783));
        var _S789 : vec3<f32> = vec3<f32>(_S783);
        frame_2.tangent_6 = _S785 * (_S785 * frame_2.tangent_6 - _S786 * _S784) + _S786 * (_S788 * _S787 - _S789 * frame_2.normal_7);
        frame_2.normal_7 = _S788 * frame_2.normal_7 + _S789 * _S787;
        frame_2.loss_0 = _S782 * _S782 * 0.62000000476837158f * 0.62000000476837158f / 3.0f;
    }
    var _S790 : f32 = families_0[_S777].fibre_tilt_0;
    if((families_0[_S777].fibre_tilt_0) > 0.0f)
    {
        var _S791 : FibreNoise_0 = fibre_noise_at_0(_S776, _S777, _S778, _S780, _S781);
        var _S792 : f32 = 1.09858846664428711f * _S790 * (_S791.bundle_weight_0 * _S791.bundle_0.x + _S791.fibre_weight_0 * (_S791.fibre_0.x + _S791.offset_2));
        var _S793 : f32 = _S790 * (1.42099642753601074f * (_S791.bundle_weight_0 * _S791.bundle_0.y + _S791.fibre_weight_0 * _S791.fibre_0.y) - _S791.bundle_weight_0 * _S791.slope_2);
        var _S794 : f32 = square_1(_S791.fibre_weight_0);
        frame_2.loss_0 = frame_2.loss_0 + 0.5f * _S790 * _S790 * ((0.24761904776096344f * (square_1(_S791.bundle_weight_0) + _S794) + _S794 / 3.0f) * 1.09858846664428711f * 1.09858846664428711f);
        var _S795 : vec3<f32> = cross(frame_2.tangent_6, frame_2.normal_7);
        var _S796 : vec2<f32> = sine_cosine_0(_S792);
        var _S797 : vec2<f32> = sine_cosine_0(_S793);
        var _S798 : vec3<f32> = vec3<f32>(_S796.y);
        var _S799 : vec3<f32> = vec3<f32>(_S796.x);
        var _S800 : vec3<f32> = _S798 * _S795 - _S799 * frame_2.normal_7;
        frame_2.normal_7 = _S798 * frame_2.normal_7 + _S799 * _S795;
        frame_2.tangent_6 = vec3<f32>(_S797.y) * frame_2.tangent_6 + vec3<f32>(_S797.x) * _S800;
    }
    return frame_2;
}

fn uncoloured_point_0( _S801 : u32,  _S802 : SurfacePoint_0,  _S803 : vec3<f32>,  _S804 : bool,  _S805 : bool,  _S806 : f32) -> YarnPoint_0
{
    var _S807 : u32 = fabrics_0[_S801].warp_0;
    var _S808 : u32 = fabrics_0[_S801].weft_0;
    var _S809 : u32 = select(fabrics_0[_S801].weft_0, fabrics_0[_S801].warp_0, _S802.is_warp_0);
    var _S810 : bool = (((fabrics_0[_S801].has_detail_0) != u32(0)) & ((_S806 >= 0.0f)));
    var _S811 : vec3<f32> = vec3<f32>(0.0f);
    var _S812 : vec2<f32> = vec2<f32>(0.0f);
    var point_6 : YarnPoint_0 = YarnPoint_x24init_0(false, false, false, 0.0f, 0.0f, 0.0f, _S811, _S811, _S811, 0.0f, 0.0f, Albedos_x24init_0(_S811, _S811, _S811, _S811), Hairs_x24init_0(_S812, 0.0f, false, 0.0f), 0.0f, _S812, 0.0f);
    point_6.hairs_0 = hairs_over_0(_S801, _S802, _S804, _S806);
    point_6.hair_cover_0 = 1.0f;
    var _S813 : Hair_0 = Hair_x24init_0(0.0f, _S811, _S811, false, 0.0f);
    point_6.is_warp_3 = _S802.is_warp_0;
    var _S814 : bool = (_S810 & ((has_hairs_0(_S801))));
    var hair_2 : Hair_0;
    if(_S814)
    {
        var _S815 : Hair_0 = hair_towards_0(_S801, point_6.hairs_0, _S803, _S806);
        point_6.hair_cover_0 = _S815.cover_1;
        point_6.is_warp_3 = select(_S802.is_warp_0, _S815.is_warp_5, (_S815.cover_1) > 0.5f);
        hair_2 = _S815;
    }
    else
    {
        hair_2 = _S813;
    }
    var _S816 : u32 = select(_S808, _S807, point_6.is_warp_3);
    point_6.back_9 = _S804;
    point_6.hole_5 = _S805;
    point_6.x_14 = _S802.x_8;
    point_6.y_7 = _S802.y_2;
    point_6.place_3 = vec2<f32>(_S802.x_8, _S802.y_2);
    point_6.plane_6 = _S802.plane_0;
    point_6.height_7 = _S802.height_2 + hair_2.cover_1 * point_6.hairs_0.below_1;
    point_6.normal_3 = _S802.normal_1;
    point_6.tangent_2 = _S802.tangent_0;
    point_6.surface_normal_0 = normalize(mix(_S802.normal_1, vec3<f32>(0.0f, 0.0f, 1.0f), vec3<f32>(hair_2.cover_1)));
    point_6.diffuse_gain_0 = 1.0f;
    if(_S810)
    {
        var _S817 : YarnFrame_0 = turned_frame_0(_S801, _S809, _S802, _S804, thread_number_0(_S801, _S802), _S806);
        var frame_3 : YarnFrame_0;
        if(_S814)
        {
            frame_3 = under_hair_0(_S817, hair_2);
        }
        else
        {
            frame_3 = _S817;
        }
        point_6.normal_3 = frame_3.normal_7;
        point_6.tangent_2 = frame_3.tangent_6;
        point_6.diffuse_gain_0 = diffuse_gain_2(frame_3, fabrics_0[_S801].diffuse_blend_0);
    }
    point_6.roughness_1 = families_0[_S816].roughness_0;
    return point_6;
}

fn surface_at_0( _S818 : u32,  _S819 : f32,  _S820 : f32,  _S821 : bool) -> SurfacePoint_0
{
    return surface_of_0(_S818, sample_at_0(_S818, _S819, _S820, _S821), _S819, _S820, _S821);
}

fn unoccluded_0( _S822 : u32,  _S823 : SearchQuality_0,  _S824 : f32,  _S825 : f32,  _S826 : f32,  _S827 : vec3<f32>,  _S828 : bool) -> bool
{
    if((_S827.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S822, _S823, vec3<f32>(_S824, _S825, _S826 + fabrics_0[_S822].lift_0), _S827, _S828, max_height_along_0(_S822, _S824, _S825, _S826, _S827, _S828));
}

fn is_lit_0( _S829 : u32,  _S830 : SearchQuality_0,  _S831 : YarnPoint_0,  _S832 : vec3<f32>) -> bool
{
    if(_S831.hole_5)
    {
        return true;
    }
    var _S833 : vec3<f32> = to_face_frame_0(_S832, _S831.back_9);
    var _S834 : f32 = _S833.z;
    var _S835 : bool = _S834 < 0.0f;
    var normal_12 : vec3<f32>;
    var height_13 : f32;
    if(_S835)
    {
        var _S836 : SurfacePoint_0 = surface_at_0(_S829, _S831.x_14, _S831.y_7, !_S831.back_9);
        normal_12 = _S836.normal_1;
        height_13 = _S836.height_2;
    }
    else
    {
        normal_12 = _S831.surface_normal_0;
        height_13 = _S831.height_7;
    }
    var _S837 : vec3<f32> = vec3<f32>(_S833.xy, abs(_S834));
    if((dot(normal_12, _S837)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S829, _S830, _S831.x_14, _S831.y_7, height_13, _S837, (_S831.back_9) != _S835);
}

fn hairs_lit_0( _S838 : u32,  _S839 : Hairs_0,  _S840 : vec3<f32>) -> f32
{
    return 1.0f - 0.5f * hair_towards_0(_S838, _S839, _S840, _S839.size_3 + fabrics_0[_S838].fibre_size_0).cover_1;
}

fn under_hairs_0( _S841 : u32,  _S842 : YarnPoint_0,  _S843 : vec3<f32>) -> f32
{
    if((((_S842.hair_cover_0) >= 1.0f) | (((_S843.z) <= 0.0f))))
    {
        return 1.0f;
    }
    return mix(hairs_lit_0(_S841, _S842.hairs_0, _S843), 1.0f, _S842.hair_cover_0);
}

fn components_of_point_0( _S844 : u32,  _S845 : SearchQuality_0,  _S846 : YarnPoint_0,  _S847 : vec3<f32>,  _S848 : vec3<f32>) -> Components_0
{
    var result_6 : Components_0 = no_components_0();
    result_6.hole_2 = select(0.0f, 1.0f, _S846.hole_5);
    var _S849 : bool;
    if(_S846.hole_5)
    {
        _S849 = true;
    }
    else
    {
        _S849 = !is_lit_0(_S844, _S845, _S846, _S847);
    }
    if(_S849)
    {
        return result_6;
    }
    var _S850 : vec3<f32> = to_face_frame_0(_S847, _S846.back_9);
    var _S851 : vec3<f32> = to_face_frame_0(_S848, _S846.back_9);
    var _S852 : bool = (_S850.z) < 0.0f;
    var _S853 : f32 = under_hairs_0(_S844, _S846, _S850);
    var _S854 : f32 = _S853 * _S846.diffuse_gain_0 * diffuse_reflection_0(select_vector_1(_S852, (vec3<f32>(0) - _S850), _S850), _S846.normal_3, fabrics_0[_S844].diffuse_blend_0);
    var _S855 : f32;
    if(_S852)
    {
        _S855 = transmission_1(_S850, _S851, _S846.normal_3, _S846.tangent_2, _S846.roughness_1, fabrics_0[_S844].optical_depth_0);
    }
    else
    {
        _S855 = reflection_0(_S850, _S851, _S846.normal_3, _S846.tangent_2, _S846.roughness_1, fabrics_0[_S844].optical_depth_0);
    }
    var _S856 : f32 = _S853 * _S855;
    result_6.diffuse_warp_0 = select(0.0f, _S854, _S846.is_warp_3);
    result_6.diffuse_weft_0 = select(_S854, 0.0f, _S846.is_warp_3);
    result_6.specular_warp_0 = select(0.0f, _S856, _S846.is_warp_3);
    result_6.specular_weft_0 = select(_S856, 0.0f, _S846.is_warp_3);
    result_6.light_visibility_1 = 1.0f;
    return result_6;
}

fn openness_number_0( _S857 : u32,  _S858 : u32) -> f32
{
    return table_number_0(fabrics_0[_S857].openness_0 + _S858);
}

fn blocked_of_terms_0( _S859 : u32,  _S860 : u32,  _S861 : array<f32, i32(6)>,  _S862 : u32) -> Blocked_0
{
    var shares_3 : array<f32, i32(3)>;
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
        shares_3[share_5] = 0.0f;
        var term_0 : u32 = u32(0);
        for(;;)
        {
            if(term_0 < _S862)
            {
            }
            else
            {
                break;
            }
            shares_3[share_5] = shares_3[share_5] + openness_number_0(_S859, _S860 + share_5 * _S862 + term_0) * _S861[term_0];
            term_0 = term_0 + u32(1);
        }
        shares_3[share_5] = saturate(shares_3[share_5]);
        share_5 = share_5 + u32(1);
    }
    var blocked_2 : Blocked_0;
    blocked_2.by_warp_0 = shares_3[i32(0)] * shares_3[i32(2)];
    blocked_2.by_weft_0 = shares_3[i32(0)] * (1.0f - shares_3[i32(2)]);
    blocked_2.far_0 = shares_3[i32(1)];
    return blocked_2;
}

fn blocked_at_0( _S863 : u32,  _S864 : bool,  _S865 : bool,  _S866 : f32,  _S867 : f32) -> Blocked_0
{
    var _S868 : f32 = _S867 * openness_number_0(_S863, u32(158));
    var terms_2 : array<f32, i32(6)> = array<f32, i32(6)>( 1.0f, _S866, _S868, _S866 * _S866, _S866 * _S868, _S868 * _S868 );
    return blocked_of_terms_0(_S863, u32(60) + (select(u32(0), u32(2), _S865) + select(u32(1), u32(0), _S864)) * u32(18), terms_2, u32(6));
}

fn with_blocked_0( _S869 : u32,  _S870 : Blocked_0,  _S871 : YarnPoint_0,  _S872 : bool,  _S873 : f32) -> Blocked_0
{
    if(((_S871.hole_5) | (((_S871.is_warp_3) != _S872))))
    {
        return _S870;
    }
    var _S874 : Blocked_0 = blocked_at_0(_S869, _S872, _S871.back_9, _S871.surface_normal_0.z, _S871.height_7 - _S871.plane_6);
    var result_7 : Blocked_0;
    result_7.by_warp_0 = _S870.by_warp_0 + _S873 * _S874.by_warp_0;
    result_7.by_weft_0 = _S870.by_weft_0 + _S873 * _S874.by_weft_0;
    result_7.far_0 = _S870.far_0 + _S873 * _S874.far_0;
    return result_7;
}

struct CoverageTaps_0
{
     nodes_1 : array<u32, i32(9)>,
};

fn pyramid_level_0( _S875 : u32,  _S876 : f32) -> vec3<f32>
{
    var _S877 : u32 = fabrics_0[_S875].lobes_0.levels_0 + u32(4) * u32(min(_S876, fabrics_0[_S875].lobes_0.last_level_0));
    return vec3<f32>(table_number_0(_S877), table_number_0(_S877 + u32(1)), table_number_0(_S877 + u32(2)));
}

fn coverage_taps_0( _S878 : u32,  _S879 : Footprint_0,  _S880 : bool) -> CoverageTaps_0
{
    var _S881 : Lobes_std430_0 = fabrics_0[_S878].lobes_0;
    var _S882 : f32 = Footprint_spread_side_0(_S879) * fabrics_0[_S878].lobes_0.inverse_base_size_0;
    var _S883 : vec3<f32> = pyramid_level_0(_S878, floor(binary_logarithm_0(max(0.68000000715255737f * _S882, 1.0f))));
    var _S884 : f32 = 1.0f / max(_S882, 9.99999997475242708e-07f);
    var _S885 : vec2<f32> = vec2<f32>(families_0[fabrics_0[_S878].warp_0].inverse_period_0, families_0[fabrics_0[_S878].weft_0].inverse_period_0);
    var _S886 : vec2<f32> = _S879.centre_0 * _S885;
    var _S887 : vec2<f32> = vec2<f32>(min(max(sqrt(clamp(1.29999995231628418f * (1.0f - _S884 * _S884), 0.0f, 1.0f)), 0.3333333432674408f * _S884), 1.0f));
    var _S888 : vec2<f32> = _S879.dx_0 * _S885 * _S887;
    var _S889 : vec2<f32> = _S879.dy_0 * _S885 * _S887;
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
        var _S890 : vec2<f32> = _S886 + vec2<f32>(TAP_OFFSETS_0[number_8].x) * _S888 + vec2<f32>(TAP_OFFSETS_0[number_8].y) * _S889;
        var _S891 : f32 = _S883.y;
        taps_4.nodes_1[number_8] = select(u32(0), _S881.face_nodes_0, _S880) + u32(wrapped_cell_0(_S890.y, _S883.z) * _S891 + wrapped_cell_0(_S890.x, _S891) + _S883.x);
        number_8 = number_8 + u32(1);
    }
    return taps_4;
}

fn joint_ratios_0( _S892 : u32,  _S893 : vec3<f32>,  _S894 : vec3<f32>,  _S895 : bool) -> vec2<f32>
{
    var _S896 : NodeTaps_0 = node_taps_of_0(_S894, u32(16));
    var _S897 : NodeTaps_0 = node_taps_of_0(_S893, u32(16));
    var _S898 : u32 = fabrics_0[_S892].lobes_0.joint_0 + u32(2) * (select(u32(0), u32(2), _S895) + select(u32(0), u32(1), (_S893.z) < 0.0f)) * u32(512);
    var _S899 : u32 = _S898 + u32(512);
    return clamp(vec2<f32>(1.0f) + vec2<f32>(dot(joint_terms_0(_S896, _S898, u32(0)), joint_terms_0(_S897, _S899, u32(0))), dot(joint_terms_0(_S896, _S898, u32(1)), joint_terms_0(_S897, _S899, u32(1)))), vec2<f32>(0.0f), vec2<f32>(4.0f));
}

fn coverage_of_pack_0( _S900 : u32,  _S901 : CoverageTaps_0,  _S902 : u32) -> vec4<f32>
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
        var _S903 : u32 = words_0[fabrics_0[_S900].lobes_0.coverage_0 + _S901.nodes_1[number_9] * fabrics_0[_S900].lobes_0.packs_0 + _S902];
        var even_2 : u32 = even_1 + ((_S903 & (u32(16711935))));
        var odd_2 : u32 = odd_1 + ((((_S903 >> (u32(8)))) & (u32(16711935))));
        number_9 = number_9 + u32(1);
        even_1 = even_2;
        odd_1 = odd_2;
    }
    return bytes_of_sums_0(even_1, odd_1) / vec4<f32>(9.0f);
}

fn coverage_of_holes_0( _S904 : u32,  _S905 : CoverageTaps_0) -> f32
{
    var number_10 : u32 = u32(0);
    var total_0 : u32 = u32(0);
    for(;;)
    {
        if(number_10 < u32(9))
        {
        }
        else
        {
            break;
        }
        var total_1 : u32 = total_0 + ((((words_0[fabrics_0[_S904].lobes_0.coverage_holes_0 + _S905.nodes_1[number_10] / u32(4)] >> ((u32(8) * (_S905.nodes_1[number_10] % u32(4)))))) & (u32(255))));
        number_10 = number_10 + u32(1);
        total_0 = total_1;
    }
    return f32(total_0) / 9.0f;
}

fn prefiltered_hole_0( _S906 : u32,  _S907 : CoverageTaps_0,  _S908 : NodeTaps_0,  _S909 : bool) -> f32
{
    var _S910 : f32 = interpolate_table_0(_S908, fabrics_0[_S906].lobes_0.projected_area_0 + fabrics_0[_S906].lobes_0.packs_0, fabrics_0[_S906].lobes_0.packs_0 + u32(1)).x;
    return min(coverage_of_holes_0(_S906, _S907) * _S910 * _S910 * select(fabrics_0[_S906].lobes_0.front_hole_weight_0, fabrics_0[_S906].lobes_0.back_hole_weight_0, _S909), 1.0f);
}

fn prefiltered_components_0( _S911 : u32,  _S912 : Footprint_0,  _S913 : vec3<f32>,  _S914 : vec3<f32>,  _S915 : bool) -> Components_0
{
    var _S916 : CoverageTaps_0 = coverage_taps_0(_S911, _S912, _S915);
    var _S917 : NodeTaps_0 = node_taps_0(_S914);
    var view_nodes_0 : NodeTaps_0 = _S917;
    var _S918 : NodeTaps_0 = node_taps_0(_S913);
    var light_nodes_0 : NodeTaps_0 = _S918;
    var _S919 : u32 = select(u32(0), u32(1), _S915);
    view_nodes_0.nodes_0 = view_nodes_0.nodes_0 + vec4<u32>((_S919 * u32(256)));
    light_nodes_0.nodes_0 = light_nodes_0.nodes_0 + vec4<u32>(((u32(2) * _S919 + select(u32(0), u32(1), (_S913.z) < 0.0f)) * u32(256)));
    var _S920 : vec3<f32> = half_vector_0(_S913, _S914);
    var _S921 : vec2<f32> = joint_ratios_0(_S911, _S913, _S914, _S915);
    var _S922 : Lobes_std430_0 = fabrics_0[_S911].lobes_0;
    var _S923 : u32 = select(fabrics_0[_S911].lobes_0.front_warp_packs_0, fabrics_0[_S911].lobes_0.back_warp_packs_0, _S915);
    var sums_9 : Components_0;
    sums_9.diffuse_warp_0 = 0.0f;
    sums_9.diffuse_weft_0 = 0.0f;
    sums_9.specular_warp_0 = 0.0f;
    sums_9.specular_weft_0 = 0.0f;
    sums_9.light_visibility_1 = 0.0f;
    var pack_0 : u32 = u32(0);
    var total_2 : f32 = 0.0f;
    for(;;)
    {
        if(pack_0 < (_S922.packs_0))
        {
        }
        else
        {
            break;
        }
        var _S924 : vec4<f32> = coverage_of_pack_0(_S911, _S916, pack_0);
        var _S925 : vec4<f32> = interpolate_table_0(view_nodes_0, _S922.projected_area_0 + pack_0, _S922.packs_0 + u32(1));
        var _S926 : vec4<f32> = interpolate_table_0(light_nodes_0, _S922.light_visibility_0 + pack_0, _S922.packs_0) / vec4<f32>(255.0f);
        var _S927 : vec4<f32> = interpolate_table_0(light_nodes_0, _S922.irradiance_0 + pack_0, _S922.packs_0) * vec4<f32>(0.00124827399849892f);
        var _S928 : bool = pack_0 < _S923;
        var _S929 : f32 = families_0[select(fabrics_0[_S911].weft_0, fabrics_0[_S911].warp_0, _S928)].roughness_0;
        var number_11 : u32 = u32(0);
        var diffuse_0 : f32 = 0.0f;
        var specular_0 : f32 = 0.0f;
        var lit_0 : f32 = 0.0f;
        for(;;)
        {
            if(number_11 < u32(4))
            {
            }
            else
            {
                break;
            }
            var _S930 : Group_0 = group_at_0(_S922.moments_0 + u32(12) * (u32(4) * (_S919 * _S922.packs_0 + pack_0) + number_11), _S929);
            var _S931 : f32 = _S924[number_11] * _S925[number_11] * _S925[number_11] * _S930.weight_2;
            var diffuse_1 : f32 = diffuse_0 + _S931 * _S927[number_11];
            var specular_1 : f32 = specular_0 + _S931 * layer_value_0(_S930, _S920, _S913, _S914, fabrics_0[_S911].optical_depth_0) * _S926[number_11];
            var lit_1 : f32 = lit_0 + _S931 * _S926[number_11];
            var total_3 : f32 = total_2 + _S931;
            number_11 = number_11 + u32(1);
            diffuse_0 = diffuse_1;
            specular_0 = specular_1;
            lit_0 = lit_1;
            total_2 = total_3;
        }
        sums_9.diffuse_warp_0 = sums_9.diffuse_warp_0 + select(0.0f, diffuse_0, _S928);
        sums_9.diffuse_weft_0 = sums_9.diffuse_weft_0 + select(diffuse_0, 0.0f, _S928);
        sums_9.specular_warp_0 = sums_9.specular_warp_0 + select(0.0f, specular_0, _S928);
        sums_9.specular_weft_0 = sums_9.specular_weft_0 + select(specular_0, 0.0f, _S928);
        sums_9.light_visibility_1 = sums_9.light_visibility_1 + lit_0 * select(_S921.y, _S921.x, _S928);
        pack_0 = pack_0 + u32(1);
    }
    var _S932 : f32 = prefiltered_hole_0(_S911, _S916, view_nodes_0, _S915);
    sums_9.hole_2 = _S932;
    var _S933 : f32 = 1.0f - _S932;
    var _S934 : f32 = _S933 / max(total_2, 9.999999960041972e-13f);
    var _S935 : f32 = _S934 * _S921.x;
    sums_9.diffuse_warp_0 = sums_9.diffuse_warp_0 * _S935;
    var _S936 : f32 = _S934 * _S921.y;
    sums_9.diffuse_weft_0 = sums_9.diffuse_weft_0 * _S936;
    sums_9.specular_warp_0 = sums_9.specular_warp_0 * _S935;
    sums_9.specular_weft_0 = sums_9.specular_weft_0 * _S936;
    sums_9.light_visibility_1 = min(sums_9.light_visibility_1 * _S934, _S933);
    return sums_9;
}

fn yarns_over_0( _S937 : u32,  _S938 : Footprint_0,  _S939 : bool) -> Yarns_0
{
    var _S940 : vec2<f32> = _S938.dx_0;
    var _S941 : vec2<f32> = _S938.dy_0;
    var _S942 : vec2<f32> = sqrt(_S940 * _S940 + _S941 * _S941);
    var _S943 : f32 = Footprint_spread_side_0(_S938);
    var _S944 : vec4<f32> = vec4<f32>(0.0f);
    var yarns_0 : Yarns_0 = Yarns_x24init_0(_S944, _S944, vec3<f32>(0.0f));
    var _S945 : bool = (fabrics_0[_S937].is_irregular_0) != u32(0);
    var number_12 : u32 = u32(0);
    for(;;)
    {
        if(number_12 < select(u32(0), u32(2), _S945))
        {
        }
        else
        {
            break;
        }
        var _S946 : bool = number_12 == u32(0);
        var _S947 : u32 = select(fabrics_0[_S937].weft_0, fabrics_0[_S937].warp_0, _S946);
        var _S948 : vec2<f32> = select_vector_0(_S946, _S938.centre_0, _S938.centre_0.yx);
        var _S949 : vec2<f32> = select_vector_0(_S946, _S942, _S942.yx);
        var _S950 : f32 = _S948.x;
        var _S951 : Cell_0 = locate_0(_S947, _S950);
        var yarn_3 : vec4<f32> = irregular_over_0(_S947, irregular_key_0(_S937, number_12), irregular_thread_0(_S947, _S950, _S951) + _S951.below_0 / (_S951.below_0 + _S951.above_0), _S949.x * (families_0[_S947].count_0 / families_0[_S947].period_0), _S948.y, _S949.y);
        yarn_3[i32(1)] = yarn_3[i32(1)] * (1.0f - moved_share_0(_S947, _S943));
        yarns_0.warp_4 = yarns_0.weft_4;
        yarns_0.weft_4 = yarn_3;
        number_12 = number_12 + u32(1);
    }
    var _S952 : vec2<f32> = vec2<f32>(families_0[fabrics_0[_S937].warp_0].cover_0, families_0[fabrics_0[_S937].weft_0].cover_0);
    var _S953 : f32 = select(fabrics_0[_S937].warp_on_top_0, 1.0f - fabrics_0[_S937].warp_on_top_0, _S939);
    var _S954 : vec3<f32> = shown_of_covers_0(_S952, _S953);
    var _S955 : vec3<f32> = select_vector_1(_S945, shown_of_covers_0(saturate(_S952 + _S952 * vec2<f32>(yarns_0.warp_4.y, yarns_0.weft_4.y)), _S953) / max(_S954, vec3<f32>(0.00009999999747379f)), vec3<f32>(1.0f));
    yarns_0.shares_0 = _S955;
    yarns_0.shares_0[i32(2)] = select(1.0f, _S955.z, (_S954.z) > 0.00009999999747379f);
    return yarns_0;
}

fn with_shares_0( _S956 : u32,  _S957 : Components_0,  _S958 : Yarns_0) -> Components_0
{
    var result_8 : Components_0;
    var _S959 : f32 = min(_S957.hole_2 * _S958.shares_0.z, 1.0f);
    result_8.hole_2 = _S959;
    var _S960 : f32 = _S958.shares_0.x;
    result_8.diffuse_warp_0 = _S957.diffuse_warp_0 * _S960;
    var _S961 : f32 = _S958.shares_0.y;
    result_8.diffuse_weft_0 = _S957.diffuse_weft_0 * _S961;
    result_8.specular_warp_0 = _S957.specular_warp_0 * _S960;
    result_8.specular_weft_0 = _S957.specular_weft_0 * _S961;
    result_8.light_visibility_1 = _S957.light_visibility_1 * select(1.0f, (1.0f - _S959) / max(1.0f - _S957.hole_2, 9.99999997475242708e-07f), (fabrics_0[_S956].is_irregular_0) != u32(0));
    return result_8;
}

fn stack_share_0( _S962 : u32,  _S963 : vec2<f32>,  _S964 : vec2<f32>,  _S965 : u32) -> f32
{
    if((fabrics_0[_S962].stacks_0) == u32(1))
    {
        return 1.0f;
    }
    var _S966 : u32 = fabrics_0[_S962].plane_axes_0 + u32(1);
    var _S967 : Stretch_0 = stretch_of_0(fabrics_0[_S962].plane_axes_0, _S963.x, _S964.x);
    var _S968 : Stretch_0 = stretch_of_0(_S966, _S963.y, _S964.y);
    return clamp(integral_on_top_0(fabrics_0[_S962].plane_axes_0, _S967, _S968, u32(families_0[_S966].count_0), _S965) / (lengths_0(fabrics_0[_S962].plane_axes_0, _S967).x * lengths_0(_S966, _S968).x), 0.0f, 1.0f);
}

fn albedos_over_0( _S969 : u32,  _S970 : Footprint_0,  _S971 : bool) -> FamilyAlbedos_0
{
    var _S972 : vec2<f32> = _S970.dx_0;
    var _S973 : vec2<f32> = _S970.dy_0;
    var _S974 : vec2<f32> = sqrt(_S972 * _S972 + _S973 * _S973);
    var _S975 : vec3<f32> = vec3<f32>(0.0f);
    var _S976 : Albedos_0 = Albedos_x24init_0(_S975, _S975, _S975, _S975);
    var sums_10 : FamilyAlbedos_0 = FamilyAlbedos_x24init_0(_S976, _S976);
    var _S977 : vec2<f32> = vec2<f32>(0.0f);
    var number_13 : u32 = u32(0);
    var areas_0 : vec2<f32> = _S977;
    for(;;)
    {
        if(number_13 < (plane_count_0(_S969)))
        {
        }
        else
        {
            break;
        }
        var _S978 : FamilyAlbedos_0 = albedos_in_0(plane_of_0(_S969, number_13), _S970.centre_0, _S974, _S971);
        if(!is_layered_0(_S969))
        {
            return _S978;
        }
        var _S979 : PlaneShares_0 = PlaneShares_x24init_0(0.0f, _S975, _S975);
        var warp_10 : PlaneShares_0 = _S979;
        var weft_10 : PlaneShares_0 = _S979;
        var stack_0 : u32 = u32(0);
        for(;;)
        {
            if(stack_0 < (fabrics_0[_S969].stacks_0))
            {
            }
            else
            {
                break;
            }
            var _S980 : f32 = stack_share_0(_S969, _S970.centre_0, _S974, stack_0);
            var _S981 : u32 = fabrics_0[_S969].plane_shares_0 + u32(14) * (u32(2) * (stack_0 * fabrics_0[_S969].planes_0 + number_13) + select(u32(0), u32(1), _S971));
            var _S982 : PlaneShares_0 = with_shares_at_0(warp_10, _S980, _S981);
            var _S983 : PlaneShares_0 = with_shares_at_0(weft_10, _S980, _S981 + u32(7));
            var _S984 : u32 = stack_0 + u32(1);
            warp_10 = _S982;
            weft_10 = _S983;
            stack_0 = _S984;
        }
        sums_10.warp_6 = with_plane_0(sums_10.warp_6, _S978.warp_6, warp_10);
        sums_10.weft_6 = with_plane_0(sums_10.weft_6, _S978.weft_6, weft_10);
        var areas_1 : vec2<f32> = areas_0 + vec2<f32>(warp_10.area_0, weft_10.area_0);
        number_13 = number_13 + u32(1);
        areas_0 = areas_1;
    }
    var means_0 : FamilyAlbedos_0;
    means_0.warp_6 = divided_0(sums_10.warp_6, areas_0.x);
    means_0.weft_6 = divided_0(sums_10.weft_6, areas_0.y);
    return means_0;
}

fn toned_0( _S985 : u32,  _S986 : u32,  _S987 : Albedos_0,  _S988 : vec4<f32>) -> Albedos_0
{
    var _S989 : vec3<f32> = _S987.diffuse_reflect_0 + _S987.diffuse_transmit_0;
    var _S990 : vec3<f32> = vec3<f32>(1.0f);
    var _S991 : vec3<f32> = _S990 - vec3<f32>(fabrics_0[_S985].layer_bound_0) * max(_S987.specular_reflect_0, _S987.specular_transmit_0);
    var _S992 : vec3<f32> = vec3<f32>(0.0f);
    var _S993 : vec3<f32> = max(_S990 - _S989, _S992) / (_S990 + _S989);
    var _S994 : vec3<f32> = vec3<f32>(9.99999997475242708e-07f);
    var _S995 : vec3<f32> = (_S991 / max(_S989, _S994) - _S990) / max(vec3<f32>(0.89999997615814209f) * _S993, _S994);
    var _S996 : vec3<f32> = _S990 - vec3<f32>((saturate(min(min(_S995.x, _S995.y), _S995.z)) * _S988.z)) * _S993;
    var _S997 : vec3<f32> = min(vec3<f32>(families_0[_S986].nep_red_0, families_0[_S986].nep_green_0, families_0[_S986].nep_blue_0), _S991);
    var found_1 : Albedos_0 = _S987;
    var _S998 : f32 = _S988.w;
    var _S999 : vec3<f32> = _S996 * _S987.diffuse_transmit_0 * vec3<f32>((1.0f - _S998));
    found_1.diffuse_transmit_0 = _S999;
    found_1.diffuse_reflect_0 = clamp(mix(_S996 * _S987.diffuse_reflect_0, _S997, vec3<f32>(_S998)), _S992, max(_S991 - _S999, _S992));
    return found_1;
}

fn with_tones_0( _S1000 : u32,  _S1001 : FamilyAlbedos_0,  _S1002 : Yarns_0) -> FamilyAlbedos_0
{
    if((fabrics_0[_S1000].is_irregular_0) == u32(0))
    {
        return _S1001;
    }
    var result_9 : FamilyAlbedos_0;
    result_9.warp_6 = toned_0(_S1000, fabrics_0[_S1000].warp_0, _S1001.warp_6, _S1002.warp_4);
    result_9.weft_6 = toned_0(_S1000, fabrics_0[_S1000].weft_0, _S1001.weft_6, _S1002.weft_4);
    return result_9;
}

fn detail_gain_0( _S1003 : u32,  _S1004 : u32,  _S1005 : SurfacePoint_0,  _S1006 : bool,  _S1007 : u32,  _S1008 : f32) -> vec2<f32>
{
    var _S1009 : vec2<f32> = vec2<f32>(0.0f);
    var gain_2 : vec2<f32>;
    if((families_0[_S1004].has_plies_0) > 0.0f)
    {
        gain_2 = groove_0(0.94999998807907104f * fade_0(_S1008, 1.0f / families_0[_S1004].plies_per_mm_0), ply_offset_0(_S1004, _S1005, _S1006));
    }
    else
    {
        gain_2 = _S1009;
    }
    if((families_0[_S1004].fibre_tone_0) > 0.0f)
    {
        var _S1010 : FibreNoise_0 = fibre_noise_at_0(_S1003, _S1004, _S1005, _S1007, _S1008);
        var _S1011 : f32 = 4.5f * families_0[_S1004].fibre_tone_0;
        gain_2 = gain_2 + vec2<f32>(families_0[_S1004].fibre_tone_0) * vec2<f32>(_S1010.bundle_weight_0 * _S1010.bundle_0.y + _S1010.fibre_weight_0 * _S1010.fibre_0.y, _S1010.bundle_weight_0 + _S1010.fibre_weight_0) + (groove_0(_S1011 * (_S1010.bundle_weight_0 * (0.5f * (_S1010.bundle_0.x - 1.0f) + 1.0f)), _S1010.bundle_offset_0) + groove_0(_S1011 * _S1010.fibre_weight_0, _S1010.offset_2));
    }
    if((families_0[_S1004].slub_0) > 0.0f)
    {
        gain_2 = gain_2 + vec2<f32>((0.15000000596046448f * families_0[_S1004].slub_0 * fade_0(_S1008, 1.0f / families_0[_S1004].slubs_per_mm_0))) * vec2<f32>(wave_noise_0(hash_key_0(_S1007, ((fabrics_0[_S1003].seed_0) ^ (u32(1373058189)))), select(- _S1005.x_8, _S1005.y_2, _S1005.is_warp_0) * families_0[_S1004].slubs_per_mm_0).x, 1.0f);
    }
    return vec2<f32>(max(gain_2.x, -0.94999998807907104f), gain_2.y);
}

fn vary_albedos_0( _S1012 : u32,  _S1013 : Albedos_0,  _S1014 : u32,  _S1015 : u32,  _S1016 : vec2<f32>) -> Albedos_0
{
    var _S1017 : vec3<f32> = max(_S1013.specular_reflect_0, _S1013.specular_transmit_0);
    var _S1018 : vec3<f32> = _S1013.diffuse_reflect_0 + _S1013.diffuse_transmit_0;
    var _S1019 : vec3<f32> = vec3<f32>(fabrics_0[_S1012].layer_bound_0);
    var _S1020 : vec3<f32> = vec3<f32>(1.0f);
    var _S1021 : vec3<f32> = _S1020 - _S1019 * _S1017;
    var colour_1 : f32 = bounded_gain_0(thread_gain_0(_S1014, fabrics_0[_S1012].colour_noise_0, fabrics_0[_S1012].seed_0), _S1018, _S1021);
    var _S1022 : vec3<f32> = vec3<f32>((colour_1 * (1.0f + flattened_0(_S1016.y, vec3<f32>(colour_1) * _S1018, _S1021) * _S1016.x)));
    var _S1023 : f32 = bounded_gain_0(fibre_gain_0(_S1014, _S1015, fabrics_0[_S1012].fibre_noise_0, fabrics_0[_S1012].seed_0), _S1017, min((_S1020 - _S1022 * _S1018) / _S1019, vec3<f32>(1.0f)));
    var varied_0 : Albedos_0;
    varied_0.diffuse_reflect_0 = _S1022 * _S1013.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S1022 * _S1013.diffuse_transmit_0;
    var _S1024 : vec3<f32> = vec3<f32>(_S1023);
    varied_0.specular_reflect_0 = _S1024 * _S1013.specular_reflect_0;
    varied_0.specular_transmit_0 = _S1024 * _S1013.specular_transmit_0;
    return varied_0;
}

fn varied_at_0( _S1025 : u32,  _S1026 : SurfacePoint_0,  _S1027 : Albedos_0,  _S1028 : bool,  _S1029 : f32,  _S1030 : f32) -> Albedos_0
{
    var _S1031 : u32 = thread_number_0(_S1025, _S1026);
    var _S1032 : vec3<f32> = fibre_cell_0(_S1026.fibre_across_0, _S1026.fibre_along_0, fabrics_0[_S1025].fibre_size_0);
    var _S1033 : vec2<f32> = vec2<f32>(0.0f);
    var gain_3 : vec2<f32>;
    if((((fabrics_0[_S1025].has_detail_0) != u32(0)) & ((_S1029 >= 0.0f))))
    {
        gain_3 = detail_gain_0(_S1025, select(fabrics_0[_S1025].weft_0, fabrics_0[_S1025].warp_0, _S1026.is_warp_0), _S1026, _S1028, _S1031, _S1029) * vec2<f32>(1.0f - _S1030, 1.0f);
    }
    else
    {
        gain_3 = _S1033;
    }
    return vary_albedos_0(_S1025, _S1027, _S1031, u32(i32(_S1032.x)) * u32(65536) + u32(i32(floor(_S1032.y))), gain_3);
}

fn lobes_estimate_of_pass_0( _S1034 : u32,  _S1035 : Footprint_0,  _S1036 : f32,  _S1037 : vec2<f32>,  _S1038 : vec3<f32>,  _S1039 : vec3<f32>) -> Estimate_0
{
    var _S1040 : f32;
    var _S1041 : Regime_0 = regime_of_0(_S1034, _S1035, _S1036);
    var _S1042 : bool = (_S1039.z) < 0.0f;
    var _S1043 : vec3<f32> = to_face_frame_0(_S1039, _S1042);
    var _S1044 : f32 = Footprint_spread_side_0(_S1035);
    var _S1045 : bool = varies_at_0(_S1034, _S1044);
    var _S1046 : f32 = 1.0f - _S1041.prefiltered_0;
    var _S1047 : bool = ((_S1046 > 0.0f) & (((((_S1045 | (((fabrics_0[_S1034].is_coloured_0) != u32(0))))) | (((fabrics_0[_S1034].is_irregular_0) != u32(0)))))));
    var box_0 : Footprint_0 = _S1035;
    var _S1048 : vec3<f32> = vec3<f32>(0.0f);
    var _S1049 : SurfacePoint_0 = SurfacePoint_x24init_0(false, false, u32(0), u32(0), 0.0f, _S1048, _S1048, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f);
    var _S1050 : Components_0 = no_components_0();
    var close_1 : CloseUp_0 = no_close_up_0();
    var _S1051 : u32 = select(u32(1), u32(0), _S1047);
    var points_1 : Components_0 = _S1050;
    var central_weight_0 : f32 = 0.0f;
    var central_0 : SurfacePoint_0 = _S1049;
    var number_14 : u32 = _S1051;
    for(;;)
    {
        var _S1052 : f32 = f32(number_14);
        _S1040 = _S1041.points_0;
        if(_S1052 < (_S1041.points_0 + 1.0f))
        {
        }
        else
        {
            break;
        }
        var _S1053 : bool = number_14 == u32(0);
        var _S1054 : u32 = number_14 - u32(1);
        var _S1055 : vec2<f32> = POINT_OFFSETS_0[select(_S1054, u32(0), _S1053)] + _S1037;
        var _S1056 : vec2<f32> = select_vector_0(_S1053, vec2<f32>(0.0f), _S1055 - round(_S1055));
        var _S1057 : vec2<f32> = _S1035.centre_0 + vec2<f32>(_S1056.x) * _S1035.dx_0 + vec2<f32>(_S1056.y) * _S1035.dy_0;
        var _S1058 : SearchQuality_0 = quality_of_0(select(_S1041.threads_2, 0.0f, _S1053));
        var _S1059 : Hit_0 = first_hit_0(_S1034, _S1058, _S1057.x, _S1057.y, _S1043, _S1042);
        var _S1060 : SurfacePoint_0 = surface_met_0(_S1034, _S1059.x_21, _S1059.y_14, _S1059.height_9, _S1043, _S1042);
        if(_S1053)
        {
            var central_weight_1 : f32 = select(_S1046, 0.0f, _S1059.hole_7);
            box_0.centre_0 = mix(_S1035.centre_0, vec2<f32>(_S1059.x_21, _S1059.y_14), vec2<f32>(central_weight_1));
            central_weight_0 = central_weight_1;
            central_0 = _S1060;
            number_14 = number_14 + u32(1);
            continue;
        }
        var _S1061 : YarnPoint_0 = uncoloured_point_0(_S1034, _S1060, _S1043, _S1042, _S1059.hole_7, _S1044);
        var _S1062 : f32 = min(_S1041.points_0 - f32(_S1054), 1.0f);
        var _S1063 : Components_0 = with_added_0(points_1, components_of_point_0(_S1034, _S1058, _S1061, _S1038, _S1039), _S1062);
        if((fabrics_0[_S1034].openness_0) != u32(4294967295))
        {
            close_1.warp_1 = with_blocked_0(_S1034, close_1.warp_1, _S1061, true, _S1062);
            close_1.weft_1 = with_blocked_0(_S1034, close_1.weft_1, _S1061, false, _S1062);
        }
        points_1 = _S1063;
        number_14 = number_14 + u32(1);
    }
    close_1.weight_0 = _S1046;
    var _S1064 : f32 = max(_S1040, 1.0f);
    close_1.warp_1 = scaled_0(close_1.warp_1, 1.0f / _S1064);
    close_1.weft_1 = scaled_0(close_1.weft_1, 1.0f / _S1064);
    var estimate_0 : Estimate_0;
    estimate_0.close_0 = close_1;
    estimate_0.components_0 = with_added_0(_S1050, points_1, _S1046 / _S1064);
    if((_S1041.prefiltered_0) > 0.0f)
    {
        var _S1065 : Components_0 = prefiltered_components_0(_S1034, _S1035, to_face_frame_0(_S1038, _S1042), _S1043, _S1042);
        estimate_0.components_0 = with_added_0(estimate_0.components_0, _S1065, _S1041.prefiltered_0);
    }
    var _S1066 : Yarns_0 = yarns_over_0(_S1034, box_0, _S1042);
    estimate_0.components_0 = with_shares_0(_S1034, estimate_0.components_0, _S1066);
    estimate_0.albedos_9 = with_tones_0(_S1034, albedos_over_0(_S1034, box_0, _S1042), _S1066);
    if((_S1045 & ((central_weight_0 > 0.0f))))
    {
        var _S1067 : SurfacePoint_0 = central_0;
        var _S1068 : Albedos_0;
        if(central_0.is_warp_0)
        {
            _S1068 = estimate_0.albedos_9.warp_6;
        }
        else
        {
            _S1068 = estimate_0.albedos_9.weft_6;
        }
        var _S1069 : bool;
        if((fabrics_0[_S1034].has_detail_0) != u32(0))
        {
            _S1069 = has_hairs_0(_S1034);
        }
        else
        {
            _S1069 = false;
        }
        var cover_4 : f32;
        if(_S1069)
        {
            cover_4 = hair_towards_0(_S1034, hairs_over_0(_S1034, central_0, _S1042, _S1044), _S1043, _S1044).cover_1;
        }
        else
        {
            cover_4 = 0.0f;
        }
        var _S1070 : Albedos_0 = lerp_albedos_0(_S1068, varied_at_0(_S1034, central_0, _S1068, _S1042, _S1044, cover_4), central_weight_0);
        if(_S1067.is_warp_0)
        {
            estimate_0.albedos_9.warp_6 = _S1070;
        }
        else
        {
            estimate_0.albedos_9.weft_6 = _S1070;
        }
    }
    return estimate_0;
}

fn diffuse_kept_0( _S1071 : u32,  _S1072 : vec3<f32>,  _S1073 : vec3<f32>) -> f32
{
    return (1.0f - fabrics_0[_S1071].grazing_loss_0 * fourth_power_0(max(1.0f - abs(_S1072.z), 0.0f))) * (1.0f - fabrics_0[_S1071].grazing_loss_0 * fourth_power_0(max(1.0f - abs(_S1073.z), 0.0f)));
}

fn highlight_rise_0( _S1074 : u32,  _S1075 : vec3<f32>,  _S1076 : vec3<f32>) -> f32
{
    var _S1077 : f32 = 1.0f - sqrt(clamp(0.5f * dot(_S1075, _S1076) + 0.5f, 9.99999993922529029e-09f, 1.0f));
    return fabrics_0[_S1074].grazing_gain_0 * fourth_power_0(_S1077) * _S1077;
}

fn towards_grazing_0( _S1078 : u32,  _S1079 : Albedos_0,  _S1080 : vec3<f32>,  _S1081 : vec3<f32>) -> Albedos_0
{
    var _S1082 : f32 = diffuse_kept_0(_S1078, _S1080, _S1081);
    var result_10 : Albedos_0 = _S1079;
    var _S1083 : vec3<f32> = vec3<f32>(_S1082);
    result_10.diffuse_reflect_0 = result_10.diffuse_reflect_0 * _S1083;
    result_10.diffuse_transmit_0 = result_10.diffuse_transmit_0 * _S1083;
    result_10.specular_reflect_0 = result_10.specular_reflect_0 + vec3<f32>(highlight_rise_0(_S1078, _S1080, _S1081));
    return result_10;
}

fn scattered_by_0( _S1084 : u32,  _S1085 : Albedos_0,  _S1086 : u32,  _S1087 : vec3<f32>) -> Scattered_0
{
    var _S1088 : u32 = u32(159) + u32(2) * _S1086;
    var yarn_4 : Scattered_0;
    yarn_4.back_14 = _S1087 * _S1085.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S1084, _S1088)) * _S1085.specular_reflect_0;
    yarn_4.through_0 = _S1087 * _S1085.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S1084, _S1088 + u32(1))) * _S1085.specular_transmit_0;
    return yarn_4;
}

fn sent_0( _S1089 : u32,  _S1090 : u32,  _S1091 : vec3<f32>,  _S1092 : vec3<f32>,  _S1093 : vec3<f32>,  _S1094 : vec3<f32>,  _S1095 : ptr<function, vec3<f32>>,  _S1096 : ptr<function, vec3<f32>>)
{
    var _S1097 : u32 = u32(146) + u32(4) * _S1090;
    var _S1098 : f32 = openness_number_0(_S1089, _S1097 + u32(1));
    var _S1099 : f32 = openness_number_0(_S1089, _S1097 + u32(2));
    var _S1100 : vec3<f32> = vec3<f32>(1.0f);
    var _S1101 : vec3<f32> = _S1100 - _S1093 * vec3<f32>(openness_number_0(_S1089, _S1097));
    var _S1102 : vec3<f32> = _S1100 - _S1094 * vec3<f32>(openness_number_0(_S1089, _S1097 + u32(3)));
    var _S1103 : vec3<f32> = _S1100 / (_S1101 * _S1102 - _S1093 * _S1094 * vec3<f32>((_S1098 * _S1099)));
    (*_S1095) = (_S1091 * _S1102 + _S1093 * vec3<f32>(_S1098) * _S1092) * _S1103;
    (*_S1096) = (_S1092 * _S1101 + _S1094 * vec3<f32>(_S1099) * _S1091) * _S1103;
    return;
}

fn face_sends_0( _S1104 : u32,  _S1105 : u32,  _S1106 : Scattered_0,  _S1107 : Scattered_0) -> FaceSends_0
{
    var _S1108 : u32 = u32(2) * _S1105;
    var _S1109 : u32 = u32(142) + _S1108;
    var _S1110 : f32 = openness_number_0(_S1104, _S1109);
    var _S1111 : f32 = openness_number_0(_S1104, _S1109 + u32(1));
    var _S1112 : vec3<f32> = vec3<f32>((1.0f - _S1110)) * _S1106.back_14;
    var _S1113 : vec3<f32> = vec3<f32>((1.0f - _S1111)) * _S1107.back_14;
    var sends_1 : FaceSends_0;
    var _S1114 : u32 = u32(154) + _S1108;
    var _S1115 : f32 = openness_number_0(_S1104, _S1114);
    sends_1.blocks_warp_0 = _S1115;
    var _S1116 : f32 = openness_number_0(_S1104, _S1114 + u32(1));
    sends_1.blocks_weft_0 = _S1116;
    sends_1.open_0 = _S1115 * _S1110 + _S1116 * _S1111;
    var _S1117 : vec3<f32> = vec3<f32>(_S1110) * _S1106.back_14;
    var _S1118 : vec3<f32> = vec3<f32>(_S1111) * _S1107.back_14;
    var _S1119 : vec3<f32> = sends_1.sky_warp_0;
    var _S1120 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S1104, _S1105, _S1117, _S1118, _S1112, _S1113, &(_S1119), &(_S1120));
    sends_1.sky_warp_0 = _S1119;
    sends_1.sky_weft_0 = _S1120;
    var _S1121 : vec3<f32> = sends_1.crossing_warp_0;
    var _S1122 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S1104, _S1105, _S1106.through_0, _S1107.through_0, _S1112, _S1113, &(_S1121), &(_S1122));
    sends_1.crossing_warp_0 = _S1121;
    sends_1.crossing_weft_0 = _S1122;
    return sends_1;
}

fn interior_between_0( _S1123 : u32,  _S1124 : u32,  _S1125 : u32,  _S1126 : vec3<f32>,  _S1127 : bool) -> Interior_0
{
    var _S1128 : Scattered_0 = scattered_by_0(_S1123, table_albedos_0(_S1124), u32(0), _S1126);
    var _S1129 : Scattered_0 = scattered_by_0(_S1123, table_albedos_0(_S1125), u32(1), _S1126);
    var _S1130 : FaceSends_0 = face_sends_0(_S1123, select(u32(0), u32(1), _S1127), _S1128, _S1129);
    var _S1131 : FaceSends_0 = face_sends_0(_S1123, select(u32(1), u32(0), _S1127), _S1128, _S1129);
    var _S1132 : vec3<f32> = vec3<f32>(_S1130.blocks_warp_0);
    var _S1133 : vec3<f32> = vec3<f32>(_S1130.blocks_weft_0);
    var _S1134 : vec3<f32> = _S1132 * _S1130.crossing_warp_0 + _S1133 * _S1130.crossing_weft_0;
    var _S1135 : vec3<f32> = vec3<f32>(_S1131.blocks_warp_0);
    var _S1136 : vec3<f32> = vec3<f32>(_S1131.blocks_weft_0);
    var _S1137 : vec3<f32> = _S1135 * _S1131.crossing_warp_0 + _S1136 * _S1131.crossing_weft_0;
    var _S1138 : f32 = 1.0f - _S1130.open_0;
    var _S1139 : f32 = 1.0f - _S1131.open_0;
    var _S1140 : vec3<f32> = vec3<f32>(1.0f);
    var _S1141 : vec3<f32> = _S1140 / (_S1140 - _S1134 * _S1137 * vec3<f32>((_S1138 * _S1139)));
    var _S1142 : vec3<f32> = _S1137 * (vec3<f32>(_S1130.open_0) + vec3<f32>(_S1138) * (_S1132 * _S1130.sky_warp_0 + _S1133 * _S1130.sky_weft_0)) * _S1141;
    var _S1143 : vec3<f32> = _S1134 * (vec3<f32>(_S1131.open_0) + vec3<f32>(_S1139) * (_S1135 * _S1131.sky_warp_0 + _S1136 * _S1131.sky_weft_0)) * _S1141;
    var _S1144 : FaceRadiance_0 = face_radiance_0(_S1130, _S1131.open_0, _S1142, _S1143);
    var _S1145 : FaceRadiance_0 = face_radiance_0(_S1131, _S1130.open_0, _S1143, _S1142);
    var interior_1 : Interior_0;
    interior_1.warp_9 = _S1144.warp_8;
    interior_1.weft_9 = _S1144.weft_8;
    interior_1.leaked_1 = _S1144.leaked_0;
    interior_1.far_1 = _S1145.mean_1;
    interior_1.far_leaked_0 = _S1145.leaked_0;
    return interior_1;
}

fn interior_of_0( _S1146 : u32,  _S1147 : vec3<f32>,  _S1148 : bool) -> Interior_0
{
    return interior_between_0(_S1146, families_0[fabrics_0[_S1146].warp_0].cloth_mean_0, families_0[fabrics_0[_S1146].weft_0].cloth_mean_0, _S1147, _S1148);
}

fn blocked_from_0( _S1149 : u32,  _S1150 : vec3<f32>,  _S1151 : bool,  _S1152 : bool) -> Blocked_0
{
    var terms_3 : array<f32, i32(6)>;
    view_terms_0(_S1150, &(terms_3));
    return blocked_of_terms_0(_S1149, (select(u32(0), u32(2), _S1152) + select(u32(1), u32(0), _S1151)) * u32(15), terms_3, u32(5));
}

fn warp_seen_from_0( _S1153 : u32,  _S1154 : vec3<f32>,  _S1155 : bool) -> f32
{
    var terms_4 : array<f32, i32(6)>;
    view_terms_1(_S1154, &(terms_4));
    var term_1 : u32 = u32(0);
    var share_6 : f32 = 0.0f;
    for(;;)
    {
        if(term_1 < u32(5))
        {
        }
        else
        {
            break;
        }
        var share_7 : f32 = share_6 + openness_number_0(_S1153, u32(132) + select(u32(0), u32(5), _S1155) + term_1) * terms_4[term_1];
        term_1 = term_1 + u32(1);
        share_6 = share_7;
    }
    return saturate(share_6);
}

fn bounced_of_families_0( _S1156 : u32,  _S1157 : FamilyAlbedos_0,  _S1158 : vec3<f32>,  _S1159 : Interior_0,  _S1160 : Blocked_0,  _S1161 : Blocked_0) -> Bounced_0
{
    return sum_of_0(bounced_by_0(_S1160, scattered_by_0(_S1156, _S1157.warp_6, u32(0), _S1158), _S1159), bounced_by_0(_S1161, scattered_by_0(_S1156, _S1157.weft_6, u32(1), _S1158), _S1159));
}

fn bounced_far_0( _S1162 : u32,  _S1163 : FamilyAlbedos_0,  _S1164 : vec3<f32>,  _S1165 : Interior_0,  _S1166 : vec3<f32>,  _S1167 : bool,  _S1168 : f32,  _S1169 : f32,  _S1170 : f32) -> Bounced_0
{
    var _S1171 : Blocked_0 = blocked_from_0(_S1162, _S1166, true, _S1167);
    var _S1172 : Blocked_0 = blocked_from_0(_S1162, _S1166, false, _S1167);
    var _S1173 : f32 = _S1168 / max(1.0f - _S1171.by_warp_0 - _S1171.by_weft_0, 0.10000000149011612f);
    var _S1174 : f32 = (0.0020000000949949f * warp_seen_from_0(_S1162, _S1166, _S1167) + _S1173) / (_S1173 + _S1169 / max(1.0f - _S1172.by_warp_0 - _S1172.by_weft_0, 0.10000000149011612f) + 0.0020000000949949f);
    var _S1175 : f32 = 1.0f - _S1170;
    return bounced_of_families_0(_S1162, _S1163, _S1164, _S1165, scaled_0(_S1171, _S1174 * _S1175), scaled_0(_S1172, (1.0f - _S1174) * _S1175));
}

fn bounced_over_0( _S1176 : u32,  _S1177 : Components_0,  _S1178 : CloseUp_0,  _S1179 : FamilyAlbedos_0,  _S1180 : vec3<f32>,  _S1181 : vec3<f32>) -> Bounced_0
{
    var _S1182 : bool = (_S1181.z) < 0.0f;
    var _S1183 : Interior_0 = interior_of_0(_S1176, _S1180, _S1182);
    var bounced_2 : Bounced_0 = bounced_far_0(_S1176, _S1179, _S1180, _S1183, to_face_frame_0(_S1181, _S1182), _S1182, _S1177.diffuse_warp_0, _S1177.diffuse_weft_0, _S1177.hole_2);
    if((_S1178.weight_0) > 0.0f)
    {
        var _S1184 : Bounced_0 = bounced_of_families_0(_S1176, _S1179, _S1180, _S1183, _S1178.warp_1, _S1178.weft_1);
        var _S1185 : vec3<f32> = vec3<f32>(_S1178.weight_0);
        bounced_2.reflected_0 = mix(bounced_2.reflected_0, _S1184.reflected_0, _S1185);
        bounced_2.transmitted_0 = mix(bounced_2.transmitted_0, _S1184.transmitted_0, _S1185);
    }
    return bounced_2;
}

fn composed_0( _S1186 : u32,  _S1187 : Components_0,  _S1188 : CloseUp_0,  _S1189 : FamilyAlbedos_0,  _S1190 : vec3<f32>,  _S1191 : vec3<f32>,  _S1192 : vec3<f32>) -> vec3<f32>
{
    var _S1193 : Albedos_0 = towards_grazing_0(_S1186, tinted_0(_S1189.warp_6, _S1190), _S1191, _S1192);
    var _S1194 : Albedos_0 = towards_grazing_0(_S1186, tinted_0(_S1189.weft_6, _S1190), _S1191, _S1192);
    var _S1195 : vec3<f32> = vec3<f32>(_S1187.diffuse_warp_0);
    var _S1196 : vec3<f32> = vec3<f32>(_S1187.diffuse_weft_0);
    var _S1197 : vec3<f32> = vec3<f32>(_S1187.specular_warp_0);
    var _S1198 : vec3<f32> = vec3<f32>(_S1187.specular_weft_0);
    var _S1199 : vec3<f32> = _S1193.diffuse_reflect_0 * _S1195 + _S1194.diffuse_reflect_0 * _S1196 + _S1193.specular_reflect_0 * _S1197 + _S1194.specular_reflect_0 * _S1198;
    var _S1200 : f32 = _S1192.z;
    var body_0 : vec3<f32>;
    if((_S1191.z * _S1200) < 0.0f)
    {
        body_0 = _S1193.diffuse_transmit_0 * _S1195 + _S1194.diffuse_transmit_0 * _S1196 + _S1193.specular_transmit_0 * _S1197 + _S1194.specular_transmit_0 * _S1198;
    }
    else
    {
        body_0 = _S1199;
    }
    if((fabrics_0[_S1186].openness_0) != u32(4294967295))
    {
        body_0 = body_0 + bounced_value_0(bounced_over_0(_S1186, _S1187, _S1188, _S1189, _S1190, _S1192), _S1191, _S1192) * vec3<f32>(diffuse_kept_0(_S1186, _S1191, _S1192));
    }
    var _S1201 : f32 = fabrics_0[_S1186].sheen_strength_0;
    if((fabrics_0[_S1186].sheen_strength_0) <= 0.0f)
    {
        return body_0;
    }
    var _S1202 : bool = _S1200 < 0.0f;
    var _S1203 : vec2<f32> = sheen_with_transmittance_0(to_face_frame_0(_S1191, _S1202), to_face_frame_0(_S1192, _S1202), _S1201, fabrics_0[_S1186].sheen_roughness_0);
    return vec3<f32>(_S1203.y) * body_0 + vec3<f32>(((_S1187.light_visibility_1 + _S1187.hole_2) * _S1203.x));
}

fn light_of_footprint_0( _S1204 : u32,  _S1205 : VisiblePoint_0,  _S1206 : vec2<u32>,  _S1207 : vec3<f32>) -> vec4<f32>
{
    var footprint_0 : Footprint_0;
    footprint_0.dx_0 = _S1205.draft_dx_0;
    footprint_0.dy_0 = _S1205.draft_dy_0;
    footprint_0.centre_0 = irregular_place_0(_S1204, _S1205.draft_0, Footprint_spread_side_0(footprint_0));
    var _S1208 : vec2<f32> = fract(vec2<f32>(f32(((frame_record_0.pass_number_0) & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
    var _S1209 : vec3<f32> = to_local_0(_S1205, _S1205.view_0);
    var _S1210 : u32 = light_sample_count_0();
    var _S1211 : vec3<f32> = vec3<f32>(0.0f);
    var number_15 : u32 = u32(0);
    var radiance_1 : vec3<f32> = _S1211;
    var hole_8 : f32 = 0.0f;
    for(;;)
    {
        if(number_15 < (max(_S1210, u32(1))))
        {
        }
        else
        {
            break;
        }
        var _S1212 : f32;
        if(number_15 < _S1210)
        {
            _S1212 = visibility_at_0(number_15, _S1206);
        }
        else
        {
            _S1212 = 0.0f;
        }
        var _S1213 : bool;
        if(_S1212 <= 0.0f)
        {
            _S1213 = number_15 > u32(0);
        }
        else
        {
            _S1213 = false;
        }
        if(_S1213)
        {
            number_15 = number_15 + u32(1);
            continue;
        }
        var _S1214 : LightSample_0 = light_sample_0(number_15, _S1206, _S1205.position_4);
        var _S1215 : vec3<f32> = to_local_0(_S1205, _S1214.towards_0);
        var _S1216 : Estimate_0 = lobes_estimate_of_pass_0(_S1204, footprint_0, 1.0f, _S1208, _S1215, _S1209);
        radiance_1 = radiance_1 + vec3<f32>(_S1212) * _S1214.irradiance_1 * composed_0(_S1204, _S1216.components_0, _S1216.close_0, _S1216.albedos_9, _S1207, _S1215, _S1209);
        hole_8 = _S1216.components_0.hole_2;
        number_15 = number_15 + u32(1);
    }
    var _S1217 : f32 = fabrics_0[_S1204].sheen_strength_0;
    if((fabrics_0[_S1204].sheen_strength_0) > 0.0f)
    {
        hole_8 = hole_8 * (1.0f - _S1217 * sheen_lobe_0(abs(_S1209.z), fabrics_0[_S1204].sheen_roughness_0).z);
    }
    return vec4<f32>(radiance_1, 1.0f - hole_8);
}

@compute
@workgroup_size(8, 8, 1)
fn shade_lobes(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S1218 : u32 = id_0.x;
    var _S1219 : bool;
    if(_S1218 >= (frame_record_0.width_0))
    {
        _S1219 = true;
    }
    else
    {
        _S1219 = (id_0.y) >= (frame_record_0.height_0);
    }
    if(_S1219)
    {
        return;
    }
    var _S1220 : u32 = id_0.y * frame_record_0.width_0 + _S1218;
    var _S1221 : u32 = layers_0[_S1220].face_0;
    if((layers_0[_S1220].face_0) == u32(0))
    {
        return;
    }
    var _S1222 : u32 = _S1221 - u32(1);
    var _S1223 : u32 = fabric_of_0(_S1222);
    var _S1224 : vec2<u32> = id_0.xy;
    var _S1225 : VisiblePoint_0 = visible_point_0(_S1223, _S1222, _S1224);
    var _S1226 : vec4<f32> = light_of_footprint_0(_S1223, _S1225, _S1224, filtered_albedo_0(_S1223, _S1225));
    accumulate_0(_S1220, _S1226);
    return;
}

