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
     means_0 : FamilyAlbedos_0,
     behind_0 : LayersBehind_0,
};

fn LayeredAlbedos_x24init_0( albedos_3 : FamilyAlbedos_0,  means_1 : FamilyAlbedos_0,  behind_1 : LayersBehind_0) -> LayeredAlbedos_0
{
    var _S282 : LayeredAlbedos_0;
    _S282.albedos_2 = albedos_3;
    _S282.means_0 = means_1;
    _S282.behind_0 = behind_1;
    return _S282;
}

struct LayerSums_0
{
     albedos_4 : Albedos_0,
     means_2 : Albedos_0,
     weight_3 : f32,
     lit_0 : f32,
     passed_0 : f32,
     behind_2 : LayersBehind_0,
};

fn LayerSums_x24init_0( albedos_5 : Albedos_0,  means_3 : Albedos_0,  weight_4 : f32,  lit_1 : f32,  passed_1 : f32,  behind_3 : LayersBehind_0) -> LayerSums_0
{
    var _S283 : LayerSums_0;
    _S283.albedos_4 = albedos_5;
    _S283.means_2 = means_3;
    _S283.weight_3 = weight_4;
    _S283.lit_0 = lit_1;
    _S283.passed_0 = passed_1;
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

fn rate_terms_0( direction_9 : vec3<f32>,  terms_0 : ptr<function, array<f32, i32(7)>>)
{
    var _S325 : f32 = 1.0f - direction_9.z;
    var _S326 : f32 = _S325 * _S325;
    var _S327 : f32 = direction_9.x;
    var _S328 : f32 = _S327 * _S327;
    var _S329 : f32 = direction_9.y;
    var _S330 : f32 = _S329 * _S329;
    var _S331 : f32 = _S328 - _S330;
    var _S332 : f32 = _S328 + _S330;
    (*terms_0)[i32(1)] = _S332;
    (*terms_0)[i32(0)] = sqrt(_S332);
    (*terms_0)[i32(2)] = _S326;
    (*terms_0)[i32(3)] = _S326 * _S326;
    (*terms_0)[i32(4)] = _S331;
    (*terms_0)[i32(5)] = _S327 * _S329;
    (*terms_0)[i32(6)] = _S331 * _S331;
    return;
}

fn rate_of_view_0( first_6 : u32,  terms_1 : array<f32, i32(7)>) -> f32
{
    var _S333 : f32 = table_number_0(first_6);
    var term_0 : u32 = u32(0);
    var total_0 : f32 = _S333;
    for(;;)
    {
        if(term_0 < u32(7))
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

fn rate_of_light_0( first_7 : u32,  terms_2 : array<f32, i32(7)>,  both_0 : f32) -> f32
{
    var _S334 : u32 = first_7 + u32(8);
    var _S335 : f32 = table_number_0(_S334 + u32(7)) * both_0;
    var term_1 : u32 = u32(0);
    var total_2 : f32 = _S335;
    for(;;)
    {
        if(term_1 < u32(7))
        {
        }
        else
        {
            break;
        }
        var total_3 : f32 = total_2 + table_number_0(_S334 + term_1) * terms_2[term_1];
        term_1 = term_1 + u32(1);
        total_2 = total_3;
    }
    return total_2;
}

fn rate_of_0( logarithm_0 : f32) -> f32
{
    return exponential_0(clamp(logarithm_0, -30.0f, 3.0f));
}

fn with_layer_0( sums_6 : Albedos_0,  albedos_10 : Albedos_0,  lit_2 : f32,  passed_2 : vec3<f32>) -> Albedos_0
{
    var result_2 : Albedos_0;
    var _S336 : vec3<f32> = vec3<f32>(lit_2);
    result_2.diffuse_reflect_0 = sums_6.diffuse_reflect_0 + _S336 * albedos_10.diffuse_reflect_0;
    result_2.diffuse_transmit_0 = sums_6.diffuse_transmit_0 + passed_2 * albedos_10.diffuse_transmit_0;
    result_2.specular_reflect_0 = sums_6.specular_reflect_0 + _S336 * albedos_10.specular_reflect_0;
    result_2.specular_transmit_0 = sums_6.specular_transmit_0 + passed_2 * albedos_10.specular_transmit_0;
    return result_2;
}

fn with_seen_0( sums_7 : LayerSums_0,  albedos_11 : Albedos_0,  through_0 : f32,  first_8 : u32,  share_4 : f32,  alone_0 : f32,  light_7 : vec3<f32>,  view_6 : vec3<f32>) -> LayerSums_0
{
    var of_view_0 : array<f32, i32(7)>;
    rate_terms_0(view_6, &(of_view_0));
    var _S337 : f32 = light_7.x;
    var _S338 : f32 = light_7.y;
    var _S339 : f32 = light_7.z;
    var of_light_0 : array<f32, i32(7)>;
    rate_terms_0(vec3<f32>(_S337, _S338, abs(_S339)), &(of_light_0));
    var _S340 : f32 = _S337 * view_6.x + _S338 * view_6.y;
    var _S341 : bool = _S339 < 0.0f;
    var _S342 : u32 = first_8 + u32(16) * select(u32(0), u32(1), _S341);
    var _S343 : u32 = first_8 + u32(32);
    var _S344 : f32 = share_4 * alone_0;
    var _S345 : f32 = _S344 * rate_of_0(rate_of_view_0(_S342, of_view_0) + rate_of_light_0(_S342, of_light_0, _S340));
    var _S346 : f32 = _S344 * rate_of_0(rate_of_view_0(_S343, of_view_0) + rate_of_light_0(_S343, of_light_0, _S340));
    var _S347 : f32 = share_4 * rate_of_0(rate_of_view_0(first_8 + u32(48), of_view_0));
    var _S348 : u32 = first_8 + u32(64);
    var _S349 : vec3<f32> = vec3<f32>(table_number_0(_S348), table_number_0(_S348 + u32(1)), table_number_0(_S348 + u32(2)));
    var _S350 : vec3<f32> = vec3<f32>(table_number_0(_S348 + u32(3)), table_number_0(_S348 + u32(4)), table_number_0(_S348 + u32(5)));
    var _S351 : f32 = _S344 * rate_of_0(rate_of_view_0(first_8, of_view_0));
    var _S352 : f32 = _S344 * rate_of_0(rate_of_view_0(first_8 + u32(16), of_view_0));
    var _S353 : f32 = _S344 * rate_of_0(rate_of_view_0(_S343, of_view_0));
    var result_3 : LayerSums_0;
    result_3.means_2 = with_layer_0(sums_7.means_2, albedos_11, _S351, vec3<f32>(_S352) + vec3<f32>(_S353) * _S349);
    result_3.lit_0 = sums_7.lit_0 + _S351;
    result_3.passed_0 = sums_7.passed_0 + _S352 + _S353;
    result_3.albedos_4 = with_layer_0(sums_7.albedos_4, albedos_11, _S345, vec3<f32>(_S345));
    result_3.weight_3 = sums_7.weight_3 + _S345 + select(0.0f, _S346, _S341);
    var _S354 : vec3<f32> = vec3<f32>(_S347);
    result_3.behind_2.reflected_0 = sums_7.behind_2.reflected_0 + _S354 * _S350;
    result_3.behind_2.transmitted_0 = sums_7.behind_2.transmitted_0 + _S354 * _S349 * (albedos_11.diffuse_transmit_0 + vec3<f32>(through_0) * albedos_11.specular_transmit_0);
    return result_3;
}

fn divided_0( sums_8 : Albedos_0,  lit_3 : f32,  passed_3 : f32) -> Albedos_0
{
    var _S355 : f32 = 1.0f / max(passed_3, 9.99999971718068537e-10f);
    var result_4 : Albedos_0;
    var _S356 : vec3<f32> = vec3<f32>((1.0f / max(lit_3, 9.99999971718068537e-10f)));
    result_4.diffuse_reflect_0 = sums_8.diffuse_reflect_0 * _S356;
    var _S357 : vec3<f32> = vec3<f32>(_S355);
    result_4.diffuse_transmit_0 = sums_8.diffuse_transmit_0 * _S357;
    result_4.specular_reflect_0 = sums_8.specular_reflect_0 * _S356;
    result_4.specular_transmit_0 = sums_8.specular_transmit_0 * _S357;
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
    var _S358 : vec3<f32> = room_0 / max(albedo_1, vec3<f32>(9.99999997475242708e-07f));
    return min(gain_1, max(min(min(_S358.x, _S358.y), _S358.z), 0.0f));
}

fn flattened_0( largest_0 : f32,  albedo_2 : vec3<f32>,  room_1 : vec3<f32>) -> f32
{
    var _S359 : vec3<f32> = room_1 / max(albedo_2, vec3<f32>(9.99999997475242708e-07f)) - vec3<f32>(1.0f);
    return min(max(min(min(_S359.x, _S359.y), _S359.z), 0.0f) / max(largest_0, 9.99999997475242708e-07f), 1.0f);
}

fn fibre_gain_0( thread_11 : u32,  cell_12 : u32,  amount_1 : f32,  seed_2 : u32) -> f32
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_11, cell_12, (seed_2 ^ (u32(2654435769))))), 10.0f) - 1.0f) + 1.0f;
}

fn lerp_albedos_0( first_9 : Albedos_0,  second_1 : Albedos_0,  weight_7 : f32) -> Albedos_0
{
    var albedos_12 : Albedos_0;
    var _S360 : vec3<f32> = vec3<f32>(weight_7);
    albedos_12.diffuse_reflect_0 = mix(first_9.diffuse_reflect_0, second_1.diffuse_reflect_0, _S360);
    albedos_12.diffuse_transmit_0 = mix(first_9.diffuse_transmit_0, second_1.diffuse_transmit_0, _S360);
    albedos_12.specular_reflect_0 = mix(first_9.specular_reflect_0, second_1.specular_reflect_0, _S360);
    albedos_12.specular_transmit_0 = mix(first_9.specular_transmit_0, second_1.specular_transmit_0, _S360);
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
    var _S361 : f32 = value_1 * value_1;
    return _S361 * _S361;
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

fn face_radiance_0( sends_0 : FaceSends_0,  open_of_other_0 : f32,  passed_4 : vec3<f32>,  from_other_0 : vec3<f32>) -> FaceRadiance_0
{
    var _S362 : vec3<f32> = vec3<f32>((1.0f - open_of_other_0)) * passed_4;
    var found_0 : FaceRadiance_0;
    var _S363 : vec3<f32> = sends_0.sky_warp_0 + _S362 * sends_0.crossing_warp_0;
    found_0.warp_8 = _S363;
    var _S364 : vec3<f32> = sends_0.sky_weft_0 + _S362 * sends_0.crossing_weft_0;
    found_0.weft_8 = _S364;
    found_0.mean_1 = vec3<f32>(sends_0.blocks_warp_0) * _S363 + vec3<f32>(sends_0.blocks_weft_0) * _S364;
    found_0.leaked_0 = from_other_0;
    return found_0;
}

fn view_terms_0( view_7 : vec3<f32>,  terms_3 : ptr<function, array<f32, i32(6)>>)
{
    var _S365 : f32 = 1.0f - view_7.z;
    var _S366 : f32 = _S365 * _S365;
    (*terms_3)[i32(0)] = 1.0f;
    var _S367 : f32 = view_7.x;
    var _S368 : f32 = _S367 * _S367;
    var _S369 : f32 = view_7.y;
    var _S370 : f32 = _S369 * _S369;
    (*terms_3)[i32(1)] = sqrt(max(_S368 + _S370, 9.999999960041972e-13f));
    (*terms_3)[i32(2)] = _S366;
    (*terms_3)[i32(3)] = _S366 * _S366;
    (*terms_3)[i32(4)] = _S368 - _S370;
    (*terms_3)[i32(5)] = 0.0f;
    return;
}

fn view_terms_1( view_8 : vec3<f32>,  terms_4 : ptr<function, array<f32, i32(6)>>)
{
    var _S371 : f32 = 1.0f - view_8.z;
    var _S372 : f32 = _S371 * _S371;
    (*terms_4)[i32(0)] = 1.0f;
    var _S373 : f32 = view_8.x;
    var _S374 : f32 = _S373 * _S373;
    var _S375 : f32 = view_8.y;
    var _S376 : f32 = _S375 * _S375;
    (*terms_4)[i32(1)] = sqrt(max(_S374 + _S376, 9.999999960041972e-13f));
    (*terms_4)[i32(2)] = _S372;
    (*terms_4)[i32(3)] = _S372 * _S372;
    (*terms_4)[i32(4)] = _S374 - _S376;
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
    var _S377 : vec3<f32> = vec3<f32>((blocked_1.by_warp_0 + blocked_1.by_weft_0)) * interior_0.leaked_1;
    var _S378 : vec3<f32> = vec3<f32>(blocked_1.far_0) * yarn_2.through_1;
    var bounced_0 : Bounced_0;
    bounced_0.reflected_2 = yarn_2.back_14 * (vec3<f32>(blocked_1.by_warp_0) * interior_0.warp_9 + vec3<f32>(blocked_1.by_weft_0) * interior_0.weft_9) + _S378 * interior_0.far_leaked_0;
    bounced_0.transmitted_2 = _S378 * interior_0.far_1 + yarn_2.back_14 * _S377;
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
    var _S379 : f32 = light_8.z;
    return select_vector_1((_S379 * view_9.z) < 0.0f, bounced_1.transmitted_2, bounced_1.reflected_2) * vec3<f32>((abs(_S379) * 0.31830987334251404f));
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
    var _S380 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S381 : f32 = 2.0f * sqrt(_S380) - 1.0f;
    var _S382 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_10, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S381, _S382), 0.00999999977648258f, 1.0f), clamp((1.0f - _S380) * sheen_shear_0(_S381, _S382), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S381, _S382), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_9 : vec3<f32>,  view_10 : vec3<f32>,  scale_0 : f32,  shear_0 : f32) -> f32
{
    var _S383 : f32 = light_9.z;
    if(((_S383 <= 0.0f) | (((view_10.z) <= 0.0f))))
    {
        return 0.0f;
    }
    var _S384 : vec2<f32> = view_10.xy;
    var _S385 : f32 = dot(_S384, _S384);
    var _S386 : vec2<f32> = select_vector_0(_S385 > 9.99999968265522539e-21f, _S384 * vec2<f32>(rsqrt_0(max(_S385, 9.99999968265522539e-21f))), vec2<f32>(1.0f, 0.0f));
    var _S387 : f32 = scale_0 * dot(light_9.xy, _S386) + shear_0 * _S383;
    var _S388 : f32 = scale_0 * (light_9.y * _S386.x - light_9.x * _S386.y);
    var _S389 : f32 = _S387 * _S387 + _S388 * _S388 + _S383 * _S383;
    return 0.31830987334251404f * scale_0 * scale_0 * _S383 / max(_S389 * _S389, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_10 : vec3<f32>,  view_11 : vec3<f32>,  strength_0 : f32,  roughness_11 : f32) -> vec2<f32>
{
    var _S390 : vec3<f32> = sheen_lobe_0(view_11.z, roughness_11);
    var _S391 : f32 = strength_0 * _S390.z;
    return vec2<f32>(_S391 * transformed_cosine_0(light_10, view_11, _S390.x, _S390.y), 1.0f - _S391);
}

fn accumulate_0( index_7 : u32,  light_11 : vec4<f32>)
{
    var _S392 : f32 = layers_0[index_7].share_0;
    radiance_0[index_7] = radiance_0[index_7] + vec4<f32>(layers_0[index_7].share_0) * light_11;
    layers_0[index_7].share_0 = _S392 * (1.0f - light_11.w);
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

fn uneven_shift_0( _S393 : u32,  _S394 : u32,  _S395 : u32,  _S396 : vec2<f32>) -> f32
{
    var _S397 : f32 = families_0[_S395].period_0 / families_0[_S395].count_0;
    var _S398 : u32 = hash_key_0(_S394, ((fabrics_0[_S393].seed_0) ^ (u32(625341585))));
    var _S399 : vec2<f32> = vec2<f32>(_S396.x, _S396.y / 4.0f) / vec2<f32>(_S397);
    return 0.20000000298023224f * sqrt(families_0[_S395].slub_0) * _S397 * (uneven_octave_0(_S398, _S399) * 0.66666668653488159f + uneven_octave_0(_S398 + u32(1), vec2<f32>(2.0f) * _S399 + vec2<f32>(0.5f, 0.0f)) / 3.0f);
}

fn uneven_place_0( _S400 : u32,  _S401 : vec2<f32>) -> vec2<f32>
{
    return select_vector_0((fabrics_0[_S400].has_detail_0) == u32(0), _S401, _S401 + vec2<f32>(uneven_shift_0(_S400, u32(0), fabrics_0[_S400].warp_0, _S401), uneven_shift_0(_S400, u32(1), fabrics_0[_S400].weft_0, _S401.yx)));
}

fn face_point_0( _S402 : u32,  _S403 : u32,  _S404 : f32,  _S405 : f32) -> VisiblePoint_0
{
    var _S406 : u32 = u32(3) * _S403;
    var _S407 : Vertex_0 = vertex_at_0(_S406);
    var _S408 : Vertex_0 = vertex_at_0(_S406 + u32(1));
    var _S409 : Vertex_0 = vertex_at_0(_S406 + u32(2));
    var _S410 : vec3<f32> = position_of_0(_S407);
    var _S411 : vec3<f32> = position_of_0(_S408) - _S410;
    var _S412 : vec3<f32> = position_of_0(_S409) - _S410;
    var _S413 : f32 = _S408.u_0 - _S407.u_0;
    var _S414 : f32 = _S408.v_0 - _S407.v_0;
    var _S415 : vec2<f32> = vec2<f32>(_S413, _S414);
    var _S416 : f32 = _S409.u_0 - _S407.u_0;
    var _S417 : f32 = _S409.v_0 - _S407.v_0;
    var _S418 : vec2<f32> = vec2<f32>(_S416, _S417);
    var _S419 : vec3<f32> = vec3<f32>(select(1.0f, -1.0f, (_S413 * _S417 - _S414 * _S416) < 0.0f));
    var _S420 : vec3<f32> = _S419 * (vec3<f32>(_S417) * _S411 - vec3<f32>(_S414) * _S412);
    var _S421 : vec3<f32> = _S419 * (vec3<f32>(_S413) * _S412 - vec3<f32>(_S416) * _S411);
    var point_2 : VisiblePoint_0;
    var _S422 : vec3<f32> = vec3<f32>(_S404);
    var _S423 : vec3<f32> = vec3<f32>(_S405);
    var _S424 : vec3<f32> = normalize(vec3<f32>((1.0f - _S404 - _S405)) * normal_of_0(_S407) + _S422 * normal_of_0(_S408) + _S423 * normal_of_0(_S409));
    point_2.normal_0 = _S424;
    var _S425 : vec3<f32> = normalize(_S420 - _S424 * vec3<f32>(dot(_S424, _S420)));
    point_2.axis_x_0 = _S425;
    point_2.axis_y_0 = cross(_S424, _S425);
    var _S426 : vec3<f32> = normalize(cross(_S411, _S412));
    point_2.face_normal_0 = select_vector_1((dot(_S426, _S424)) < 0.0f, (vec3<f32>(0) - _S426), _S426);
    point_2.position_4 = _S410 + _S422 * _S411 + _S423 * _S412;
    point_2.view_0 = _S424;
    var _S427 : vec2<f32> = vec2<f32>(_S407.u_0, _S407.v_0) + vec2<f32>(_S404) * _S415 + vec2<f32>(_S405) * _S418;
    point_2.uv_1 = _S427;
    var _S428 : bool = (dot(cross(_S420, _S421), _S424)) < 0.0f;
    var _S429 : vec2<f32> = vec2<f32>(fabrics_0[_S402].uv_width_0, select(fabrics_0[_S402].uv_height_0, - fabrics_0[_S402].uv_height_0, _S428));
    point_2.draft_per_uv_0 = _S429;
    point_2.draft_0 = uneven_place_0(_S402, _S427 * _S429 + vec2<f32>(0.0f, select(0.0f, fabrics_0[_S402].uv_height_0, _S428)));
    var _S430 : vec2<f32> = vec2<f32>(0.0f);
    point_2.draft_dx_0 = _S430;
    point_2.draft_dy_0 = _S430;
    return point_2;
}

fn visible_point_0( _S431 : u32,  _S432 : u32,  _S433 : vec2<u32>) -> VisiblePoint_0
{
    var _S434 : u32 = u32(3) * _S432;
    var _S435 : Vertex_0 = vertex_at_0(_S434);
    var _S436 : Vertex_0 = vertex_at_0(_S434 + u32(1));
    var _S437 : Vertex_0 = vertex_at_0(_S434 + u32(2));
    var _S438 : vec3<f32> = position_of_0(_S435);
    var _S439 : vec3<f32> = position_of_0(_S436) - _S438;
    var _S440 : vec3<f32> = position_of_0(_S437) - _S438;
    var _S441 : vec3<f32> = cross(_S439, _S440);
    var _S442 : f32 = f32(frame_record_0.width_0);
    var _S443 : vec3<f32> = camera_right_0() * vec3<f32>((2.0f / _S442));
    var _S444 : f32 = f32(frame_record_0.height_0);
    var _S445 : vec3<f32> = camera_up_0() * vec3<f32>((-2.0f / _S444));
    var _S446 : vec3<f32> = camera_forward_0() + vec3<f32>((f32(_S433.x) + 0.5f - 0.5f * _S442)) * _S443 + vec3<f32>((f32(_S433.y) + 0.5f - 0.5f * _S444)) * _S445;
    var _S447 : f32 = dot(_S446, _S441);
    var _S448 : f32 = 1.0f / select(1.00000000317107685e-30f, _S447, (abs(_S447)) > 1.00000000317107685e-30f);
    var _S449 : vec3<f32> = _S438 - camera_origin_0();
    var _S450 : vec3<f32> = vec3<f32>((dot(_S449, _S441) * _S448));
    var _S451 : vec3<f32> = _S446 * _S450 - _S449;
    var _S452 : vec3<f32> = _S450 * (_S443 - _S446 * vec3<f32>((dot(_S443, _S441) * _S448)));
    var _S453 : vec3<f32> = _S450 * (_S445 - _S446 * vec3<f32>((dot(_S445, _S441) * _S448)));
    var _S454 : vec3<f32> = vec3<f32>((1.0f / max(square_0(_S441), 1.00000000317107685e-30f)));
    var _S455 : vec3<f32> = cross(_S440, _S441) * _S454;
    var _S456 : vec3<f32> = cross(_S441, _S439) * _S454;
    var _S457 : vec2<f32> = vec2<f32>(_S436.u_0 - _S435.u_0, _S436.v_0 - _S435.v_0);
    var _S458 : vec2<f32> = vec2<f32>(_S437.u_0 - _S435.u_0, _S437.v_0 - _S435.v_0);
    var point_3 : VisiblePoint_0 = face_point_0(_S431, _S432, dot(_S451, _S455), dot(_S451, _S456));
    point_3.position_4 = _S438 + _S451;
    point_3.view_0 = (vec3<f32>(0) - normalize(_S446));
    point_3.draft_dx_0 = (vec2<f32>(dot(_S452, _S455)) * _S457 + vec2<f32>(dot(_S452, _S456)) * _S458) * point_3.draft_per_uv_0;
    point_3.draft_dy_0 = (vec2<f32>(dot(_S453, _S455)) * _S457 + vec2<f32>(dot(_S453, _S456)) * _S458) * point_3.draft_per_uv_0;
    return point_3;
}

fn filtered_albedo_0( _S459 : u32,  _S460 : VisiblePoint_0) -> vec3<f32>
{
    var _S461 : u32 = fabrics_0[_S459].albedo_map_levels_0;
    if((fabrics_0[_S459].albedo_map_levels_0) == u32(0))
    {
        return vec3<f32>(1.0f);
    }
    var _S462 : vec2<f32> = vec2<f32>(fabrics_0[_S459].uv_width_0, fabrics_0[_S459].uv_height_0);
    var _S463 : vec2<f32> = _S460.draft_dx_0 / _S462;
    var _S464 : vec2<f32> = _S460.draft_dy_0 / _S462;
    var _S465 : u32 = _S461 - u32(1);
    var _S466 : u32 = (u32(1) << (_S465));
    var _S467 : f32 = clamp(0.5f * binary_logarithm_0(max(abs(_S463.x * _S464.y - _S463.y * _S464.x), 9.99999968265522539e-21f) * (square_1(f32(_S466)) / 3.0f)), 0.0f, f32(_S461) - 1.0f);
    var _S468 : u32 = min(u32(_S467), max(_S461, u32(2)) - u32(2));
    var _S469 : u32 = min(_S468 + u32(1), _S465);
    var _S470 : u32 = (u32(1) << ((u32(2) * _S461)));
    return mix(map_level_0(fabrics_0[_S459].albedo_map_0 + (_S470 - ((_S470 >> ((u32(2) * _S468))))) / u32(3), (_S466 >> (_S468)), _S460.uv_1), map_level_0(fabrics_0[_S459].albedo_map_0 + (_S470 - ((_S470 >> ((u32(2) * _S469))))) / u32(3), (_S466 >> (_S469)), _S460.uv_1), vec3<f32>(((exponential_0(1.38629436492919922f * (_S467 - f32(_S468))) - 1.0f) / 3.0f)));
}

fn is_layered_0( _S471 : u32) -> bool
{
    return (HAS_LAYERS_0 & (((fabrics_0[_S471].planes_0) != u32(0))));
}

fn irregular_key_0( _S472 : u32,  _S473 : u32) -> u32
{
    return hash_key_0(_S473, ((fabrics_0[_S472].seed_0) ^ (u32(1821285621))));
}

fn irregular_place_0( _S474 : u32,  _S475 : vec2<f32>,  _S476 : f32) -> vec2<f32>
{
    var _S477 : u32 = fabrics_0[_S474].warp_0;
    var _S478 : u32 = fabrics_0[_S474].weft_0;
    var _S479 : bool = (((((fabrics_0[_S474].is_irregular_0) != u32(0)) & ((!is_layered_0(_S474))))) & (((max(moved_share_0(fabrics_0[_S474].warp_0, _S476), moved_share_0(fabrics_0[_S474].weft_0, _S476))) > 0.0f)));
    var number_4 : u32 = u32(0);
    var moved_0 : vec2<f32> = _S475;
    for(;;)
    {
        if(number_4 < select(u32(0), u32(2), _S479))
        {
        }
        else
        {
            break;
        }
        var _S480 : bool = number_4 == u32(0);
        var _S481 : u32 = select(_S478, _S477, _S480);
        var _S482 : vec2<f32> = select_vector_0(_S480, _S475, _S475.yx);
        var _S483 : u32 = irregular_key_0(_S474, number_4);
        var _S484 : f32 = _S482.x;
        var _S485 : Cell_0 = locate_0(_S481, _S484);
        var _S486 : f32 = irregular_thread_0(_S481, _S484, _S485);
        var _S487 : f32 = select(1.0f, -1.0f, (_S485.across_0) < 0.0f);
        var _S488 : vec2<f32> = vec2<f32>(0.0f);
        var other_3 : vec2<f32> = _S488;
        var own_2 : vec2<f32> = _S488;
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
            var _S489 : vec2<f32> = irregular_at_0(_S481, _S483, _S486 + _S487 * f32(neighbour_0), _S482.y).xy;
            var _S490 : u32 = neighbour_0 + u32(1);
            own_2 = other_3;
            other_3 = _S489;
            neighbour_0 = _S490;
        }
        var _S491 : f32 = _S485.below_0 + _S485.above_0;
        var _S492 : f32 = min(_S485.half_width_1 / _S491, 0.5f);
        var _S493 : f32 = min(_S492 * (2.0f + own_2.y + other_3.y), 1.0f);
        var _S494 : vec2<f32> = sqrt(max(vec2<f32>(1.0f) + vec2<f32>(own_2.x, other_3.x), vec2<f32>(0.25f)));
        var _S495 : f32 = _S494.x;
        var _S496 : f32 = _S493 * _S495 / (_S495 + _S494.y);
        var _S497 : f32 = abs(_S485.across_0) / _S491;
        var _S498 : f32 = 1.0f - _S493;
        var _S499 : f32 = _S497 - _S496;
        var _S500 : f32 = moved_share_0(_S481, _S476) * _S487 * _S491 * (select(select((_S499 - _S498) / max(_S493 - _S496, 9.99999997475242708e-07f) * _S492 + (1.0f - _S492), _S499 / max(_S498, 9.99999997475242708e-07f) * (1.0f - 2.0f * _S492) + _S492, _S499 < _S498), _S497 * _S492 / _S496, _S499 < 0.0f) - _S497);
        var moved_1 : vec2<f32> = moved_0 + select_vector_0(_S480, vec2<f32>(_S500, 0.0f), vec2<f32>(0.0f, _S500));
        number_4 = number_4 + u32(1);
        moved_0 = moved_1;
    }
    return moved_0;
}

fn light_sample_count_0() -> u32
{
    return frame_record_0.lights_0 + frame_record_0.environment_samples_0;
}

fn visibility_at_0( _S501 : u32,  _S502 : vec2<u32>) -> f32
{
    if((frame_record_0.casts_shadows_0) == u32(0))
    {
        return 1.0f;
    }
    return visibilities_0[(_S501 * frame_record_0.height_0 + _S502.y) * frame_record_0.width_0 + _S502.x];
}

struct LightSample_0
{
     towards_0 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_1 : f32,
};

fn environment_texel_0( _S503 : u32,  _S504 : u32) -> vec3<f32>
{
    var _S505 : u32 = frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + frame_record_0.environment_rows_0 * (frame_record_0.environment_columns_0 + u32(1)) + u32(3) * (_S503 * frame_record_0.environment_columns_0 + _S504);
    return vec3<f32>(scene_number_0(_S505), scene_number_0(_S505 + u32(1)), scene_number_0(_S505 + u32(2)));
}

fn sample_environment_0( _S506 : vec2<f32>,  _S507 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S508 : u32 = frame_record_0.environment_rows_0;
    var _S509 : Choice_0 = choose_0(frame_record_0.environment_table_0, frame_record_0.environment_rows_0, _S506.y);
    var _S510 : u32 = frame_record_0.environment_columns_0;
    var _S511 : Choice_0 = choose_0(frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + _S509.index_5 * (frame_record_0.environment_columns_0 + u32(1)), frame_record_0.environment_columns_0, _S506.x);
    var _S512 : vec3<f32> = environment_texel_0(_S509.index_5, _S511.index_5);
    (*_S507) = _S512 * vec3<f32>((frame_record_0.environment_total_0 / max(mean_0(_S512), 9.99999968265522539e-21f)));
    var _S513 : f32 = 3.14159274101257324f / f32(_S508);
    var _S514 : f32 = mix(sine_cosine_0(f32(_S509.index_5) * _S513).y, sine_cosine_0(f32(_S509.index_5 + u32(1)) * _S513).y, _S509.remainder_0);
    var _S515 : f32 = sqrt(max(1.0f - _S514 * _S514, 0.0f));
    var _S516 : vec2<f32> = sine_cosine_0((f32(_S511.index_5) + _S511.remainder_0) * (6.28318548202514648f / f32(_S510)));
    var _S517 : f32 = _S515 * _S516.x;
    var _S518 : f32 = - _S515 * _S516.y;
    return vec3<f32>(frame_record_0.environment_cosine_0 * _S517 + frame_record_0.environment_sine_0 * _S518, _S514, frame_record_0.environment_cosine_0 * _S518 - frame_record_0.environment_sine_0 * _S517);
}

fn light_sample_0( _S519 : u32,  _S520 : vec2<u32>,  _S521 : vec3<f32>) -> LightSample_0
{
    var sample_1 : LightSample_0;
    sample_1.distance_1 = 1.00000001504746622e+30f;
    var _S522 : u32 = frame_record_0.lights_0;
    if(_S519 >= (frame_record_0.lights_0))
    {
        var weight_8 : vec3<f32>;
        var _S523 : vec3<f32> = sample_environment_0(pixel_sequence_0(_S520, frame_record_0.pass_number_0 * frame_record_0.environment_samples_0 + (_S519 - _S522), u32(3)), &(weight_8));
        sample_1.towards_0 = _S523;
        sample_1.irradiance_1 = weight_8 / vec3<f32>(f32(frame_record_0.environment_samples_0));
        return sample_1;
    }
    var _S524 : Light_0 = scene_light_0(frame_record_0.light_records_0 + u32(7) * _S519);
    sample_1.irradiance_1 = vec3<f32>(_S524.red_0, _S524.green_0, _S524.blue_0);
    sample_1.towards_0 = vec3<f32>(_S524.x_7, _S524.y_1, _S524.z_1);
    if((_S524.is_point_0) != u32(0))
    {
        var _S525 : vec3<f32> = sample_1.towards_0 - _S521;
        var _S526 : f32 = max(square_0(_S525), 9.999999960041972e-13f);
        sample_1.distance_1 = sqrt(_S526);
        sample_1.irradiance_1 = sample_1.irradiance_1 / vec3<f32>(_S526);
        sample_1.towards_0 = normalize(_S525);
    }
    return sample_1;
}

struct Estimate_0
{
     components_0 : Components_0,
     close_0 : CloseUp_0,
     albedos_14 : FamilyAlbedos_0,
     means_4 : FamilyAlbedos_0,
     behind_4 : LayersBehind_0,
};

struct Regime_0
{
     prefiltered_0 : f32,
     threads_2 : f32,
     points_0 : f32,
};

fn regime_of_0( _S527 : u32,  _S528 : Footprint_0,  _S529 : f32) -> Regime_0
{
    var _S530 : f32 = Footprint_spread_side_0(_S528);
    var _S531 : f32 = clamp((binary_logarithm_0(max(_S530, 9.99999971718068537e-10f)) - fabrics_0[_S527].lobes_0.unit_level_0 - -0.51457315683364868f) / 1.51457309722900391f, 0.0f, 1.0f);
    var regime_0 : Regime_0;
    var _S532 : f32 = _S531 * _S531 * (3.0f - 2.0f * _S531);
    regime_0.prefiltered_0 = _S532;
    var _S533 : f32 = _S530 * fabrics_0[_S527].lobes_0.threads_per_mm_0;
    regime_0.threads_2 = _S533;
    regime_0.points_0 = select(0.0f, clamp(_S533 * 12.0f, 1.0f, max(mix(8.0f, 4.0f, _S532) / _S529, 1.0f)), _S532 < 1.0f);
    return regime_0;
}

fn varies_at_0( _S534 : u32,  _S535 : f32) -> bool
{
    return (((((fabrics_0[_S534].fibre_noise_0) > 0.0f) | (((fabrics_0[_S534].colour_noise_0) > 0.0f)))) | (((((fabrics_0[_S534].has_detail_0) != u32(0)) & ((_S535 >= 0.0f))))));
}

struct Hit_0
{
     x_21 : f32,
     y_14 : f32,
     hole_7 : bool,
     height_9 : f32,
};

fn whole_plane_0( _S536 : u32) -> Plane_0
{
    var plane_9 : Plane_0;
    plane_9.warp_2 = fabrics_0[_S536].warp_0;
    plane_9.weft_2 = fabrics_0[_S536].weft_0;
    plane_9.run_words_1 = fabrics_0[_S536].run_words_0;
    plane_9.ends_2 = fabrics_0[_S536].ends_1;
    plane_9.end_numbers_0 = u32(0);
    plane_9.pick_numbers_0 = u32(0);
    plane_9.max_heights_1 = fabrics_0[_S536].max_heights_0;
    plane_9.max_height_columns_1 = fabrics_0[_S536].max_height_columns_0;
    plane_9.height_low_1 = fabrics_0[_S536].height_low_0;
    plane_9.height_high_1 = fabrics_0[_S536].height_high_0;
    plane_9.front_level_0 = 0.0f;
    plane_9.back_level_0 = 0.0f;
    plane_9.start_x_0 = 0.0f;
    plane_9.start_y_0 = 0.0f;
    plane_9.fine_x_0 = 0.0f;
    plane_9.fine_y_0 = 0.0f;
    return plane_9;
}

fn plane_order_0( _S537 : u32,  _S538 : f32,  _S539 : f32,  _S540 : bool) -> u32
{
    var _S541 : u32 = select(u32(0), locate_varied_0(fabrics_0[_S537].plane_axes_0 + u32(1), _S539).thread_1 * fabrics_0[_S537].ends_1 + locate_varied_0(fabrics_0[_S537].plane_axes_0, _S538).thread_1, (fabrics_0[_S537].stacks_0) > u32(1));
    return fabrics_0[_S537].plane_orders_0 + u32(2) * fabrics_0[_S537].planes_0 * (u32(2) * ((((words_0[fabrics_0[_S537].regions_0 + _S541 / u32(4)] >> ((u32(8) * (_S541 % u32(4)))))) & (u32(255)))) + select(u32(0), u32(1), _S540));
}

fn first_bounds_0( _S542 : u32,  _S543 : u32,  _S544 : f32,  _S545 : f32,  _S546 : bool,  _S547 : bool,  _S548 : bool) -> vec3<f32>
{
    var _S549 : vec3<f32> = bounds_in_0(plane_at_0(fabrics_0[_S542].plane_records_0 + words_0[_S543] * u32(16)), _S544, _S545, _S546, _S547, _S548);
    var _S550 : Cell_0 = locate_varied_0(fabrics_0[_S542].plane_axes_0, _S544);
    var _S551 : Cell_0 = locate_varied_0(fabrics_0[_S542].plane_axes_0 + u32(1), _S545);
    var _S552 : bool = (fabrics_0[_S542].stacks_0) == u32(1);
    return vec3<f32>(_S549.x + table_number_0(_S543 + u32(1)), min(_S549.y, select(select(_S550.below_0, _S550.above_0, _S547), 1.0e+06f, _S552)), min(_S549.z, select(select(_S551.below_0, _S551.above_0, _S548), 1.0e+06f, _S552)));
}

fn plane_shown_0( _S553 : u32,  _S554 : f32,  _S555 : f32,  _S556 : bool,  _S557 : bool,  _S558 : bool) -> PlaneHere_0
{
    var here_6 : PlaneHere_0;
    here_6.plane_5 = whole_plane_0(_S553);
    here_6.number_2 = u32(0);
    here_6.level_1 = 0.0f;
    here_6.edge_x_0 = 1.0e+06f;
    here_6.edge_y_0 = 1.0e+06f;
    here_6.bounds_0 = vec3<f32>(0.0f);
    if(!is_layered_0(_S553))
    {
        return here_6;
    }
    var _S559 : u32 = plane_order_0(_S553, _S554, _S555, _S556);
    var _S560 : vec3<f32> = first_bounds_0(_S553, _S559, _S554, _S555, _S556, _S557, _S558);
    here_6.bounds_0 = _S560;
    var _S561 : bool = (fabrics_0[_S553].stacks_0) == u32(1);
    here_6.edge_x_0 = select(_S560.y, 1.0e+06f, _S561);
    here_6.edge_y_0 = select(_S560.z, 1.0e+06f, _S561);
    var is_hole_0 : bool = true;
    var rank_1 : u32 = u32(0);
    for(;;)
    {
        if(((rank_1 < (fabrics_0[_S553].planes_0)) & (is_hole_0)))
        {
        }
        else
        {
            break;
        }
        var _S562 : u32 = _S559 + u32(2) * rank_1;
        var _S563 : u32 = words_0[_S562];
        here_6.number_2 = _S563;
        here_6.level_1 = table_number_0(_S562 + u32(1));
        here_6.plane_5 = plane_at_0(fabrics_0[_S553].plane_records_0 + _S563 * u32(16));
        var _S564 : Cell_0 = locate_varied_0(here_6.plane_5.warp_2, _S554 - here_6.plane_5.start_x_0);
        var _S565 : Cell_0 = locate_varied_0(here_6.plane_5.weft_2, _S555 - here_6.plane_5.start_y_0);
        var is_hole_1 : bool = !((((abs(_S564.across_0)) < (_S564.half_width_1)) | (((abs(_S565.across_0)) < (_S565.half_width_1)))));
        here_6.edge_x_0 = min(here_6.edge_x_0, select(1.0e+06f, hole_edge_0(_S564, _S557), is_hole_1));
        here_6.edge_y_0 = min(here_6.edge_y_0, select(1.0e+06f, hole_edge_0(_S565, _S558), is_hole_1));
        var _S566 : u32 = rank_1 + u32(1);
        is_hole_0 = is_hole_1;
        rank_1 = _S566;
    }
    return here_6;
}

fn sample_at_0( _S567 : u32,  _S568 : f32,  _S569 : f32,  _S570 : bool) -> Sample_0
{
    return sample_in_0(plane_shown_0(_S567, _S568, _S569, _S570, true, true), _S568, _S569, _S570);
}

fn steps_per_length_0( _S571 : u32,  _S572 : SearchQuality_0,  _S573 : vec3<f32>) -> f32
{
    return max(max(abs(_S573.x) * fabrics_0[_S571].threads_per_x_0, abs(_S573.y) * fabrics_0[_S571].threads_per_y_0) * _S572.steps_per_thread_0, abs(_S573.z) * fabrics_0[_S571].per_relief_0 * _S572.steps_per_relief_0);
}

fn plane_count_0( _S574 : u32) -> u32
{
    return select(u32(1), fabrics_0[_S574].planes_0, is_layered_0(_S574));
}

fn probe_0( _S575 : u32,  _S576 : f32,  _S577 : f32,  _S578 : bool,  _S579 : bool,  _S580 : bool) -> Probe_0
{
    var _S581 : PlaneHere_0 = plane_shown_0(_S575, _S576, _S577, _S578, _S579, _S580);
    var _S582 : Sample_0 = sample_in_0(_S581, _S576, _S577, _S578);
    var probe_1 : Probe_0;
    probe_1.height_5 = _S582.height_4;
    probe_1.hole_4 = _S582.shown_2.hole_3;
    probe_1.slope_x_1 = _S582.slope_x_0;
    probe_1.slope_y_1 = _S582.slope_y_0;
    var _S583 : bool = !is_layered_0(_S575);
    probe_1.yarn_1 = select(_S582.crossing_3.weft_3.thread_1 * u32(2), _S582.crossing_3.warp_3.thread_1 * u32(2) + u32(1), _S582.shown_2.is_warp_2) * plane_count_0(_S575) + _S581.number_2;
    probe_1.cell_max_0 = select(_S581.bounds_0.x, cell_maximum_0(_S581.plane_5, _S582.crossing_3), _S583);
    probe_1.side_x_0 = select(_S581.bounds_0.y, select(_S582.crossing_3.warp_3.below_0, _S582.crossing_3.warp_3.above_0, _S579), _S583);
    probe_1.side_y_0 = select(_S581.bounds_0.z, select(_S582.crossing_3.weft_3.below_0, _S582.crossing_3.weft_3.above_0, _S580), _S583);
    probe_1.edge_x_1 = min(_S581.edge_x_0, outline_distance_0(_S582.crossing_3.warp_3, _S582.shown_2, _S582.run_2, !_S582.shown_2.is_warp_2, _S579));
    probe_1.edge_y_1 = min(_S581.edge_y_0, outline_distance_0(_S582.crossing_3.weft_3, _S582.shown_2, _S582.run_2, _S582.shown_2.is_warp_2, _S580));
    return probe_1;
}

fn is_free_0( _S584 : u32,  _S585 : SearchQuality_0,  _S586 : vec3<f32>,  _S587 : vec3<f32>,  _S588 : bool,  _S589 : f32) -> bool
{
    var _S590 : f32 = _S587.z;
    if(_S590 <= 0.0f)
    {
        return false;
    }
    var _S591 : f32 = 1.0f / max(_S585.shadow_share_0 * steps_per_length_0(_S584, _S585, _S587), 9.99999971718068537e-10f);
    var _S592 : StepControl_0 = step_control_0(_S587.xy, _S591);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_4 : u32 = u32(0);
    var distance_2 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        if(((count_4 < u32(1024)) & (((_S586.z + _S590 * distance_2) < _S589))))
        {
        }
        else
        {
            break;
        }
        var _S593 : vec3<f32> = _S586 + _S587 * vec3<f32>(distance_2);
        var _S594 : Probe_0 = probe_0(_S584, _S593.x, _S593.y, _S588, _S592.right_1, _S592.up_1);
        var _S595 : f32 = _S593.z;
        var _S596 : f32 = _S595 - _S594.height_5;
        var _S597 : f32 = _S590 - _S594.slope_x_1 * _S587.x - _S594.slope_y_1 * _S587.y;
        if(((!_S594.hole_4) & ((_S596 < 0.0f))))
        {
            return false;
        }
        var _S598 : f32 = way_back_to_dip_0(previous_3, _S596, _S597, last_step_0, _S594);
        if(_S598 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S598;
            distance_2 = distance_2 - _S598;
            last_step_0 = last_step_1;
            count_4 = count_4 + u32(1);
            continue;
        }
        var _S599 : bool = _S595 > (_S594.cell_max_0);
        var last_step_2 : f32 = select(StepControl_to_next_sample_0(_S592, _S594, _S596, _S597), max(StepControl_to_cell_exit_0(_S592, _S594.side_x_0, _S594.side_y_0), _S591), _S599);
        var distance_3 : f32 = distance_2 + last_step_2;
        previous_3 = after_sample_0(_S596, _S597, _S594, _S599);
        distance_2 = distance_3;
        last_step_0 = last_step_2;
        count_4 = count_4 + u32(1);
    }
    return true;
}

fn passes_through_0( _S600 : u32,  _S601 : SearchQuality_0,  _S602 : f32,  _S603 : f32,  _S604 : vec3<f32>,  _S605 : bool) -> bool
{
    if(!sample_at_0(_S600, _S602, _S603, _S605).shown_2.hole_3)
    {
        return false;
    }
    var _S606 : vec3<f32> = vec3<f32>(_S602, _S603, 0.0f);
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
        var _S607 : bool = is_free_0(_S600, _S601, _S606, select_vector_1(side_2 == u32(0), _S604, vec3<f32>(- _S604.x, - _S604.y, _S604.z)), _S605 != (side_2 == u32(1)), fabrics_0[_S600].height_high_0);
        var _S608 : u32 = side_2 + u32(1);
        passes_0 = _S607;
        side_2 = _S608;
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

fn plane_of_0( _S609 : u32,  _S610 : u32) -> Plane_0
{
    if(!is_layered_0(_S609))
    {
        return whole_plane_0(_S609);
    }
    return plane_at_0(fabrics_0[_S609].plane_records_0 + _S610 * u32(16));
}

fn max_height_along_0( _S611 : u32,  _S612 : f32,  _S613 : f32,  _S614 : f32,  _S615 : vec3<f32>,  _S616 : bool) -> f32
{
    var _S617 : f32 = _S615.x;
    var _S618 : f32 = _S615.y;
    var _S619 : u32 = select(u32(0), u32(1), _S617 > 0.0f) + select(u32(0), u32(2), _S618 > 0.0f);
    var _S620 : f32 = max(abs(_S617) * fabrics_0[_S611].threads_per_x_0, abs(_S618) * fabrics_0[_S611].threads_per_y_0) / _S615.z;
    var levels_4 : vec4<f32> = vec4<f32>(-1.00000001504746622e+30f);
    var number_5 : u32 = u32(0);
    for(;;)
    {
        if(number_5 < (plane_count_0(_S611)))
        {
        }
        else
        {
            break;
        }
        var _S621 : Plane_0 = plane_of_0(_S611, number_5);
        var _S622 : u32 = (words_0[_S621.max_heights_1 + u32(4) * (locate_0(_S621.weft_2, _S613 - _S621.start_y_0).thread_1 / u32(2) * _S621.max_height_columns_1 + locate_0(_S621.warp_2, _S612 - _S621.start_x_0).thread_1 / u32(2)) + _S619] >> (u32(select(i32(0), i32(4), _S616))));
        var _S623 : vec4<f32> = max(levels_4, vec4<f32>(f32((_S622 & (u32(15)))), f32((((_S622 >> (u32(8)))) & (u32(15)))), f32((((_S622 >> (u32(16)))) & (u32(15)))), f32((((_S622 >> (u32(24)))) & (u32(15))))) * vec4<f32>(0.06666667014360428f) * vec4<f32>(_S621.height_high_1) + vec4<f32>(select(_S621.front_level_0, _S621.back_level_0, _S616)));
        var _S624 : u32 = number_5 + u32(1);
        levels_4 = _S623;
        number_5 = _S624;
    }
    var max_height_0 : f32 = fabrics_0[_S611].height_high_0;
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
        if(((max_height_0 - _S614) * _S620) <= (PYRAMID_RADII_0[number_6]))
        {
            max_height_0 = min(max_height_0, levels_4[number_6]);
        }
        number_6 = number_6 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S625 : u32,  _S626 : f32,  _S627 : f32,  _S628 : bool,  _S629 : bool,  _S630 : bool) -> vec3<f32>
{
    if(is_layered_0(_S625))
    {
        return first_bounds_0(_S625, plane_order_0(_S625, _S626, _S627, _S628), _S626, _S627, _S628, _S629, _S630);
    }
    return bounds_in_0(whole_plane_0(_S625), _S626, _S627, _S628, _S629, _S630);
}

fn first_sample_height_0( _S631 : u32,  _S632 : ViewRay_0,  _S633 : StepControl_0,  _S634 : bool) -> f32
{
    var _S635 : f32 = max_height_along_0(_S631, _S632.origin_0.x, _S632.origin_0.y, 0.0f, vec3<f32>(_S632.slope_1, 1.0f), _S634);
    var count_5 : u32 = u32(0);
    var height_11 : f32 = _S635;
    for(;;)
    {
        if(count_5 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S636 : vec2<f32> = ViewRay_at_0(_S632, height_11);
        var _S637 : vec3<f32> = cell_bounds_0(_S631, _S636.x, _S636.y, _S634, _S633.right_1, _S633.up_1);
        var _S638 : f32 = height_11 - _S637.x;
        var _S639 : f32 = StepControl_to_cell_exit_0(_S633, _S637.y, _S637.z);
        var height_12 : f32 = height_11 - clamp(_S638, 0.0f, _S639);
        if(_S638 <= _S639)
        {
            height_11 = height_12;
            break;
        }
        count_5 = count_5 + u32(1);
        height_11 = height_12;
    }
    return height_11;
}

fn search_down_0( _S640 : u32,  _S641 : ViewRay_0,  _S642 : StepControl_0,  _S643 : bool) -> ViewRayEnd_0
{
    var _S644 : f32 = fabrics_0[_S640].height_low_0 - (fabrics_0[_S640].height_high_0 - fabrics_0[_S640].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_10 = first_sample_height_0(_S640, _S641, _S642, _S643);
    end_1.last_step_3 = _S642.epsilon_0;
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
        var _S645 : vec2<f32> = ViewRay_at_0(_S641, end_1.height_10);
        var _S646 : Probe_0 = probe_0(_S640, _S645.x, _S645.y, _S643, _S642.right_1, _S642.up_1);
        var _S647 : f32 = end_1.height_10 - _S646.height_5;
        var _S648 : f32 = ViewRay_rate_0(_S641, _S646);
        end_1.depth_2 = - _S647;
        end_1.rate_4 = _S648;
        var _S649 : bool = !_S646.hole_4;
        end_1.smooth_0 = ((((end_1.previous_4.known_0) & (_S649))) & (((end_1.previous_4.yarn_0) == (_S646.yarn_1))));
        if((((_S649 & ((_S647 <= 0.0f)))) | (((end_1.height_10) <= _S644))))
        {
            break;
        }
        var _S650 : f32 = way_back_to_dip_0(end_1.previous_4, _S647, _S648, end_1.last_step_3, _S646);
        if(_S650 >= 0.0f)
        {
            end_1.height_10 = end_1.height_10 + _S650;
            end_1.last_step_3 = end_1.last_step_3 - _S650;
            count_6 = count_6 + u32(1);
            continue;
        }
        var _S651 : f32 = min(StepControl_to_cell_exit_0(_S642, _S646.side_x_0, _S646.side_y_0), end_1.height_10 - _S646.cell_max_0);
        var _S652 : f32 = StepControl_to_next_sample_0(_S642, _S646, _S647, _S648);
        end_1.previous_4 = after_sample_0(_S647, _S648, _S646, _S651 > _S652);
        var _S653 : f32 = max(_S651, _S652);
        end_1.last_step_3 = _S653;
        end_1.height_10 = end_1.height_10 - _S653;
        count_6 = count_6 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S654 : u32,  _S655 : ViewRay_0,  _S656 : StepControl_0,  _S657 : bool,  _S658 : ViewRayEnd_0,  _S659 : u32) -> f32
{
    var _S660 : f32 = fabrics_0[_S654].height_high_0 - fabrics_0[_S654].height_low_0;
    var above_2 : f32 = _S658.height_10 + _S658.last_step_3;
    var above_gap_1 : f32 = clamp(_S658.previous_4.clearance_0, 0.0f, _S660);
    var under_gap_1 : f32 = clamp(_S658.depth_2, 0.0f, _S660);
    var middle_0 : f32 = select(between_0(above_2, _S658.height_10, above_gap_1, under_gap_1), above_2 - cubic_root_0(above_gap_1, - under_gap_1, _S658.previous_4.rate_0 * _S658.last_step_3, _S658.rate_4 * _S658.last_step_3) * _S658.last_step_3, _S658.smooth_0);
    var side_3 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S658.height_10;
    var above_3 : f32 = above_2;
    var i_2 : u32 = u32(0);
    for(;;)
    {
        if(i_2 < _S659)
        {
        }
        else
        {
            break;
        }
        var _S661 : vec2<f32> = ViewRay_at_0(_S655, middle_0);
        var _S662 : Probe_0 = probe_0(_S654, _S661.x, _S661.y, _S657, _S656.right_1, _S656.up_1);
        var _S663 : f32 = clamp(middle_0 - select(_S662.height_5, -1.0e+09f, _S662.hole_4), - _S660, _S660);
        if(_S663 <= 0.0f)
        {
            var _S664 : f32 = select(above_gap_2, 0.5f * above_gap_2, side_3 > 0.0f);
            var _S665 : f32 = - _S663;
            under_1 = middle_0;
            above_gap_2 = _S664;
            under_gap_2 = _S665;
            side_3 = 1.0f;
        }
        else
        {
            var _S666 : f32 = select(under_gap_2, 0.5f * under_gap_2, side_3 < 0.0f);
            above_3 = middle_0;
            above_gap_2 = _S663;
            under_gap_2 = _S666;
            side_3 = -1.0f;
        }
        var _S667 : f32 = select(between_0(above_3, under_1, above_gap_2, under_gap_2), clamp(middle_0 + _S663 / min(ViewRay_rate_0(_S655, _S662), -9.99999997475242708e-07f), under_1, above_3), _S658.smooth_0);
        var _S668 : u32 = i_2 + u32(1);
        middle_0 = _S667;
        i_2 = _S668;
    }
    return select(under_1, middle_0, _S658.smooth_0);
}

fn first_hit_of_yarn_0( _S669 : u32,  _S670 : SearchQuality_0,  _S671 : f32,  _S672 : f32,  _S673 : vec3<f32>,  _S674 : bool) -> Hit_0
{
    var _S675 : f32 = max(_S673.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S671, _S672);
    var _S676 : vec2<f32> = _S673.xy / vec2<f32>(_S675);
    ray_0.slope_1 = _S676;
    var _S677 : StepControl_0 = step_control_0((vec2<f32>(0) - _S676), 1.0f / max(steps_per_length_0(_S669, _S670, _S673) / _S675, 9.99999971718068537e-10f));
    var _S678 : ViewRayEnd_0 = search_down_0(_S669, ray_0, _S677, _S674);
    var hit_0 : Hit_0;
    hit_0.hole_7 = false;
    var _S679 : f32 = refined_height_0(_S669, ray_0, _S677, _S674, _S678, _S670.refinements_0);
    hit_0.height_9 = _S679;
    var _S680 : vec2<f32> = ViewRay_at_0(ray_0, _S679);
    hit_0.x_21 = _S680.x;
    hit_0.y_14 = _S680.y;
    return hit_0;
}

fn first_hit_0( _S681 : u32,  _S682 : SearchQuality_0,  _S683 : f32,  _S684 : f32,  _S685 : vec3<f32>,  _S686 : bool) -> Hit_0
{
    if(!passes_through_0(_S681, _S682, _S683, _S684, _S685, _S686))
    {
        return first_hit_of_yarn_0(_S681, _S682, _S683, _S684, _S685, _S686);
    }
    var hit_1 : Hit_0;
    hit_1.x_21 = _S683;
    hit_1.y_14 = _S684;
    hit_1.height_9 = 0.0f;
    hit_1.hole_7 = true;
    return hit_1;
}

fn surface_of_0( _S687 : u32,  _S688 : Sample_0,  _S689 : f32,  _S690 : f32,  _S691 : bool) -> SurfacePoint_0
{
    var _S692 : u32 = select(fabrics_0[_S687].weft_0, fabrics_0[_S687].warp_0, _S688.shown_2.is_warp_2);
    var _S693 : f32 = families_0[_S692].twist_sine_0 * select(1.0f, -1.0f, _S691);
    var _S694 : f32 = families_0[_S692].twist_cosine_0;
    var _S695 : f32 = select(-1.0f, 1.0f, _S688.shown_2.is_warp_2);
    var _S696 : vec2<f32> = fibre_direction_0(_S688.slope_across_0, _S695 * _S688.slope_along_0, _S693, families_0[_S692].twist_cosine_0);
    var _S697 : f32 = _S696.x;
    var _S698 : f32 = _S696.y;
    var _S699 : f32 = select(_S688.slope_y_0, _S688.slope_x_0, _S688.shown_2.is_warp_2) * _S697 + _S695 * select(_S688.slope_x_0, _S688.slope_y_0, _S688.shown_2.is_warp_2) * _S698;
    var _S700 : f32 = select(_S688.crossing_3.weft_3.half_width_1, _S688.crossing_3.warp_3.half_width_1, _S688.shown_2.is_warp_2) * 1.0154266357421875f;
    var _S701 : f32 = _S700 * arc_sine_0(clamp(_S688.section_1.across_3 / _S700, -1.0f, 1.0f));
    var _S702 : f32 = select(_S688.here_0.plane_5.start_x_0 - _S689, _S690 - _S688.here_0.plane_5.start_y_0, _S688.shown_2.is_warp_2);
    var point_4 : SurfacePoint_0;
    point_4.hole_0 = _S688.shown_2.hole_3;
    point_4.is_warp_0 = _S688.shown_2.is_warp_2;
    point_4.warp_thread_0 = _S688.crossing_3.warp_3.thread_1;
    point_4.weft_thread_0 = _S688.crossing_3.weft_3.thread_1;
    if(is_layered_0(_S687))
    {
        point_4.warp_thread_0 = words_0[_S688.here_0.plane_5.end_numbers_0 + point_4.warp_thread_0];
        point_4.weft_thread_0 = words_0[_S688.here_0.plane_5.pick_numbers_0 + point_4.weft_thread_0];
    }
    point_4.height_2 = _S688.height_4;
    point_4.plane_0 = _S688.here_0.level_1;
    point_4.layer_0 = _S688.here_0.number_2;
    point_4.normal_1 = normalize(vec3<f32>(- _S688.slope_x_0, - _S688.slope_y_0, 1.0f));
    point_4.tangent_0 = normalize(select_vector_1(_S688.shown_2.is_warp_2, vec3<f32>(_S697, _S698, _S699), vec3<f32>(- _S698, _S697, _S699)));
    point_4.across_1 = _S688.section_1.across_3;
    point_4.fibre_across_0 = _S701 * _S694 + _S702 * _S693;
    point_4.fibre_along_0 = _S702 * _S694 - _S701 * _S693;
    var _S703 : f32 = run_share_0(_S688.shown_2.word_0);
    point_4.shown_share_0 = select(1.0f - _S703, _S703, _S688.shown_2.on_top_0);
    point_4.x_8 = _S689;
    point_4.y_2 = _S690;
    return point_4;
}

fn surface_met_0( _S704 : u32,  _S705 : f32,  _S706 : f32,  _S707 : f32,  _S708 : vec3<f32>,  _S709 : bool) -> SurfacePoint_0
{
    var _S710 : Sample_0 = sample_at_0(_S704, _S705, _S706, _S709);
    var point_5 : SurfacePoint_0 = surface_of_0(_S704, _S710, _S705, _S706, _S709);
    var _S711 : u32 = select(fabrics_0[_S704].weft_0, fabrics_0[_S704].warp_0, point_5.is_warp_0);
    var _S712 : f32 = select(_S710.crossing_3.weft_3.half_width_1, _S710.crossing_3.warp_3.half_width_1, point_5.is_warp_0) * 1.0154266357421875f;
    var _S713 : f32 = _S710.dive_1.z;
    var _S714 : f32 = _S710.slope_along_0 - (1.0f - _S713) * _S710.dive_1.y / families_0[_S711].height_scale_0;
    var _S715 : f32 = rsqrt_0(_S714 * _S714 + 1.0f);
    var _S716 : f32 = _S708.x;
    var _S717 : f32 = _S708.y;
    var _S718 : f32 = select(_S717, _S716, point_5.is_warp_0);
    var _S719 : f32 = _S708.z;
    var _S720 : f32 = (_S719 / families_0[_S711].height_scale_0 - _S714 * select(_S716, _S717, point_5.is_warp_0)) * _S715;
    var _S721 : f32 = square_1(_S712);
    var _S722 : f32 = sqrt(max(_S721 - square_1(point_5.across_1), 0.0f)) - (_S710.height_4 + _S713 * _S710.dive_1.x - _S707) / families_0[_S711].height_scale_0 * _S715;
    var _S723 : f32 = square_1(_S718) + square_1(_S720) + 9.999999960041972e-13f;
    var _S724 : f32 = point_5.across_1 * _S718 + _S722 * _S720;
    var _S725 : f32 = square_1(point_5.across_1) + square_1(_S722) - _S721;
    var _S726 : f32 = sqrt(max(square_1(_S724) - _S723 * _S725, 0.0f));
    var _S727 : f32 = clamp(select((_S726 - _S724) / _S723, - _S725 / max(_S724 + _S726, 9.999999960041972e-13f), _S724 > 0.0f), - _S712, _S712);
    var _S728 : f32 = point_5.across_1 + _S727 * _S718;
    point_5.across_1 = _S728;
    var _S729 : vec2<f32> = normalize(vec2<f32>(_S728, _S722 + _S727 * _S720));
    var _S730 : f32 = select(-1.0f, 1.0f, point_5.is_warp_0);
    var _S731 : f32 = families_0[_S711].twist_sine_0 * select(1.0f, -1.0f, _S709);
    var _S732 : f32 = _S729.x;
    var _S733 : f32 = _S731 * _S732 * _S715;
    var _S734 : f32 = _S729.y;
    var _S735 : f32 = - _S731 * _S734;
    var _S736 : f32 = families_0[_S711].twist_cosine_0 * _S715 - _S730 * _S714 * _S733;
    var _S737 : f32 = families_0[_S711].height_scale_0 * (families_0[_S711].twist_cosine_0 * _S730 * _S714 * _S715 + _S733);
    var _S738 : f32 = families_0[_S711].height_scale_0 * _S732;
    var _S739 : f32 = - families_0[_S711].height_scale_0 * _S714 * _S715 * _S734;
    point_5.normal_1 = normalize(vec3<f32>(select(_S739, _S738, point_5.is_warp_0), select(_S738, _S739, point_5.is_warp_0), _S715 * _S734));
    point_5.tangent_0 = normalize(vec3<f32>(select(- _S736, _S735, point_5.is_warp_0), select(_S735, _S736, point_5.is_warp_0), _S737));
    var _S740 : f32 = _S712 * angle_of_0(_S729);
    var _S741 : f32 = select(- _S705 - _S727 * _S716, _S706 + _S727 * _S717, point_5.is_warp_0);
    point_5.fibre_across_0 = _S740 * families_0[_S711].twist_cosine_0 + _S741 * _S731;
    point_5.fibre_along_0 = _S741 * families_0[_S711].twist_cosine_0 - _S740 * _S731;
    var _S742 : f32 = 0.00999999977648258f * _S712;
    var _S743 : f32 = - _S742;
    var _S744 : bool = _S727 < _S743;
    var _S745 : f32 = select(_S742, _S743, _S718 < 0.0f);
    var _S746 : f32 = max(_S727, 0.0f);
    point_5.x_8 = point_5.x_8 + select(_S746 * _S716, select(0.0f, _S745, point_5.is_warp_0), _S744);
    point_5.y_2 = point_5.y_2 + select(_S746 * _S717, select(_S745, 0.0f, point_5.is_warp_0), _S744);
    point_5.height_2 = select(_S707 + _S727 * _S719, _S707, _S744);
    return point_5;
}

fn hairs_over_0( _S747 : u32,  _S748 : SurfacePoint_0,  _S749 : bool,  _S750 : f32) -> Hairs_0
{
    var hairs_2 : Hairs_0;
    hairs_2.place_1 = vec2<f32>(_S748.x_8, _S748.y_2);
    hairs_2.below_1 = fabrics_0[_S747].height_high_0 - _S748.height_2;
    hairs_2.back_7 = _S749;
    hairs_2.size_3 = _S750;
    return hairs_2;
}

fn has_hairs_0( _S751 : u32) -> bool
{
    return (((families_0[fabrics_0[_S751].warp_0].hairiness_0) > 0.0f) | (((families_0[fabrics_0[_S751].weft_0].hairiness_0) > 0.0f)));
}

fn hair_towards_0( _S752 : u32,  _S753 : Hairs_0,  _S754 : vec3<f32>,  _S755 : f32) -> Hair_0
{
    var _S756 : f32 = fabrics_0[_S752].fibre_size_0;
    var _S757 : f32 = 17.0f * fabrics_0[_S752].fibre_size_0;
    var _S758 : f32 = fade_0(_S755, _S757);
    var _S759 : vec2<f32> = _S754.xy / vec2<f32>(max(_S754.z, 0.3333333432674408f));
    var _S760 : u32 = hash_key_0(select(u32(0), u32(1), _S753.back_7), ((fabrics_0[_S752].seed_0) ^ (u32(1013904242))));
    var _S761 : f32 = fabrics_0[_S752].fibre_size_0 / max(_S755, 0.07000000029802322f * fabrics_0[_S752].fibre_size_0);
    const _S762 : vec2<f32> = vec2<f32>(0.0f, 1.0f);
    var cover_3 : f32 = 0.0f;
    var hair_across_0 : vec2<f32> = _S762;
    var hair_away_0 : f32 = 0.0f;
    var is_warp_7 : bool = false;
    var number_7 : u32 = u32(0);
    for(;;)
    {
        if(((_S758 > 0.0f) & ((number_7 < u32(18)))))
        {
        }
        else
        {
            break;
        }
        var _S763 : u32 = number_7 / u32(9);
        var _S764 : u32 = number_7 / u32(3) - u32(3) * _S763;
        var _S765 : vec2<f32> = (vec2<f32>(((f32(_S763) * 6.0f + 2.0f) * _S756 + _S753.below_1)) * _S759 + _S753.place_1) / vec2<f32>(_S757);
        var _S766 : vec2<f32> = floor(_S765) + vec2<f32>(f32(number_7 - u32(3) * _S764 - u32(9) * _S763), f32(_S764)) - vec2<f32>(1.0f);
        var _S767 : u32 = hash_bits_0(_S760 + _S763, u32(i32(_S766.x)) * u32(65536) + u32(i32(_S766.y)));
        var _S768 : u32 = hash_bits_0(_S760, _S767);
        var _S769 : vec2<f32> = _S765 - _S766 - vec2<f32>(share_of_0(_S767), share_of_0((_S767 >> (u32(10)))));
        var _S770 : vec2<f32> = sine_cosine_0(3.14159274101257324f * share_of_0((_S767 >> (u32(20)))));
        var _S771 : f32 = mix(5.0f, 16.0f, share_of_0((_S768 >> (u32(10))))) / 17.0f;
        var _S772 : f32 = _S769.x;
        var _S773 : f32 = _S770.y;
        var _S774 : f32 = _S769.y;
        var _S775 : f32 = _S770.x;
        var _S776 : f32 = (_S772 * _S773 + _S774 * _S775) / _S771;
        var _S777 : f32 = 0.69999998807907104f * (2.0f * share_of_0((_S768 >> (u32(20)))) - 1.0f);
        var _S778 : f32 = 0.5f * (2.0f * share_of_0((_S767 ^ (_S768))) - 1.0f);
        var _S779 : f32 = _S776 * (3.0f * _S778 * _S776 + 2.0f * _S777);
        var _S780 : f32 = rsqrt_0(_S779 * _S779 + 1.0f);
        var _S781 : f32 = (_S774 * _S773 - _S772 * _S775 - _S771 * _S776 * _S776 * (_S778 * _S776 + _S777)) * _S780 * 17.0f;
        var _S782 : f32 = 0.2800000011920929f * max(1.0f - square_1(square_1(_S776)), 0.0f) * _S761;
        var _S783 : f32 = clamp(_S782 + 0.5f - abs(_S781) * _S761, 0.0f, min(2.0f * _S782, 1.0f));
        var _S784 : bool = ((((_S768 >> (u32(30)))) & (u32(1)))) == u32(1);
        var _S785 : bool = (((((share_of_0(_S768)) < (families_0[select(fabrics_0[_S752].weft_0, fabrics_0[_S752].warp_0, _S784)].hairiness_0)) & (((abs(_S776)) < 1.0f)))) & ((_S783 > cover_3)));
        var _S786 : vec2<f32> = vec2<f32>(- _S775 - _S779 * _S773, _S773 - _S779 * _S775) * vec2<f32>(_S780);
        var _S787 : f32 = select(cover_3, _S783, _S785);
        var _S788 : vec2<f32> = vec2<f32>(select(hair_across_0.x, _S786.x, _S785), select(hair_across_0.y, _S786.y, _S785));
        var _S789 : f32 = select(hair_away_0, _S781, _S785);
        var _S790 : bool = select(is_warp_7, _S784, _S785);
        var _S791 : u32 = number_7 + u32(1);
        cover_3 = _S787;
        hair_across_0 = _S788;
        hair_away_0 = _S789;
        is_warp_7 = _S790;
        number_7 = _S791;
    }
    var _S792 : f32 = clamp(hair_away_0 * 2.85714292526245117f, -0.80000001192092896f, 0.80000001192092896f);
    var hair_1 : Hair_0;
    hair_1.cover_1 = _S758 * cover_3;
    hair_1.normal_5 = vec3<f32>(vec2<f32>(_S792) * hair_across_0, sqrt(1.0f - _S792 * _S792));
    hair_1.tangent_4 = vec3<f32>(hair_across_0.y, - hair_across_0.x, 0.0f);
    hair_1.is_warp_5 = is_warp_7;
    hair_1.shade_0 = _S758 * 0.03255363181233406f * (families_0[fabrics_0[_S752].warp_0].hairiness_0 + families_0[fabrics_0[_S752].weft_0].hairiness_0);
    return hair_1;
}

fn thread_of_family_0( _S793 : u32,  _S794 : SurfacePoint_0) -> i32
{
    var _S795 : u32 = select(fabrics_0[_S793].weft_0, fabrics_0[_S793].warp_0, _S794.is_warp_0);
    return i32(floor((select(_S794.y_2, _S794.x_8, _S794.is_warp_0) - _S794.across_1) / families_0[_S795].period_0)) * i32(families_0[_S795].count_0) + i32(select(_S794.weft_thread_0, _S794.warp_thread_0, _S794.is_warp_0));
}

fn thread_number_0( _S796 : u32,  _S797 : SurfacePoint_0) -> u32
{
    return u32(thread_of_family_0(_S796, _S797)) * u32(2) + select(u32(0), u32(1), _S797.is_warp_0);
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

fn fibre_noise_at_0( _S798 : u32,  _S799 : u32,  _S800 : SurfacePoint_0,  _S801 : u32,  _S802 : f32) -> FibreNoise_0
{
    var _S803 : f32 = 5.0f * fabrics_0[_S798].fibre_size_0;
    var _S804 : vec2<f32> = wave_noise_0(hash_key_0(_S801, ((fabrics_0[_S798].seed_0) ^ (u32(458671337)))), _S800.fibre_along_0 / (25.0f * fabrics_0[_S798].fibre_size_0));
    var _S805 : f32 = _S800.fibre_across_0 + families_0[_S799].fibre_tilt_0 * 0.5f * 25.0f * fabrics_0[_S798].fibre_size_0 * _S804.x;
    var _S806 : vec3<f32> = fibre_cell_0(_S805, _S800.fibre_along_0, fabrics_0[_S798].fibre_size_0);
    var _S807 : vec3<f32> = fibre_cell_0(_S805, _S800.fibre_along_0, _S803);
    var noise_0 : FibreNoise_0;
    noise_0.bundle_0 = cell_noise_0(hash_key_0(_S801, ((fabrics_0[_S798].seed_0) ^ (u32(1757159915)))), _S807);
    noise_0.bundle_offset_0 = _S807.z;
    noise_0.bundle_weight_0 = fade_0(_S802, _S803);
    noise_0.fibre_0 = cell_noise_0(hash_key_0(_S801, ((fabrics_0[_S798].seed_0) ^ (u32(48610963)))), _S806);
    noise_0.fibre_weight_0 = fade_0(_S802, fabrics_0[_S798].fibre_size_0);
    noise_0.offset_2 = _S806.z;
    noise_0.slope_2 = 0.5f * _S804.y;
    return noise_0;
}

fn turned_frame_0( _S808 : u32,  _S809 : u32,  _S810 : SurfacePoint_0,  _S811 : bool,  _S812 : u32,  _S813 : f32) -> YarnFrame_0
{
    var frame_2 : YarnFrame_0;
    frame_2.normal_7 = _S810.normal_1;
    frame_2.tangent_6 = _S810.tangent_0;
    frame_2.loss_0 = 0.0f;
    frame_2.shade_2 = 0.0f;
    if((families_0[_S809].has_plies_0) > 0.0f)
    {
        var _S814 : f32 = fade_0(_S813, 1.0f / families_0[_S809].plies_per_mm_0);
        var _S815 : f32 = _S814 * 0.62000000476837158f * ply_offset_0(_S809, _S810, _S811);
        var _S816 : vec3<f32> = cross(frame_2.tangent_6, frame_2.normal_7);
        var _S817 : vec3<f32> = vec3<f32>(families_0[_S809].ply_cosine_0);
        var _S818 : vec3<f32> = vec3<f32>(select(families_0[_S809].ply_sine_0, - families_0[_S809].ply_sine_0, _S811));
        var _S819 : vec3<f32> = _S817 * _S816 + _S818 * frame_2.tangent_6;
        var _S820 : vec3<f32> = vec3<f32>(sqrt(1.0f - _S815 * _S815));
        var _S821 : vec3<f32> = vec3<f32>(_S815);
        frame_2.tangent_6 = _S817 * (_S817 * frame_2.tangent_6 - _S818 * _S816) + _S818 * (_S820 * _S819 - _S821 * frame_2.normal_7);
        frame_2.normal_7 = _S820 * frame_2.normal_7 + _S821 * _S819;
        frame_2.loss_0 = _S814 * _S814 * 0.62000000476837158f * 0.62000000476837158f / 3.0f;
    }
    var _S822 : f32 = families_0[_S809].fibre_tilt_0;
    if((families_0[_S809].fibre_tilt_0) > 0.0f)
    {
        var _S823 : FibreNoise_0 = fibre_noise_at_0(_S808, _S809, _S810, _S812, _S813);
        var _S824 : f32 = 1.09858846664428711f * _S822 * (_S823.bundle_weight_0 * _S823.bundle_0.x + _S823.fibre_weight_0 * (_S823.fibre_0.x + _S823.offset_2));
        var _S825 : f32 = _S822 * (1.42099642753601074f * (_S823.bundle_weight_0 * _S823.bundle_0.y + _S823.fibre_weight_0 * _S823.fibre_0.y) - _S823.bundle_weight_0 * _S823.slope_2);
        var _S826 : f32 = square_1(_S823.fibre_weight_0);
        frame_2.loss_0 = frame_2.loss_0 + 0.5f * _S822 * _S822 * ((0.24761904776096344f * (square_1(_S823.bundle_weight_0) + _S826) + _S826 / 3.0f) * 1.09858846664428711f * 1.09858846664428711f);
        var _S827 : vec3<f32> = cross(frame_2.tangent_6, frame_2.normal_7);
        var _S828 : vec2<f32> = sine_cosine_0(_S824);
        var _S829 : vec2<f32> = sine_cosine_0(_S825);
        var _S830 : vec3<f32> = vec3<f32>(_S828.y);
        var _S831 : vec3<f32> = vec3<f32>(_S828.x);
        var _S832 : vec3<f32> = _S830 * _S827 - _S831 * frame_2.normal_7;
        frame_2.normal_7 = _S830 * frame_2.normal_7 + _S831 * _S827;
        frame_2.tangent_6 = vec3<f32>(_S829.y) * frame_2.tangent_6 + vec3<f32>(_S829.x) * _S832;
    }
    return frame_2;
}

fn uncoloured_point_0( _S833 : u32,  _S834 : SurfacePoint_0,  _S835 : vec3<f32>,  _S836 : bool,  _S837 : bool,  _S838 : f32) -> YarnPoint_0
{
    var _S839 : u32 = fabrics_0[_S833].warp_0;
    var _S840 : u32 = fabrics_0[_S833].weft_0;
    var _S841 : u32 = select(fabrics_0[_S833].weft_0, fabrics_0[_S833].warp_0, _S834.is_warp_0);
    var _S842 : bool = (((fabrics_0[_S833].has_detail_0) != u32(0)) & ((_S838 >= 0.0f)));
    var _S843 : vec3<f32> = vec3<f32>(0.0f);
    var _S844 : vec2<f32> = vec2<f32>(0.0f);
    var point_6 : YarnPoint_0 = YarnPoint_x24init_0(false, false, false, 0.0f, 0.0f, 0.0f, _S843, _S843, _S843, 0.0f, 0.0f, Albedos_x24init_0(_S843, _S843, _S843, _S843), Hairs_x24init_0(_S844, 0.0f, false, 0.0f), 0.0f, _S844, 0.0f);
    point_6.hairs_0 = hairs_over_0(_S833, _S834, _S836, _S838);
    point_6.hair_cover_0 = 1.0f;
    var _S845 : Hair_0 = Hair_x24init_0(0.0f, _S843, _S843, false, 0.0f);
    point_6.is_warp_3 = _S834.is_warp_0;
    var _S846 : bool = (_S842 & ((has_hairs_0(_S833))));
    var hair_2 : Hair_0;
    if(_S846)
    {
        var _S847 : Hair_0 = hair_towards_0(_S833, point_6.hairs_0, _S835, _S838);
        point_6.hair_cover_0 = _S847.cover_1;
        point_6.is_warp_3 = select(_S834.is_warp_0, _S847.is_warp_5, (_S847.cover_1) > 0.5f);
        hair_2 = _S847;
    }
    else
    {
        hair_2 = _S845;
    }
    var _S848 : u32 = select(_S840, _S839, point_6.is_warp_3);
    point_6.back_9 = _S836;
    point_6.hole_5 = _S837;
    point_6.x_14 = _S834.x_8;
    point_6.y_7 = _S834.y_2;
    point_6.place_3 = vec2<f32>(_S834.x_8, _S834.y_2);
    point_6.plane_6 = _S834.plane_0;
    point_6.height_7 = _S834.height_2 + hair_2.cover_1 * point_6.hairs_0.below_1;
    point_6.normal_3 = _S834.normal_1;
    point_6.tangent_2 = _S834.tangent_0;
    point_6.surface_normal_0 = normalize(mix(_S834.normal_1, vec3<f32>(0.0f, 0.0f, 1.0f), vec3<f32>(hair_2.cover_1)));
    point_6.diffuse_gain_0 = 1.0f;
    if(_S842)
    {
        var _S849 : YarnFrame_0 = turned_frame_0(_S833, _S841, _S834, _S836, thread_number_0(_S833, _S834), _S838);
        var frame_3 : YarnFrame_0;
        if(_S846)
        {
            frame_3 = under_hair_0(_S849, hair_2);
        }
        else
        {
            frame_3 = _S849;
        }
        point_6.normal_3 = frame_3.normal_7;
        point_6.tangent_2 = frame_3.tangent_6;
        point_6.diffuse_gain_0 = diffuse_gain_2(frame_3, fabrics_0[_S833].diffuse_blend_0);
    }
    point_6.roughness_1 = families_0[_S848].roughness_0;
    return point_6;
}

fn surface_at_0( _S850 : u32,  _S851 : f32,  _S852 : f32,  _S853 : bool) -> SurfacePoint_0
{
    return surface_of_0(_S850, sample_at_0(_S850, _S851, _S852, _S853), _S851, _S852, _S853);
}

fn unoccluded_0( _S854 : u32,  _S855 : SearchQuality_0,  _S856 : f32,  _S857 : f32,  _S858 : f32,  _S859 : vec3<f32>,  _S860 : bool) -> bool
{
    if((_S859.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S854, _S855, vec3<f32>(_S856, _S857, _S858 + fabrics_0[_S854].lift_0), _S859, _S860, max_height_along_0(_S854, _S856, _S857, _S858, _S859, _S860));
}

fn is_lit_0( _S861 : u32,  _S862 : SearchQuality_0,  _S863 : YarnPoint_0,  _S864 : vec3<f32>) -> bool
{
    if(_S863.hole_5)
    {
        return true;
    }
    var _S865 : vec3<f32> = to_face_frame_0(_S864, _S863.back_9);
    var _S866 : f32 = _S865.z;
    var _S867 : bool = _S866 < 0.0f;
    var normal_12 : vec3<f32>;
    var height_13 : f32;
    if(_S867)
    {
        var _S868 : SurfacePoint_0 = surface_at_0(_S861, _S863.x_14, _S863.y_7, !_S863.back_9);
        normal_12 = _S868.normal_1;
        height_13 = _S868.height_2;
    }
    else
    {
        normal_12 = _S863.surface_normal_0;
        height_13 = _S863.height_7;
    }
    var _S869 : vec3<f32> = vec3<f32>(_S865.xy, abs(_S866));
    if((dot(normal_12, _S869)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S861, _S862, _S863.x_14, _S863.y_7, height_13, _S869, (_S863.back_9) != _S867);
}

fn hairs_lit_0( _S870 : u32,  _S871 : Hairs_0,  _S872 : vec3<f32>) -> f32
{
    return 1.0f - 0.5f * hair_towards_0(_S870, _S871, _S872, _S871.size_3 + fabrics_0[_S870].fibre_size_0).cover_1;
}

fn under_hairs_0( _S873 : u32,  _S874 : YarnPoint_0,  _S875 : vec3<f32>) -> f32
{
    if((((_S874.hair_cover_0) >= 1.0f) | (((_S875.z) <= 0.0f))))
    {
        return 1.0f;
    }
    return mix(hairs_lit_0(_S873, _S874.hairs_0, _S875), 1.0f, _S874.hair_cover_0);
}

fn components_of_point_0( _S876 : u32,  _S877 : SearchQuality_0,  _S878 : YarnPoint_0,  _S879 : vec3<f32>,  _S880 : vec3<f32>) -> Components_0
{
    var result_6 : Components_0 = no_components_0();
    result_6.hole_2 = select(0.0f, 1.0f, _S878.hole_5);
    var _S881 : bool;
    if(_S878.hole_5)
    {
        _S881 = true;
    }
    else
    {
        _S881 = !is_lit_0(_S876, _S877, _S878, _S879);
    }
    if(_S881)
    {
        return result_6;
    }
    var _S882 : vec3<f32> = to_face_frame_0(_S879, _S878.back_9);
    var _S883 : vec3<f32> = to_face_frame_0(_S880, _S878.back_9);
    var _S884 : bool = (_S882.z) < 0.0f;
    var _S885 : f32 = under_hairs_0(_S876, _S878, _S882);
    var _S886 : f32 = _S885 * _S878.diffuse_gain_0 * diffuse_reflection_0(select_vector_1(_S884, (vec3<f32>(0) - _S882), _S882), _S878.normal_3, fabrics_0[_S876].diffuse_blend_0);
    var _S887 : f32;
    if(_S884)
    {
        _S887 = transmission_1(_S882, _S883, _S878.normal_3, _S878.tangent_2, _S878.roughness_1, fabrics_0[_S876].optical_depth_0);
    }
    else
    {
        _S887 = reflection_0(_S882, _S883, _S878.normal_3, _S878.tangent_2, _S878.roughness_1, fabrics_0[_S876].optical_depth_0);
    }
    var _S888 : f32 = _S885 * _S887;
    result_6.diffuse_warp_0 = select(0.0f, _S886, _S878.is_warp_3);
    result_6.diffuse_weft_0 = select(_S886, 0.0f, _S878.is_warp_3);
    result_6.specular_warp_0 = select(0.0f, _S888, _S878.is_warp_3);
    result_6.specular_weft_0 = select(_S888, 0.0f, _S878.is_warp_3);
    result_6.light_visibility_1 = 1.0f;
    return result_6;
}

fn openness_number_0( _S889 : u32,  _S890 : u32) -> f32
{
    return table_number_0(fabrics_0[_S889].openness_0 + _S890);
}

fn blocked_of_terms_0( _S891 : u32,  _S892 : u32,  _S893 : array<f32, i32(6)>,  _S894 : u32) -> Blocked_0
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
            if(term_2 < _S894)
            {
            }
            else
            {
                break;
            }
            shares_2[share_5] = shares_2[share_5] + openness_number_0(_S891, _S892 + share_5 * _S894 + term_2) * _S893[term_2];
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

fn blocked_at_0( _S895 : u32,  _S896 : bool,  _S897 : bool,  _S898 : f32,  _S899 : f32) -> Blocked_0
{
    var _S900 : f32 = _S899 * openness_number_0(_S895, u32(158));
    var terms_5 : array<f32, i32(6)> = array<f32, i32(6)>( 1.0f, _S898, _S900, _S898 * _S898, _S898 * _S900, _S900 * _S900 );
    return blocked_of_terms_0(_S895, u32(60) + (select(u32(0), u32(2), _S897) + select(u32(1), u32(0), _S896)) * u32(18), terms_5, u32(6));
}

fn with_blocked_0( _S901 : u32,  _S902 : Blocked_0,  _S903 : YarnPoint_0,  _S904 : bool,  _S905 : f32) -> Blocked_0
{
    if(((_S903.hole_5) | (((_S903.is_warp_3) != _S904))))
    {
        return _S902;
    }
    var _S906 : Blocked_0 = blocked_at_0(_S901, _S904, _S903.back_9, _S903.surface_normal_0.z, _S903.height_7 - _S903.plane_6);
    var result_7 : Blocked_0;
    result_7.by_warp_0 = _S902.by_warp_0 + _S905 * _S906.by_warp_0;
    result_7.by_weft_0 = _S902.by_weft_0 + _S905 * _S906.by_weft_0;
    result_7.far_0 = _S902.far_0 + _S905 * _S906.far_0;
    return result_7;
}

struct CoverageTaps_0
{
     nodes_1 : array<u32, i32(9)>,
};

fn pyramid_level_0( _S907 : u32,  _S908 : f32) -> vec3<f32>
{
    var _S909 : u32 = fabrics_0[_S907].lobes_0.levels_0 + u32(4) * u32(min(_S908, fabrics_0[_S907].lobes_0.last_level_0));
    return vec3<f32>(table_number_0(_S909), table_number_0(_S909 + u32(1)), table_number_0(_S909 + u32(2)));
}

fn coverage_taps_0( _S910 : u32,  _S911 : Footprint_0,  _S912 : bool) -> CoverageTaps_0
{
    var _S913 : Lobes_std430_0 = fabrics_0[_S910].lobes_0;
    var _S914 : f32 = Footprint_spread_side_0(_S911) * fabrics_0[_S910].lobes_0.inverse_base_size_0;
    var _S915 : vec3<f32> = pyramid_level_0(_S910, floor(binary_logarithm_0(max(0.68000000715255737f * _S914, 1.0f))));
    var _S916 : f32 = 1.0f / max(_S914, 9.99999997475242708e-07f);
    var _S917 : vec2<f32> = vec2<f32>(families_0[fabrics_0[_S910].warp_0].inverse_period_0, families_0[fabrics_0[_S910].weft_0].inverse_period_0);
    var _S918 : vec2<f32> = _S911.centre_0 * _S917;
    var _S919 : vec2<f32> = vec2<f32>(min(max(sqrt(clamp(1.29999995231628418f * (1.0f - _S916 * _S916), 0.0f, 1.0f)), 0.3333333432674408f * _S916), 1.0f));
    var _S920 : vec2<f32> = _S911.dx_0 * _S917 * _S919;
    var _S921 : vec2<f32> = _S911.dy_0 * _S917 * _S919;
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
        var _S922 : vec2<f32> = _S918 + vec2<f32>(TAP_OFFSETS_0[number_8].x) * _S920 + vec2<f32>(TAP_OFFSETS_0[number_8].y) * _S921;
        var _S923 : f32 = _S915.y;
        taps_4.nodes_1[number_8] = select(u32(0), _S913.face_nodes_0, _S912) + u32(wrapped_cell_0(_S922.y, _S915.z) * _S923 + wrapped_cell_0(_S922.x, _S923) + _S915.x);
        number_8 = number_8 + u32(1);
    }
    return taps_4;
}

fn joint_ratios_0( _S924 : u32,  _S925 : vec3<f32>,  _S926 : vec3<f32>,  _S927 : bool) -> vec2<f32>
{
    var _S928 : NodeTaps_0 = node_taps_of_0(_S926, u32(16));
    var _S929 : NodeTaps_0 = node_taps_of_0(_S925, u32(16));
    var _S930 : u32 = fabrics_0[_S924].lobes_0.joint_0 + u32(2) * (select(u32(0), u32(2), _S927) + select(u32(0), u32(1), (_S925.z) < 0.0f)) * u32(512);
    var _S931 : u32 = _S930 + u32(512);
    return clamp(vec2<f32>(1.0f) + vec2<f32>(dot(joint_terms_0(_S928, _S930, u32(0)), joint_terms_0(_S929, _S931, u32(0))), dot(joint_terms_0(_S928, _S930, u32(1)), joint_terms_0(_S929, _S931, u32(1)))), vec2<f32>(0.0f), vec2<f32>(4.0f));
}

fn coverage_of_pack_0( _S932 : u32,  _S933 : CoverageTaps_0,  _S934 : u32) -> vec4<f32>
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
        var _S935 : u32 = words_0[fabrics_0[_S932].lobes_0.coverage_0 + _S933.nodes_1[number_9] * fabrics_0[_S932].lobes_0.packs_0 + _S934];
        var even_2 : u32 = even_1 + ((_S935 & (u32(16711935))));
        var odd_2 : u32 = odd_1 + ((((_S935 >> (u32(8)))) & (u32(16711935))));
        number_9 = number_9 + u32(1);
        even_1 = even_2;
        odd_1 = odd_2;
    }
    return bytes_of_sums_0(even_1, odd_1) / vec4<f32>(9.0f);
}

fn coverage_of_holes_0( _S936 : u32,  _S937 : CoverageTaps_0) -> f32
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
        var total_5 : u32 = total_4 + ((((words_0[fabrics_0[_S936].lobes_0.coverage_holes_0 + _S937.nodes_1[number_10] / u32(4)] >> ((u32(8) * (_S937.nodes_1[number_10] % u32(4)))))) & (u32(255))));
        number_10 = number_10 + u32(1);
        total_4 = total_5;
    }
    return f32(total_4) / 9.0f;
}

fn prefiltered_hole_0( _S938 : u32,  _S939 : CoverageTaps_0,  _S940 : NodeTaps_0,  _S941 : bool) -> f32
{
    var _S942 : f32 = interpolate_table_0(_S940, fabrics_0[_S938].lobes_0.projected_area_0 + fabrics_0[_S938].lobes_0.packs_0, fabrics_0[_S938].lobes_0.packs_0 + u32(1)).x;
    return min(coverage_of_holes_0(_S938, _S939) * _S942 * _S942 * select(fabrics_0[_S938].lobes_0.front_hole_weight_0, fabrics_0[_S938].lobes_0.back_hole_weight_0, _S941), 1.0f);
}

fn prefiltered_components_0( _S943 : u32,  _S944 : Footprint_0,  _S945 : vec3<f32>,  _S946 : vec3<f32>,  _S947 : bool) -> Components_0
{
    var _S948 : CoverageTaps_0 = coverage_taps_0(_S943, _S944, _S947);
    var _S949 : NodeTaps_0 = node_taps_0(_S946);
    var view_nodes_0 : NodeTaps_0 = _S949;
    var _S950 : NodeTaps_0 = node_taps_0(_S945);
    var light_nodes_0 : NodeTaps_0 = _S950;
    var _S951 : u32 = select(u32(0), u32(1), _S947);
    view_nodes_0.nodes_0 = view_nodes_0.nodes_0 + vec4<u32>((_S951 * u32(256)));
    light_nodes_0.nodes_0 = light_nodes_0.nodes_0 + vec4<u32>(((u32(2) * _S951 + select(u32(0), u32(1), (_S945.z) < 0.0f)) * u32(256)));
    var _S952 : vec3<f32> = half_vector_0(_S945, _S946);
    var _S953 : vec2<f32> = joint_ratios_0(_S943, _S945, _S946, _S947);
    var _S954 : Lobes_std430_0 = fabrics_0[_S943].lobes_0;
    var _S955 : u32 = select(fabrics_0[_S943].lobes_0.front_warp_packs_0, fabrics_0[_S943].lobes_0.back_warp_packs_0, _S947);
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
        if(pack_0 < (_S954.packs_0))
        {
        }
        else
        {
            break;
        }
        var _S956 : vec4<f32> = coverage_of_pack_0(_S943, _S948, pack_0);
        var _S957 : vec4<f32> = interpolate_table_0(view_nodes_0, _S954.projected_area_0 + pack_0, _S954.packs_0 + u32(1));
        var _S958 : vec4<f32> = interpolate_table_0(light_nodes_0, _S954.light_visibility_0 + pack_0, _S954.packs_0) / vec4<f32>(255.0f);
        var _S959 : vec4<f32> = interpolate_table_0(light_nodes_0, _S954.irradiance_0 + pack_0, _S954.packs_0) * vec4<f32>(0.00124827399849892f);
        var _S960 : bool = pack_0 < _S955;
        var _S961 : f32 = families_0[select(fabrics_0[_S943].weft_0, fabrics_0[_S943].warp_0, _S960)].roughness_0;
        var number_11 : u32 = u32(0);
        var diffuse_0 : f32 = 0.0f;
        var specular_0 : f32 = 0.0f;
        var lit_4 : f32 = 0.0f;
        for(;;)
        {
            if(number_11 < u32(4))
            {
            }
            else
            {
                break;
            }
            var _S962 : Group_0 = group_at_0(_S954.moments_0 + u32(12) * (u32(4) * (_S951 * _S954.packs_0 + pack_0) + number_11), _S961);
            var _S963 : f32 = _S956[number_11] * _S957[number_11] * _S957[number_11] * _S962.weight_2;
            var diffuse_1 : f32 = diffuse_0 + _S963 * _S959[number_11];
            var specular_1 : f32 = specular_0 + _S963 * layer_value_0(_S962, _S952, _S945, _S946, fabrics_0[_S943].optical_depth_0) * _S958[number_11];
            var lit_5 : f32 = lit_4 + _S963 * _S958[number_11];
            var total_7 : f32 = total_6 + _S963;
            number_11 = number_11 + u32(1);
            diffuse_0 = diffuse_1;
            specular_0 = specular_1;
            lit_4 = lit_5;
            total_6 = total_7;
        }
        sums_9.diffuse_warp_0 = sums_9.diffuse_warp_0 + select(0.0f, diffuse_0, _S960);
        sums_9.diffuse_weft_0 = sums_9.diffuse_weft_0 + select(diffuse_0, 0.0f, _S960);
        sums_9.specular_warp_0 = sums_9.specular_warp_0 + select(0.0f, specular_0, _S960);
        sums_9.specular_weft_0 = sums_9.specular_weft_0 + select(specular_0, 0.0f, _S960);
        sums_9.light_visibility_1 = sums_9.light_visibility_1 + lit_4 * select(_S953.y, _S953.x, _S960);
        pack_0 = pack_0 + u32(1);
    }
    var _S964 : f32 = prefiltered_hole_0(_S943, _S948, view_nodes_0, _S947);
    sums_9.hole_2 = _S964;
    var _S965 : f32 = 1.0f - _S964;
    var _S966 : f32 = _S965 / max(total_6, 9.999999960041972e-13f);
    var _S967 : f32 = _S966 * _S953.x;
    sums_9.diffuse_warp_0 = sums_9.diffuse_warp_0 * _S967;
    var _S968 : f32 = _S966 * _S953.y;
    sums_9.diffuse_weft_0 = sums_9.diffuse_weft_0 * _S968;
    sums_9.specular_warp_0 = sums_9.specular_warp_0 * _S967;
    sums_9.specular_weft_0 = sums_9.specular_weft_0 * _S968;
    sums_9.light_visibility_1 = min(sums_9.light_visibility_1 * _S966, _S965);
    return sums_9;
}

fn yarns_over_0( _S969 : u32,  _S970 : Footprint_0,  _S971 : bool) -> Yarns_0
{
    var _S972 : vec2<f32> = _S970.dx_0;
    var _S973 : vec2<f32> = _S970.dy_0;
    var _S974 : vec2<f32> = sqrt(_S972 * _S972 + _S973 * _S973);
    var _S975 : f32 = Footprint_spread_side_0(_S970);
    var _S976 : vec4<f32> = vec4<f32>(0.0f);
    var yarns_0 : Yarns_0 = Yarns_x24init_0(_S976, _S976, vec3<f32>(0.0f));
    var _S977 : bool = (fabrics_0[_S969].is_irregular_0) != u32(0);
    var number_12 : u32 = u32(0);
    for(;;)
    {
        if(number_12 < select(u32(0), u32(2), _S977))
        {
        }
        else
        {
            break;
        }
        var _S978 : bool = number_12 == u32(0);
        var _S979 : u32 = select(fabrics_0[_S969].weft_0, fabrics_0[_S969].warp_0, _S978);
        var _S980 : vec2<f32> = select_vector_0(_S978, _S970.centre_0, _S970.centre_0.yx);
        var _S981 : vec2<f32> = select_vector_0(_S978, _S974, _S974.yx);
        var _S982 : f32 = _S980.x;
        var _S983 : Cell_0 = locate_0(_S979, _S982);
        var yarn_3 : vec4<f32> = irregular_over_0(_S979, irregular_key_0(_S969, number_12), irregular_thread_0(_S979, _S982, _S983) + _S983.below_0 / (_S983.below_0 + _S983.above_0), _S981.x * (families_0[_S979].count_0 / families_0[_S979].period_0), _S980.y, _S981.y);
        yarn_3[i32(1)] = yarn_3[i32(1)] * (1.0f - moved_share_0(_S979, _S975));
        yarns_0.warp_4 = yarns_0.weft_4;
        yarns_0.weft_4 = yarn_3;
        number_12 = number_12 + u32(1);
    }
    var _S984 : vec2<f32> = vec2<f32>(families_0[fabrics_0[_S969].warp_0].cover_0, families_0[fabrics_0[_S969].weft_0].cover_0);
    var _S985 : f32 = select(fabrics_0[_S969].warp_on_top_0, 1.0f - fabrics_0[_S969].warp_on_top_0, _S971);
    var _S986 : vec3<f32> = shown_of_covers_0(_S984, _S985);
    var _S987 : vec3<f32> = select_vector_1(_S977, shown_of_covers_0(saturate(_S984 + _S984 * vec2<f32>(yarns_0.warp_4.y, yarns_0.weft_4.y)), _S985) / max(_S986, vec3<f32>(0.00009999999747379f)), vec3<f32>(1.0f));
    yarns_0.shares_0 = _S987;
    yarns_0.shares_0[i32(2)] = select(1.0f, _S987.z, (_S986.z) > 0.00009999999747379f);
    return yarns_0;
}

fn with_shares_0( _S988 : u32,  _S989 : Components_0,  _S990 : Yarns_0) -> Components_0
{
    var result_8 : Components_0;
    var _S991 : f32 = min(_S989.hole_2 * _S990.shares_0.z, 1.0f);
    result_8.hole_2 = _S991;
    var _S992 : f32 = _S990.shares_0.x;
    result_8.diffuse_warp_0 = _S989.diffuse_warp_0 * _S992;
    var _S993 : f32 = _S990.shares_0.y;
    result_8.diffuse_weft_0 = _S989.diffuse_weft_0 * _S993;
    result_8.specular_warp_0 = _S989.specular_warp_0 * _S992;
    result_8.specular_weft_0 = _S989.specular_weft_0 * _S993;
    result_8.light_visibility_1 = _S989.light_visibility_1 * select(1.0f, (1.0f - _S991) / max(1.0f - _S989.hole_2, 9.99999997475242708e-07f), (fabrics_0[_S988].is_irregular_0) != u32(0));
    return result_8;
}

struct NearestLayer_0
{
     number_13 : u32,
     weight_9 : f32,
};

fn stack_share_0( _S994 : u32,  _S995 : vec2<f32>,  _S996 : vec2<f32>,  _S997 : u32) -> f32
{
    if((fabrics_0[_S994].stacks_0) == u32(1))
    {
        return 1.0f;
    }
    var _S998 : u32 = fabrics_0[_S994].plane_axes_0 + u32(1);
    var _S999 : Stretch_0 = stretch_of_0(fabrics_0[_S994].plane_axes_0, _S995.x, _S996.x);
    var _S1000 : Stretch_0 = stretch_of_0(_S998, _S995.y, _S996.y);
    return clamp(integral_on_top_0(fabrics_0[_S994].plane_axes_0, _S999, _S1000, u32(families_0[_S998].count_0), _S997) / (lengths_0(fabrics_0[_S994].plane_axes_0, _S999).x * lengths_0(_S998, _S1000).x), 0.0f, 1.0f);
}

fn layered_albedos_0( _S1001 : u32,  _S1002 : Footprint_0,  _S1003 : NearestLayer_0,  _S1004 : bool,  _S1005 : vec3<f32>,  _S1006 : vec3<f32>) -> LayeredAlbedos_0
{
    var _S1007 : vec2<f32> = _S1002.dx_0;
    var _S1008 : vec2<f32> = _S1002.dy_0;
    var _S1009 : vec2<f32> = sqrt(_S1007 * _S1007 + _S1008 * _S1008);
    var _S1010 : vec3<f32> = vec3<f32>(0.0f);
    var _S1011 : Albedos_0 = Albedos_x24init_0(_S1010, _S1010, _S1010, _S1010);
    var _S1012 : FamilyAlbedos_0 = FamilyAlbedos_x24init_0(_S1011, _S1011);
    var _S1013 : LayersBehind_0 = LayersBehind_x24init_0(_S1010, _S1010);
    var found_1 : LayeredAlbedos_0 = LayeredAlbedos_x24init_0(_S1012, _S1012, _S1013);
    var _S1014 : LayerSums_0 = LayerSums_x24init_0(_S1011, _S1011, 0.0f, 0.0f, 0.0f, _S1013);
    var warp_10 : LayerSums_0 = _S1014;
    var weft_10 : LayerSums_0 = _S1014;
    var number_14 : u32 = u32(0);
    for(;;)
    {
        if(number_14 < (plane_count_0(_S1001)))
        {
        }
        else
        {
            break;
        }
        var _S1015 : FamilyAlbedos_0 = albedos_in_0(plane_of_0(_S1001, number_14), _S1002.centre_0, _S1009, _S1004);
        if(!is_layered_0(_S1001))
        {
            found_1.albedos_2 = _S1015;
            found_1.means_0 = _S1015;
            return found_1;
        }
        var _S1016 : f32 = select(1.0f - _S1003.weight_9, 1.0f, number_14 == (_S1003.number_13));
        var stack_0 : u32 = u32(0);
        for(;;)
        {
            if(stack_0 < (fabrics_0[_S1001].stacks_0))
            {
            }
            else
            {
                break;
            }
            var _S1017 : f32 = stack_share_0(_S1001, _S1002.centre_0, _S1009, stack_0);
            var _S1018 : u32 = fabrics_0[_S1001].plane_shares_0 + u32(144) * (u32(2) * (stack_0 * fabrics_0[_S1001].planes_0 + number_14) + select(u32(0), u32(1), _S1004));
            var _S1019 : LayerSums_0 = with_seen_0(warp_10, _S1015.warp_6, families_0[fabrics_0[_S1001].warp_0].layer_through_0, _S1018, _S1017, _S1016, _S1005, _S1006);
            var _S1020 : LayerSums_0 = with_seen_0(weft_10, _S1015.weft_6, families_0[fabrics_0[_S1001].weft_0].layer_through_0, _S1018 + u32(72), _S1017, _S1016, _S1005, _S1006);
            var _S1021 : u32 = stack_0 + u32(1);
            warp_10 = _S1019;
            weft_10 = _S1020;
            stack_0 = _S1021;
        }
        number_14 = number_14 + u32(1);
    }
    var _S1022 : f32 = warp_10.weight_3;
    found_1.albedos_2.warp_6 = divided_0(warp_10.albedos_4, _S1022, _S1022);
    var _S1023 : f32 = weft_10.weight_3;
    found_1.albedos_2.weft_6 = divided_0(weft_10.albedos_4, _S1023, _S1023);
    found_1.means_0.warp_6 = divided_0(warp_10.means_2, warp_10.lit_0, warp_10.passed_0);
    found_1.means_0.weft_6 = divided_0(weft_10.means_2, weft_10.lit_0, weft_10.passed_0);
    found_1.behind_0.reflected_0 = warp_10.behind_2.reflected_0 + weft_10.behind_2.reflected_0;
    found_1.behind_0.transmitted_0 = warp_10.behind_2.transmitted_0 + weft_10.behind_2.transmitted_0;
    return found_1;
}

fn toned_0( _S1024 : u32,  _S1025 : u32,  _S1026 : Albedos_0,  _S1027 : vec4<f32>) -> Albedos_0
{
    var _S1028 : vec3<f32> = _S1026.diffuse_reflect_0 + _S1026.diffuse_transmit_0;
    var _S1029 : vec3<f32> = vec3<f32>(1.0f);
    var _S1030 : vec3<f32> = _S1029 - vec3<f32>(fabrics_0[_S1024].layer_bound_0) * max(_S1026.specular_reflect_0, _S1026.specular_transmit_0);
    var _S1031 : vec3<f32> = vec3<f32>(0.0f);
    var _S1032 : vec3<f32> = max(_S1029 - _S1028, _S1031) / (_S1029 + _S1028);
    var _S1033 : vec3<f32> = vec3<f32>(9.99999997475242708e-07f);
    var _S1034 : vec3<f32> = (_S1030 / max(_S1028, _S1033) - _S1029) / max(vec3<f32>(0.89999997615814209f) * _S1032, _S1033);
    var _S1035 : vec3<f32> = _S1029 - vec3<f32>((saturate(min(min(_S1034.x, _S1034.y), _S1034.z)) * _S1027.z)) * _S1032;
    var _S1036 : vec3<f32> = min(vec3<f32>(families_0[_S1025].nep_red_0, families_0[_S1025].nep_green_0, families_0[_S1025].nep_blue_0), _S1030);
    var found_2 : Albedos_0 = _S1026;
    var _S1037 : f32 = _S1027.w;
    var _S1038 : vec3<f32> = _S1035 * _S1026.diffuse_transmit_0 * vec3<f32>((1.0f - _S1037));
    found_2.diffuse_transmit_0 = _S1038;
    found_2.diffuse_reflect_0 = clamp(mix(_S1035 * _S1026.diffuse_reflect_0, _S1036, vec3<f32>(_S1037)), _S1031, max(_S1030 - _S1038, _S1031));
    return found_2;
}

fn with_tones_0( _S1039 : u32,  _S1040 : FamilyAlbedos_0,  _S1041 : Yarns_0) -> FamilyAlbedos_0
{
    if((fabrics_0[_S1039].is_irregular_0) == u32(0))
    {
        return _S1040;
    }
    var result_9 : FamilyAlbedos_0;
    result_9.warp_6 = toned_0(_S1039, fabrics_0[_S1039].warp_0, _S1040.warp_6, _S1041.warp_4);
    result_9.weft_6 = toned_0(_S1039, fabrics_0[_S1039].weft_0, _S1040.weft_6, _S1041.weft_4);
    return result_9;
}

fn detail_gain_0( _S1042 : u32,  _S1043 : u32,  _S1044 : SurfacePoint_0,  _S1045 : bool,  _S1046 : u32,  _S1047 : f32) -> vec2<f32>
{
    var _S1048 : vec2<f32> = vec2<f32>(0.0f);
    var gain_2 : vec2<f32>;
    if((families_0[_S1043].has_plies_0) > 0.0f)
    {
        gain_2 = groove_0(0.94999998807907104f * fade_0(_S1047, 1.0f / families_0[_S1043].plies_per_mm_0), ply_offset_0(_S1043, _S1044, _S1045));
    }
    else
    {
        gain_2 = _S1048;
    }
    if((families_0[_S1043].fibre_tone_0) > 0.0f)
    {
        var _S1049 : FibreNoise_0 = fibre_noise_at_0(_S1042, _S1043, _S1044, _S1046, _S1047);
        var _S1050 : f32 = 4.5f * families_0[_S1043].fibre_tone_0;
        gain_2 = gain_2 + vec2<f32>(families_0[_S1043].fibre_tone_0) * vec2<f32>(_S1049.bundle_weight_0 * _S1049.bundle_0.y + _S1049.fibre_weight_0 * _S1049.fibre_0.y, _S1049.bundle_weight_0 + _S1049.fibre_weight_0) + (groove_0(_S1050 * (_S1049.bundle_weight_0 * (0.5f * (_S1049.bundle_0.x - 1.0f) + 1.0f)), _S1049.bundle_offset_0) + groove_0(_S1050 * _S1049.fibre_weight_0, _S1049.offset_2));
    }
    if((families_0[_S1043].slub_0) > 0.0f)
    {
        gain_2 = gain_2 + vec2<f32>((0.15000000596046448f * families_0[_S1043].slub_0 * fade_0(_S1047, 1.0f / families_0[_S1043].slubs_per_mm_0))) * vec2<f32>(wave_noise_0(hash_key_0(_S1046, ((fabrics_0[_S1042].seed_0) ^ (u32(1373058189)))), select(- _S1044.x_8, _S1044.y_2, _S1044.is_warp_0) * families_0[_S1043].slubs_per_mm_0).x, 1.0f);
    }
    return vec2<f32>(max(gain_2.x, -0.94999998807907104f), gain_2.y);
}

fn vary_albedos_0( _S1051 : u32,  _S1052 : Albedos_0,  _S1053 : u32,  _S1054 : u32,  _S1055 : vec2<f32>) -> Albedos_0
{
    var _S1056 : vec3<f32> = max(_S1052.specular_reflect_0, _S1052.specular_transmit_0);
    var _S1057 : vec3<f32> = _S1052.diffuse_reflect_0 + _S1052.diffuse_transmit_0;
    var _S1058 : vec3<f32> = vec3<f32>(fabrics_0[_S1051].layer_bound_0);
    var _S1059 : vec3<f32> = vec3<f32>(1.0f);
    var _S1060 : vec3<f32> = _S1059 - _S1058 * _S1056;
    var colour_1 : f32 = bounded_gain_0(thread_gain_0(_S1053, fabrics_0[_S1051].colour_noise_0, fabrics_0[_S1051].seed_0), _S1057, _S1060);
    var _S1061 : vec3<f32> = vec3<f32>((colour_1 * (1.0f + flattened_0(_S1055.y, vec3<f32>(colour_1) * _S1057, _S1060) * _S1055.x)));
    var _S1062 : f32 = bounded_gain_0(fibre_gain_0(_S1053, _S1054, fabrics_0[_S1051].fibre_noise_0, fabrics_0[_S1051].seed_0), _S1056, min((_S1059 - _S1061 * _S1057) / _S1058, vec3<f32>(1.0f)));
    var varied_0 : Albedos_0;
    varied_0.diffuse_reflect_0 = _S1061 * _S1052.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S1061 * _S1052.diffuse_transmit_0;
    var _S1063 : vec3<f32> = vec3<f32>(_S1062);
    varied_0.specular_reflect_0 = _S1063 * _S1052.specular_reflect_0;
    varied_0.specular_transmit_0 = _S1063 * _S1052.specular_transmit_0;
    return varied_0;
}

fn varied_at_0( _S1064 : u32,  _S1065 : SurfacePoint_0,  _S1066 : Albedos_0,  _S1067 : bool,  _S1068 : f32,  _S1069 : f32) -> Albedos_0
{
    var _S1070 : u32 = thread_number_0(_S1064, _S1065);
    var _S1071 : vec3<f32> = fibre_cell_0(_S1065.fibre_across_0, _S1065.fibre_along_0, fabrics_0[_S1064].fibre_size_0);
    var _S1072 : vec2<f32> = vec2<f32>(0.0f);
    var gain_3 : vec2<f32>;
    if((((fabrics_0[_S1064].has_detail_0) != u32(0)) & ((_S1068 >= 0.0f))))
    {
        gain_3 = detail_gain_0(_S1064, select(fabrics_0[_S1064].weft_0, fabrics_0[_S1064].warp_0, _S1065.is_warp_0), _S1065, _S1067, _S1070, _S1068) * vec2<f32>(1.0f - _S1069, 1.0f);
    }
    else
    {
        gain_3 = _S1072;
    }
    return vary_albedos_0(_S1064, _S1066, _S1070, u32(i32(_S1071.x)) * u32(65536) + u32(i32(floor(_S1071.y))), gain_3);
}

fn with_variation_0( _S1073 : u32,  _S1074 : FamilyAlbedos_0,  _S1075 : SurfacePoint_0,  _S1076 : f32,  _S1077 : vec3<f32>,  _S1078 : bool,  _S1079 : f32) -> FamilyAlbedos_0
{
    var _S1080 : bool;
    if((fabrics_0[_S1073].has_detail_0) != u32(0))
    {
        _S1080 = has_hairs_0(_S1073);
    }
    else
    {
        _S1080 = false;
    }
    var cover_4 : f32;
    if(_S1080)
    {
        cover_4 = hair_towards_0(_S1073, hairs_over_0(_S1073, _S1075, _S1078, _S1079), _S1077, _S1079).cover_1;
    }
    else
    {
        cover_4 = 0.0f;
    }
    var result_10 : FamilyAlbedos_0 = _S1074;
    var _S1081 : Albedos_0;
    if(_S1075.is_warp_0)
    {
        _S1081 = _S1074.warp_6;
    }
    else
    {
        _S1081 = _S1074.weft_6;
    }
    var _S1082 : Albedos_0 = lerp_albedos_0(_S1081, varied_at_0(_S1073, _S1075, _S1081, _S1078, _S1079, cover_4), _S1076);
    if(_S1075.is_warp_0)
    {
        result_10.warp_6 = _S1082;
    }
    else
    {
        result_10.weft_6 = _S1082;
    }
    return result_10;
}

fn lobes_estimate_of_pass_0( _S1083 : u32,  _S1084 : Footprint_0,  _S1085 : f32,  _S1086 : vec2<f32>,  _S1087 : vec3<f32>,  _S1088 : vec3<f32>) -> Estimate_0
{
    var _S1089 : f32;
    var _S1090 : Regime_0 = regime_of_0(_S1083, _S1084, _S1085);
    var _S1091 : bool = (_S1088.z) < 0.0f;
    var _S1092 : vec3<f32> = to_face_frame_0(_S1088, _S1091);
    var _S1093 : f32 = Footprint_spread_side_0(_S1084);
    var _S1094 : bool = varies_at_0(_S1083, _S1093);
    var _S1095 : f32 = 1.0f - _S1090.prefiltered_0;
    var _S1096 : bool = is_layered_0(_S1083);
    var _S1097 : bool = ((_S1095 > 0.0f) & (((((((_S1094 | (((fabrics_0[_S1083].is_coloured_0) != u32(0))))) | (_S1096))) | (((fabrics_0[_S1083].is_irregular_0) != u32(0)))))));
    var box_0 : Footprint_0 = _S1084;
    var _S1098 : vec3<f32> = vec3<f32>(0.0f);
    var _S1099 : SurfacePoint_0 = SurfacePoint_x24init_0(false, false, u32(0), u32(0), 0.0f, _S1098, _S1098, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, u32(0));
    var _S1100 : Components_0 = no_components_0();
    var close_1 : CloseUp_0 = no_close_up_0();
    var _S1101 : u32 = select(u32(1), u32(0), _S1097);
    var points_1 : Components_0 = _S1100;
    var central_0 : SurfacePoint_0 = _S1099;
    var central_weight_0 : f32 = 0.0f;
    var number_15 : u32 = _S1101;
    for(;;)
    {
        var _S1102 : f32 = f32(number_15);
        _S1089 = _S1090.points_0;
        if(_S1102 < (_S1090.points_0 + 1.0f))
        {
        }
        else
        {
            break;
        }
        var _S1103 : bool = number_15 == u32(0);
        var _S1104 : u32 = number_15 - u32(1);
        var _S1105 : vec2<f32> = POINT_OFFSETS_0[select(_S1104, u32(0), _S1103)] + _S1086;
        var _S1106 : vec2<f32> = select_vector_0(_S1103, vec2<f32>(0.0f), _S1105 - round(_S1105));
        var _S1107 : vec2<f32> = _S1084.centre_0 + vec2<f32>(_S1106.x) * _S1084.dx_0 + vec2<f32>(_S1106.y) * _S1084.dy_0;
        var _S1108 : SearchQuality_0 = quality_of_0(select(_S1090.threads_2, 0.0f, _S1103));
        var _S1109 : Hit_0 = first_hit_0(_S1083, _S1108, _S1107.x, _S1107.y, _S1092, _S1091);
        var _S1110 : SurfacePoint_0 = surface_met_0(_S1083, _S1109.x_21, _S1109.y_14, _S1109.height_9, _S1092, _S1091);
        if(_S1103)
        {
            var central_weight_1 : f32 = select(_S1095, 0.0f, _S1109.hole_7);
            box_0.centre_0 = mix(_S1084.centre_0, vec2<f32>(_S1109.x_21, _S1109.y_14), vec2<f32>(central_weight_1));
            central_0 = _S1110;
            central_weight_0 = central_weight_1;
            number_15 = number_15 + u32(1);
            continue;
        }
        var _S1111 : YarnPoint_0 = uncoloured_point_0(_S1083, _S1110, _S1092, _S1091, _S1109.hole_7, _S1093);
        var _S1112 : f32 = min(_S1090.points_0 - f32(_S1104), 1.0f);
        var _S1113 : Components_0 = with_added_0(points_1, components_of_point_0(_S1083, _S1108, _S1111, _S1087, _S1088), _S1112);
        if((fabrics_0[_S1083].openness_0) != u32(4294967295))
        {
            close_1.warp_1 = with_blocked_0(_S1083, close_1.warp_1, _S1111, true, _S1112);
            close_1.weft_1 = with_blocked_0(_S1083, close_1.weft_1, _S1111, false, _S1112);
        }
        points_1 = _S1113;
        number_15 = number_15 + u32(1);
    }
    close_1.weight_0 = _S1095;
    var _S1114 : f32 = max(_S1089, 1.0f);
    close_1.warp_1 = scaled_0(close_1.warp_1, 1.0f / _S1114);
    close_1.weft_1 = scaled_0(close_1.weft_1, 1.0f / _S1114);
    var estimate_0 : Estimate_0;
    estimate_0.close_0 = close_1;
    estimate_0.components_0 = with_added_0(_S1100, points_1, _S1095 / _S1114);
    if((_S1090.prefiltered_0) > 0.0f)
    {
        var _S1115 : Components_0 = prefiltered_components_0(_S1083, _S1084, to_face_frame_0(_S1087, _S1091), _S1092, _S1091);
        estimate_0.components_0 = with_added_0(estimate_0.components_0, _S1115, _S1090.prefiltered_0);
    }
    var _S1116 : Yarns_0 = yarns_over_0(_S1083, box_0, _S1091);
    estimate_0.components_0 = with_shares_0(_S1083, estimate_0.components_0, _S1116);
    var nearest_0 : NearestLayer_0;
    nearest_0.number_13 = central_0.layer_0;
    nearest_0.weight_9 = central_weight_0;
    var _S1117 : LayeredAlbedos_0 = layered_albedos_0(_S1083, box_0, nearest_0, _S1091, to_face_frame_0(_S1087, _S1091), _S1092);
    estimate_0.behind_4 = _S1117.behind_0;
    estimate_0.albedos_14 = with_tones_0(_S1083, _S1117.albedos_2, _S1116);
    var _S1118 : bool = (_S1094 & ((central_weight_0 > 0.0f)));
    if(_S1118)
    {
        estimate_0.albedos_14 = with_variation_0(_S1083, estimate_0.albedos_14, central_0, central_weight_0, _S1092, _S1091, _S1093);
    }
    estimate_0.means_4 = estimate_0.albedos_14;
    if(_S1096)
    {
        estimate_0.means_4 = with_tones_0(_S1083, _S1117.means_0, _S1116);
        if(_S1118)
        {
            estimate_0.means_4 = with_variation_0(_S1083, estimate_0.means_4, central_0, central_weight_0, _S1092, _S1091, _S1093);
        }
    }
    return estimate_0;
}

fn diffuse_kept_0( _S1119 : u32,  _S1120 : vec3<f32>,  _S1121 : vec3<f32>) -> f32
{
    return (1.0f - fabrics_0[_S1119].grazing_loss_0 * fourth_power_0(max(1.0f - abs(_S1120.z), 0.0f))) * (1.0f - fabrics_0[_S1119].grazing_loss_0 * fourth_power_0(max(1.0f - abs(_S1121.z), 0.0f)));
}

fn highlight_rise_0( _S1122 : u32,  _S1123 : vec3<f32>,  _S1124 : vec3<f32>) -> f32
{
    var _S1125 : f32 = 1.0f - sqrt(clamp(0.5f * dot(_S1123, _S1124) + 0.5f, 9.99999993922529029e-09f, 1.0f));
    return fabrics_0[_S1122].grazing_gain_0 * fourth_power_0(_S1125) * _S1125;
}

fn towards_grazing_0( _S1126 : u32,  _S1127 : Albedos_0,  _S1128 : vec3<f32>,  _S1129 : vec3<f32>) -> Albedos_0
{
    var _S1130 : f32 = diffuse_kept_0(_S1126, _S1128, _S1129);
    var result_11 : Albedos_0 = _S1127;
    var _S1131 : vec3<f32> = vec3<f32>(_S1130);
    result_11.diffuse_reflect_0 = result_11.diffuse_reflect_0 * _S1131;
    result_11.diffuse_transmit_0 = result_11.diffuse_transmit_0 * _S1131;
    result_11.specular_reflect_0 = result_11.specular_reflect_0 + vec3<f32>(highlight_rise_0(_S1126, _S1128, _S1129));
    return result_11;
}

fn scattered_by_0( _S1132 : u32,  _S1133 : Albedos_0,  _S1134 : u32,  _S1135 : vec3<f32>) -> Scattered_0
{
    var _S1136 : u32 = u32(159) + u32(2) * _S1134;
    var yarn_4 : Scattered_0;
    yarn_4.back_14 = _S1135 * _S1133.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S1132, _S1136)) * _S1133.specular_reflect_0;
    yarn_4.through_1 = _S1135 * _S1133.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S1132, _S1136 + u32(1))) * _S1133.specular_transmit_0;
    return yarn_4;
}

fn sent_0( _S1137 : u32,  _S1138 : u32,  _S1139 : vec3<f32>,  _S1140 : vec3<f32>,  _S1141 : vec3<f32>,  _S1142 : vec3<f32>,  _S1143 : ptr<function, vec3<f32>>,  _S1144 : ptr<function, vec3<f32>>)
{
    var _S1145 : u32 = u32(146) + u32(4) * _S1138;
    var _S1146 : f32 = openness_number_0(_S1137, _S1145 + u32(1));
    var _S1147 : f32 = openness_number_0(_S1137, _S1145 + u32(2));
    var _S1148 : vec3<f32> = vec3<f32>(1.0f);
    var _S1149 : vec3<f32> = _S1148 - _S1141 * vec3<f32>(openness_number_0(_S1137, _S1145));
    var _S1150 : vec3<f32> = _S1148 - _S1142 * vec3<f32>(openness_number_0(_S1137, _S1145 + u32(3)));
    var _S1151 : vec3<f32> = _S1148 / (_S1149 * _S1150 - _S1141 * _S1142 * vec3<f32>((_S1146 * _S1147)));
    (*_S1143) = (_S1139 * _S1150 + _S1141 * vec3<f32>(_S1146) * _S1140) * _S1151;
    (*_S1144) = (_S1140 * _S1149 + _S1142 * vec3<f32>(_S1147) * _S1139) * _S1151;
    return;
}

fn face_sends_0( _S1152 : u32,  _S1153 : u32,  _S1154 : Scattered_0,  _S1155 : Scattered_0) -> FaceSends_0
{
    var _S1156 : u32 = u32(2) * _S1153;
    var _S1157 : u32 = u32(142) + _S1156;
    var _S1158 : f32 = openness_number_0(_S1152, _S1157);
    var _S1159 : f32 = openness_number_0(_S1152, _S1157 + u32(1));
    var _S1160 : vec3<f32> = vec3<f32>((1.0f - _S1158)) * _S1154.back_14;
    var _S1161 : vec3<f32> = vec3<f32>((1.0f - _S1159)) * _S1155.back_14;
    var sends_1 : FaceSends_0;
    var _S1162 : u32 = u32(154) + _S1156;
    var _S1163 : f32 = openness_number_0(_S1152, _S1162);
    sends_1.blocks_warp_0 = _S1163;
    var _S1164 : f32 = openness_number_0(_S1152, _S1162 + u32(1));
    sends_1.blocks_weft_0 = _S1164;
    sends_1.open_0 = _S1163 * _S1158 + _S1164 * _S1159;
    var _S1165 : vec3<f32> = vec3<f32>(_S1158) * _S1154.back_14;
    var _S1166 : vec3<f32> = vec3<f32>(_S1159) * _S1155.back_14;
    var _S1167 : vec3<f32> = sends_1.sky_warp_0;
    var _S1168 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S1152, _S1153, _S1165, _S1166, _S1160, _S1161, &(_S1167), &(_S1168));
    sends_1.sky_warp_0 = _S1167;
    sends_1.sky_weft_0 = _S1168;
    var _S1169 : vec3<f32> = sends_1.crossing_warp_0;
    var _S1170 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S1152, _S1153, _S1154.through_1, _S1155.through_1, _S1160, _S1161, &(_S1169), &(_S1170));
    sends_1.crossing_warp_0 = _S1169;
    sends_1.crossing_weft_0 = _S1170;
    return sends_1;
}

fn interior_between_0( _S1171 : u32,  _S1172 : u32,  _S1173 : u32,  _S1174 : vec3<f32>,  _S1175 : bool) -> Interior_0
{
    var _S1176 : Scattered_0 = scattered_by_0(_S1171, table_albedos_0(_S1172), u32(0), _S1174);
    var _S1177 : Scattered_0 = scattered_by_0(_S1171, table_albedos_0(_S1173), u32(1), _S1174);
    var _S1178 : FaceSends_0 = face_sends_0(_S1171, select(u32(0), u32(1), _S1175), _S1176, _S1177);
    var _S1179 : FaceSends_0 = face_sends_0(_S1171, select(u32(1), u32(0), _S1175), _S1176, _S1177);
    var _S1180 : vec3<f32> = vec3<f32>(_S1178.blocks_warp_0);
    var _S1181 : vec3<f32> = vec3<f32>(_S1178.blocks_weft_0);
    var _S1182 : vec3<f32> = _S1180 * _S1178.crossing_warp_0 + _S1181 * _S1178.crossing_weft_0;
    var _S1183 : vec3<f32> = vec3<f32>(_S1179.blocks_warp_0);
    var _S1184 : vec3<f32> = vec3<f32>(_S1179.blocks_weft_0);
    var _S1185 : vec3<f32> = _S1183 * _S1179.crossing_warp_0 + _S1184 * _S1179.crossing_weft_0;
    var _S1186 : f32 = 1.0f - _S1178.open_0;
    var _S1187 : f32 = 1.0f - _S1179.open_0;
    var _S1188 : vec3<f32> = vec3<f32>(1.0f);
    var _S1189 : vec3<f32> = _S1188 / (_S1188 - _S1182 * _S1185 * vec3<f32>((_S1186 * _S1187)));
    var _S1190 : vec3<f32> = _S1185 * (vec3<f32>(_S1178.open_0) + vec3<f32>(_S1186) * (_S1180 * _S1178.sky_warp_0 + _S1181 * _S1178.sky_weft_0)) * _S1189;
    var _S1191 : vec3<f32> = _S1182 * (vec3<f32>(_S1179.open_0) + vec3<f32>(_S1187) * (_S1183 * _S1179.sky_warp_0 + _S1184 * _S1179.sky_weft_0)) * _S1189;
    var _S1192 : FaceRadiance_0 = face_radiance_0(_S1178, _S1179.open_0, _S1190, _S1191);
    var _S1193 : FaceRadiance_0 = face_radiance_0(_S1179, _S1178.open_0, _S1191, _S1190);
    var interior_1 : Interior_0;
    interior_1.warp_9 = _S1192.warp_8;
    interior_1.weft_9 = _S1192.weft_8;
    interior_1.leaked_1 = _S1192.leaked_0;
    interior_1.far_1 = _S1193.mean_1;
    interior_1.far_leaked_0 = _S1193.leaked_0;
    return interior_1;
}

fn interior_of_0( _S1194 : u32,  _S1195 : vec3<f32>,  _S1196 : bool) -> Interior_0
{
    return interior_between_0(_S1194, families_0[fabrics_0[_S1194].warp_0].cloth_mean_0, families_0[fabrics_0[_S1194].weft_0].cloth_mean_0, _S1195, _S1196);
}

fn blocked_from_0( _S1197 : u32,  _S1198 : vec3<f32>,  _S1199 : bool,  _S1200 : bool) -> Blocked_0
{
    var terms_6 : array<f32, i32(6)>;
    view_terms_0(_S1198, &(terms_6));
    return blocked_of_terms_0(_S1197, (select(u32(0), u32(2), _S1200) + select(u32(1), u32(0), _S1199)) * u32(15), terms_6, u32(5));
}

fn warp_seen_from_0( _S1201 : u32,  _S1202 : vec3<f32>,  _S1203 : bool) -> f32
{
    var terms_7 : array<f32, i32(6)>;
    view_terms_1(_S1202, &(terms_7));
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
        var share_7 : f32 = share_6 + openness_number_0(_S1201, u32(132) + select(u32(0), u32(5), _S1203) + term_3) * terms_7[term_3];
        term_3 = term_3 + u32(1);
        share_6 = share_7;
    }
    return saturate(share_6);
}

fn bounced_of_families_0( _S1204 : u32,  _S1205 : FamilyAlbedos_0,  _S1206 : vec3<f32>,  _S1207 : Interior_0,  _S1208 : Blocked_0,  _S1209 : Blocked_0) -> Bounced_0
{
    return sum_of_0(bounced_by_0(_S1208, scattered_by_0(_S1204, _S1205.warp_6, u32(0), _S1206), _S1207), bounced_by_0(_S1209, scattered_by_0(_S1204, _S1205.weft_6, u32(1), _S1206), _S1207));
}

fn bounced_far_0( _S1210 : u32,  _S1211 : FamilyAlbedos_0,  _S1212 : vec3<f32>,  _S1213 : Interior_0,  _S1214 : vec3<f32>,  _S1215 : bool,  _S1216 : f32,  _S1217 : f32,  _S1218 : f32) -> Bounced_0
{
    var _S1219 : Blocked_0 = blocked_from_0(_S1210, _S1214, true, _S1215);
    var _S1220 : Blocked_0 = blocked_from_0(_S1210, _S1214, false, _S1215);
    var _S1221 : f32 = _S1216 / max(1.0f - _S1219.by_warp_0 - _S1219.by_weft_0, 0.10000000149011612f);
    var _S1222 : f32 = (0.0020000000949949f * warp_seen_from_0(_S1210, _S1214, _S1215) + _S1221) / (_S1221 + _S1217 / max(1.0f - _S1220.by_warp_0 - _S1220.by_weft_0, 0.10000000149011612f) + 0.0020000000949949f);
    var _S1223 : f32 = 1.0f - _S1218;
    return bounced_of_families_0(_S1210, _S1211, _S1212, _S1213, scaled_0(_S1219, _S1222 * _S1223), scaled_0(_S1220, (1.0f - _S1222) * _S1223));
}

fn bounced_over_0( _S1224 : u32,  _S1225 : Components_0,  _S1226 : CloseUp_0,  _S1227 : FamilyAlbedos_0,  _S1228 : vec3<f32>,  _S1229 : vec3<f32>) -> Bounced_0
{
    var _S1230 : bool = (_S1229.z) < 0.0f;
    var _S1231 : Interior_0 = interior_of_0(_S1224, _S1228, _S1230);
    var bounced_2 : Bounced_0 = bounced_far_0(_S1224, _S1227, _S1228, _S1231, to_face_frame_0(_S1229, _S1230), _S1230, _S1225.diffuse_warp_0, _S1225.diffuse_weft_0, _S1225.hole_2);
    if((_S1226.weight_0) > 0.0f)
    {
        var _S1232 : Bounced_0 = bounced_of_families_0(_S1224, _S1227, _S1228, _S1231, _S1226.warp_1, _S1226.weft_1);
        var _S1233 : vec3<f32> = vec3<f32>(_S1226.weight_0);
        bounced_2.reflected_2 = mix(bounced_2.reflected_2, _S1232.reflected_2, _S1233);
        bounced_2.transmitted_2 = mix(bounced_2.transmitted_2, _S1232.transmitted_2, _S1233);
    }
    return bounced_2;
}

fn composed_before_0( _S1234 : u32,  _S1235 : Components_0,  _S1236 : CloseUp_0,  _S1237 : FamilyAlbedos_0,  _S1238 : FamilyAlbedos_0,  _S1239 : LayersBehind_0,  _S1240 : vec3<f32>,  _S1241 : vec3<f32>,  _S1242 : vec3<f32>) -> vec3<f32>
{
    var _S1243 : Albedos_0 = towards_grazing_0(_S1234, tinted_0(_S1237.warp_6, _S1240), _S1241, _S1242);
    var _S1244 : Albedos_0 = towards_grazing_0(_S1234, tinted_0(_S1237.weft_6, _S1240), _S1241, _S1242);
    var _S1245 : vec3<f32> = vec3<f32>(_S1235.diffuse_warp_0);
    var _S1246 : vec3<f32> = vec3<f32>(_S1235.diffuse_weft_0);
    var _S1247 : vec3<f32> = vec3<f32>(_S1235.specular_warp_0);
    var _S1248 : vec3<f32> = vec3<f32>(_S1235.specular_weft_0);
    var _S1249 : vec3<f32> = _S1243.diffuse_reflect_0 * _S1245 + _S1244.diffuse_reflect_0 * _S1246 + _S1243.specular_reflect_0 * _S1247 + _S1244.specular_reflect_0 * _S1248;
    var _S1250 : f32 = _S1241.z;
    var _S1251 : f32 = _S1242.z;
    var _S1252 : bool = (_S1250 * _S1251) < 0.0f;
    var body_0 : vec3<f32>;
    if(_S1252)
    {
        body_0 = _S1243.diffuse_transmit_0 * _S1245 + _S1244.diffuse_transmit_0 * _S1246 + _S1243.specular_transmit_0 * _S1247 + _S1244.specular_transmit_0 * _S1248;
    }
    else
    {
        body_0 = _S1249;
    }
    if((fabrics_0[_S1234].openness_0) != u32(4294967295))
    {
        body_0 = body_0 + bounced_value_0(bounced_over_0(_S1234, _S1235, _S1236, _S1238, _S1240, _S1242), _S1241, _S1242) * vec3<f32>(diffuse_kept_0(_S1234, _S1241, _S1242));
    }
    if(is_layered_0(_S1234))
    {
        body_0 = body_0 + _S1240 * select_vector_1(_S1252, _S1239.transmitted_0, _S1239.reflected_0) * vec3<f32>((abs(_S1250) * 0.31830987334251404f)) * vec3<f32>(diffuse_kept_0(_S1234, _S1241, _S1242));
    }
    var _S1253 : f32 = fabrics_0[_S1234].sheen_strength_0;
    if((fabrics_0[_S1234].sheen_strength_0) <= 0.0f)
    {
        return body_0;
    }
    var _S1254 : bool = _S1251 < 0.0f;
    var _S1255 : vec2<f32> = sheen_with_transmittance_0(to_face_frame_0(_S1241, _S1254), to_face_frame_0(_S1242, _S1254), _S1253, fabrics_0[_S1234].sheen_roughness_0);
    return vec3<f32>(_S1255.y) * body_0 + vec3<f32>(((_S1235.light_visibility_1 + _S1235.hole_2) * _S1255.x));
}

fn composed_estimate_0( _S1256 : u32,  _S1257 : Estimate_0,  _S1258 : vec3<f32>,  _S1259 : vec3<f32>,  _S1260 : vec3<f32>) -> vec3<f32>
{
    return composed_before_0(_S1256, _S1257.components_0, _S1257.close_0, _S1257.albedos_14, _S1257.means_4, _S1257.behind_4, _S1258, _S1259, _S1260);
}

fn light_of_footprint_0( _S1261 : u32,  _S1262 : VisiblePoint_0,  _S1263 : vec2<u32>,  _S1264 : vec3<f32>) -> vec4<f32>
{
    var footprint_0 : Footprint_0;
    footprint_0.dx_0 = _S1262.draft_dx_0;
    footprint_0.dy_0 = _S1262.draft_dy_0;
    footprint_0.centre_0 = irregular_place_0(_S1261, _S1262.draft_0, Footprint_spread_side_0(footprint_0));
    var _S1265 : vec2<f32> = fract(vec2<f32>(f32(((frame_record_0.pass_number_0) & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
    var _S1266 : vec3<f32> = to_local_0(_S1262, _S1262.view_0);
    var _S1267 : u32 = light_sample_count_0();
    var _S1268 : vec3<f32> = vec3<f32>(0.0f);
    var number_16 : u32 = u32(0);
    var radiance_1 : vec3<f32> = _S1268;
    var hole_8 : f32 = 0.0f;
    for(;;)
    {
        if(number_16 < (max(_S1267, u32(1))))
        {
        }
        else
        {
            break;
        }
        var _S1269 : f32;
        if(number_16 < _S1267)
        {
            _S1269 = visibility_at_0(number_16, _S1263);
        }
        else
        {
            _S1269 = 0.0f;
        }
        var _S1270 : bool;
        if(_S1269 <= 0.0f)
        {
            _S1270 = number_16 > u32(0);
        }
        else
        {
            _S1270 = false;
        }
        if(_S1270)
        {
            number_16 = number_16 + u32(1);
            continue;
        }
        var _S1271 : LightSample_0 = light_sample_0(number_16, _S1263, _S1262.position_4);
        var _S1272 : vec3<f32> = to_local_0(_S1262, _S1271.towards_0);
        var _S1273 : Estimate_0 = lobes_estimate_of_pass_0(_S1261, footprint_0, 1.0f, _S1265, _S1272, _S1266);
        radiance_1 = radiance_1 + vec3<f32>(_S1269) * _S1271.irradiance_1 * composed_estimate_0(_S1261, _S1273, _S1264, _S1272, _S1266);
        hole_8 = _S1273.components_0.hole_2;
        number_16 = number_16 + u32(1);
    }
    var _S1274 : f32 = fabrics_0[_S1261].sheen_strength_0;
    if((fabrics_0[_S1261].sheen_strength_0) > 0.0f)
    {
        hole_8 = hole_8 * (1.0f - _S1274 * sheen_lobe_0(abs(_S1266.z), fabrics_0[_S1261].sheen_roughness_0).z);
    }
    return vec4<f32>(radiance_1, 1.0f - hole_8);
}

@compute
@workgroup_size(8, 8, 1)
fn shade_lobes(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S1275 : u32 = id_0.x;
    var _S1276 : bool;
    if(_S1275 >= (frame_record_0.width_0))
    {
        _S1276 = true;
    }
    else
    {
        _S1276 = (id_0.y) >= (frame_record_0.height_0);
    }
    if(_S1276)
    {
        return;
    }
    var _S1277 : u32 = id_0.y * frame_record_0.width_0 + _S1275;
    var _S1278 : u32 = layers_0[_S1277].face_0;
    if((layers_0[_S1277].face_0) == u32(0))
    {
        return;
    }
    var _S1279 : u32 = _S1278 - u32(1);
    var _S1280 : u32 = fabric_of_0(_S1279);
    var _S1281 : vec2<u32> = id_0.xy;
    var _S1282 : VisiblePoint_0 = visible_point_0(_S1280, _S1279, _S1281);
    var _S1283 : vec4<f32> = light_of_footprint_0(_S1280, _S1282, _S1281, filtered_albedo_0(_S1280, _S1282));
    accumulate_0(_S1277, _S1283);
    return;
}

