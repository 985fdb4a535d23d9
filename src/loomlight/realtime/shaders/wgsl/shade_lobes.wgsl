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

@binding(6) @group(0) var<storage, read_write> visibilities_0 : array<f32>;

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

@binding(2) @group(0) var<storage, read> words_0 : array<u32>;

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

fn square_1( x_2 : f32) -> f32
{
    return x_2 * x_2;
}

fn natural_logarithm_0( x_3 : f32) -> f32
{
    var _S1 : u32 = (bitcast<u32>((x_3)));
    var exponent_0 : f32 = f32(i32((_S1 >> (u32(23)))) - i32(126));
    var m_0 : f32 = (bitcast<f32>(((((_S1 & (u32(8388607)))) | (u32(1056964608))))));
    var m_1 : f32;
    var exponent_1 : f32;
    if(m_0 < 0.70710676908493042f)
    {
        var exponent_2 : f32 = exponent_0 - 1.0f;
        m_1 = m_0 + m_0;
        exponent_1 = exponent_2;
    }
    else
    {
        m_1 = m_0;
        exponent_1 = exponent_0;
    }
    var m_2 : f32 = m_1 - 1.0f;
    var _S2 : f32 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S2 - exponent_1 * 0.00021219444170129f - 0.5f * _S2) + exponent_1 * 0.693359375f;
}

fn binary_logarithm_0( x_4 : f32) -> f32
{
    return natural_logarithm_0(x_4) * 1.4426950216293335f;
}

fn exponential_0( x_5 : f32) -> f32
{
    var _S3 : f32 = clamp(x_5, -87.0f, 88.0f);
    var _S4 : f32 = floor(_S3 * 1.4426950216293335f + 0.5f);
    var _S5 : f32 = _S3 - _S4 * 0.693359375f + _S4 * 0.00021219444170129f;
    return select(((((((0.00019875691214111f * _S5 + 0.00139819993637502f) * _S5 + 0.00833345204591751f) * _S5 + 0.04166579619050026f) * _S5 + 0.1666666567325592f) * _S5 + 0.5f) * _S5 * _S5 + _S5 + 1.0f) * (bitcast<f32>(((u32(i32(_S4) + i32(127)) << (u32(23)))))), 0.0f, x_5 < -87.0f);
}

fn map_texel_0( index_0 : u32) -> vec3<f32>
{
    var _S6 : u32 = scene_words_0[index_0];
    var _S7 : vec3<f32> = vec3<f32>(f32((_S6 & (u32(1023)))), f32((((_S6 >> (u32(10)))) & (u32(1023)))), f32((_S6 >> (u32(20))))) / vec3<f32>(1023.0f);
    return _S7 * _S7;
}

fn map_level_0( first_1 : u32,  side_0 : u32,  uv_0 : vec2<f32>) -> vec3<f32>
{
    var _S8 : f32 = uv_0.x;
    var _S9 : f32 = f32(side_0);
    var _S10 : f32 = (_S8 - floor(_S8)) * _S9 - 0.5f;
    var _S11 : f32 = uv_0.y;
    var _S12 : f32 = (_S11 - floor(_S11)) * _S9 - 0.5f;
    var _S13 : f32 = floor(_S10);
    var _S14 : i32 = i32(side_0);
    var _S15 : u32 = side_0 - u32(1);
    var _S16 : u32 = (u32(i32(_S13) + _S14) & (_S15));
    var _S17 : f32 = floor(_S12);
    var _S18 : u32 = (u32(i32(_S17) + _S14) & (_S15));
    var _S19 : u32 = ((_S16 + u32(1)) & (_S15));
    var _S20 : u32 = first_1 + _S18 * side_0;
    var _S21 : vec3<f32> = vec3<f32>((_S10 - _S13));
    var _S22 : u32 = first_1 + (((_S18 + u32(1)) & (_S15))) * side_0;
    return mix(mix(map_texel_0(_S20 + _S16), map_texel_0(_S20 + _S19), _S21), mix(map_texel_0(_S22 + _S16), map_texel_0(_S22 + _S19), _S21), vec3<f32>((_S12 - _S17)));
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

fn scramble_0( value_0 : u32) -> u32
{
    var _S23 : u32 = value_0 * u32(747796405) + u32(2891336453);
    var _S24 : u32 = ((((_S23 >> ((((_S23 >> (u32(28)))) + u32(4))))) ^ (_S23))) * u32(277803737);
    return (((_S24 >> (u32(22)))) ^ (_S24));
}

fn hash_key_0( thread_0 : u32,  stream_0 : u32) -> u32
{
    return scramble_0(thread_0 + scramble_0(stream_0));
}

fn hash_bits_0( key_0 : u32,  cell_0 : u32) -> u32
{
    return scramble_0(cell_0 + key_0);
}

fn uniform_hash_0( thread_1 : u32,  cell_1 : u32,  stream_1 : u32) -> f32
{
    return (f32(((hash_bits_0(hash_key_0(thread_1, stream_1), cell_1)) >> (u32(9)))) + 0.5f) * 1.1920928955078125e-07f;
}

fn pixel_sequence_0( pixel_0 : vec2<u32>,  index_1 : u32,  stream_2 : u32) -> vec2<f32>
{
    var _S25 : u32 = pixel_0.x;
    var _S26 : u32 = pixel_0.y;
    return fract(vec2<f32>(uniform_hash_0(_S25, _S26, stream_2), uniform_hash_0(_S25, _S26, stream_2 + u32(1))) + vec2<f32>(f32((index_1 & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
}

fn scene_number_0( index_2 : u32) -> f32
{
    return (bitcast<f32>((scene_words_0[index_2])));
}

struct Choice_0
{
     index_3 : u32,
     remainder_0 : f32,
};

fn choose_0( table_0 : u32,  count_1 : u32,  number_0 : f32) -> Choice_0
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
        var _S27 : u32 = (low_0 + high_0) / u32(2);
        if((scene_number_0(table_0 + _S27)) <= number_0)
        {
            low_0 = _S27;
        }
        else
        {
            high_0 = _S27;
        }
    }
    var _S28 : u32 = table_0 + low_0;
    var _S29 : f32 = scene_number_0(_S28);
    var _S30 : f32 = scene_number_0(_S28 + u32(1));
    var choice_0 : Choice_0;
    choice_0.index_3 = low_0;
    choice_0.remainder_0 = saturate((number_0 - _S29) / max(_S30 - _S29, 9.999999960041972e-13f));
    return choice_0;
}

fn mean_0( colour_0 : vec3<f32>) -> f32
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

fn sine_cosine_0( x_6 : f32) -> vec2<f32>
{
    var _S31 : f32 = floor(x_6 * 0.63661974668502808f + 0.5f);
    var _S32 : f32 = x_6 - _S31 * 1.5703125f - _S31 * 0.00048375129699707f - _S31 * 7.54979012640433211e-08f;
    var _S33 : f32 = _S32 * _S32;
    var _S34 : f32 = ((-0.00019515295571182f * _S33 + 0.00833216123282909f) * _S33 - 0.16666655242443085f) * _S33 * _S32 + _S32;
    var _S35 : f32 = ((0.00002443315679557f * _S33 - 0.00138873164542019f) * _S33 + 0.04166664555668831f) * _S33 * _S33 - 0.5f * _S33 + 1.0f;
    var _S36 : u32 = (u32(i32(_S31)) & (u32(3)));
    var _S37 : vec2<f32> = select_vector_0(((_S36 & (u32(1)))) != u32(0), vec2<f32>(_S35, _S34), vec2<f32>(_S34, _S35));
    var _S38 : f32 = _S37.x;
    var _S39 : f32 = _S37.y;
    return vec2<f32>(select(_S38, - _S38, ((_S36 & (u32(2)))) != u32(0)), select(_S39, - _S39, (((_S36 + u32(1)) & (u32(2)))) != u32(0)));
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

struct Footprint_0
{
     centre_0 : vec2<f32>,
     dx_0 : vec2<f32>,
     dy_0 : vec2<f32>,
};

fn Footprint_spread_side_0( this_0 : Footprint_0) -> f32
{
    var _S40 : vec2<f32> = this_0.dx_0;
    var _S41 : vec2<f32> = this_0.dy_0;
    return sqrt(0.5f * (dot(_S40, _S40) + dot(_S41, _S41)));
}

fn to_face_frame_0( direction_1 : vec3<f32>,  back_2 : bool) -> vec3<f32>
{
    var _S42 : f32 = direction_1.z;
    return vec3<f32>(direction_1.xy, select(_S42, - _S42, back_2));
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
     across_0 : f32,
     fibre_across_0 : f32,
     fibre_along_0 : f32,
};

fn SurfacePoint_x24init_0( hole_1 : bool,  is_warp_1 : bool,  warp_thread_1 : u32,  weft_thread_1 : u32,  height_3 : f32,  normal_2 : vec3<f32>,  tangent_1 : vec3<f32>,  across_1 : f32,  fibre_across_1 : f32,  fibre_along_1 : f32) -> SurfacePoint_0
{
    var _S43 : SurfacePoint_0;
    _S43.hole_0 = hole_1;
    _S43.is_warp_0 = is_warp_1;
    _S43.warp_thread_0 = warp_thread_1;
    _S43.weft_thread_0 = weft_thread_1;
    _S43.height_2 = height_3;
    _S43.normal_1 = normal_2;
    _S43.tangent_0 = tangent_1;
    _S43.across_0 = across_1;
    _S43.fibre_across_0 = fibre_across_1;
    _S43.fibre_along_0 = fibre_along_1;
    return _S43;
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
    var _S44 : Blocked_0 = no_blocked_0();
    nothing_2.warp_1 = _S44;
    nothing_2.weft_1 = _S44;
    return nothing_2;
}

struct SearchQuality_0
{
     steps_per_thread_0 : f32,
     steps_per_relief_0 : f32,
     shadow_share_0 : f32,
     refinements_0 : u32,
};

fn quality_of_0( threads_0 : f32) -> SearchQuality_0
{
    var _S45 : f32 = clamp((-3.0f - binary_logarithm_0(max(threads_0, 9.99999971718068537e-10f))) / 2.0f, 0.0f, 1.0f);
    var quality_0 : SearchQuality_0;
    var _S46 : f32 = mix(2.5f, 5.0f, _S45);
    quality_0.steps_per_thread_0 = _S46;
    quality_0.steps_per_relief_0 = _S46;
    quality_0.shadow_share_0 = mix(1.60000002384185791f, 1.0f, _S45);
    quality_0.refinements_0 = u32(mix(1.0f, 2.0f, _S45) + 0.5f);
    return quality_0;
}

fn turns_and_remainder_0( family_0 : u32,  index_4 : f32) -> vec2<f32>
{
    var _S47 : f32 = floor(fma(index_4, families_0[family_0].inverse_count_0, families_0[family_0].half_inverse_count_0));
    return vec2<f32>(_S47, fma(- _S47, families_0[family_0].count_0, index_4));
}

struct Cell_0
{
     thread_2 : u32,
     across_2 : f32,
     half_width_1 : f32,
     below_0 : f32,
     above_0 : f32,
};

fn locate_alike_0( family_1 : u32,  position_1 : f32) -> Cell_0
{
    var _S48 : f32 = floor(position_1 * families_0[family_1].inverse_size_0);
    var cell_2 : Cell_0;
    var _S49 : f32 = fma(- _S48, families_0[family_1].size_0, position_1);
    cell_2.below_0 = _S49;
    cell_2.above_0 = families_0[family_1].size_0 - _S49;
    cell_2.across_2 = _S49 - 0.5f * families_0[family_1].size_0;
    cell_2.half_width_1 = families_0[family_1].half_width_0;
    cell_2.thread_2 = u32(clamp(turns_and_remainder_0(family_1, _S48).y, 0.0f, families_0[family_1].count_0 - 1.0f));
    return cell_2;
}

fn table_number_0( index_5 : u32) -> f32
{
    return (bitcast<f32>((words_0[index_5])));
}

fn locate_varied_0( family_2 : u32,  position_2 : f32) -> Cell_0
{
    var turns_0 : f32 = (position_2 - families_0[family_2].start_0) * families_0[family_2].inverse_period_0;
    var turns_1 : f32 = turns_0 - floor(turns_0);
    var _S50 : f32 = turns_1 * families_0[family_2].period_0;
    var thread_3 : u32 = words_0[families_0[family_2].first_thread_table_0 + u32(clamp(turns_1 * families_0[family_2].bins_0, 0.0f, families_0[family_2].bins_0 - 1.0f))];
    var _S51 : u32 = min(thread_3 + select(u32(0), u32(1), _S50 >= (table_number_0(families_0[family_2].place_table_0 + thread_3 * u32(4) + u32(1)))), u32(families_0[family_2].count_0) - u32(1));
    var _S52 : u32 = families_0[family_2].place_table_0 + _S51 * u32(4);
    var cell_3 : Cell_0;
    cell_3.thread_2 = _S51;
    cell_3.below_0 = _S50 - table_number_0(_S52);
    cell_3.above_0 = table_number_0(_S52 + u32(1)) - _S50;
    cell_3.across_2 = _S50 - table_number_0(_S52 + u32(2));
    cell_3.half_width_1 = table_number_0(_S52 + u32(3));
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
    var _S53 : bool = (abs(crossing_0.warp_2.across_2)) < (crossing_0.warp_2.half_width_1);
    var shown_0 : Shown_0;
    var _S54 : bool = !((abs(crossing_0.weft_2.across_2)) < (crossing_0.weft_2.half_width_1));
    var _S55 : bool = (_S53 & (((_S54 | ((crossing_0.warp_above_0))))));
    shown_0.is_warp_2 = _S55;
    shown_0.hole_3 = ((!_S53) & (_S54));
    var _S56 : u32 = select(crossing_0.weft_word_0, crossing_0.warp_word_0, _S55);
    shown_0.word_0 = _S56;
    shown_0.on_top_0 = (((_S56 & (u32(1)))) == u32(1)) != back_3;
    return shown_0;
}

fn select_cell_0( is_first_0 : bool,  first_3 : Cell_0,  second_0 : Cell_0) -> Cell_0
{
    var cell_4 : Cell_0;
    cell_4.thread_2 = select(second_0.thread_2, first_3.thread_2, is_first_0);
    cell_4.across_2 = select(second_0.across_2, first_3.across_2, is_first_0);
    cell_4.half_width_1 = select(second_0.half_width_1, first_3.half_width_1, is_first_0);
    cell_4.below_0 = select(second_0.below_0, first_3.below_0, is_first_0);
    cell_4.above_0 = select(second_0.above_0, first_3.above_0, is_first_0);
    return cell_4;
}

fn boundary_0( family_4 : u32,  thread_4 : u32,  step_0 : i32) -> f32
{
    var _S57 : vec2<f32> = turns_and_remainder_0(family_4, f32(i32(thread_4) + step_0));
    return fma(_S57.x, families_0[family_4].period_0, table_number_0(families_0[family_4].place_table_0 + u32(_S57.y) * u32(4)));
}

fn span_0( family_5 : u32,  thread_5 : u32,  first_4 : i32,  last_0 : i32) -> f32
{
    if((families_0[family_5].is_alike_0) != u32(0))
    {
        return f32(last_0 - first_4) * families_0[family_5].size_0;
    }
    return boundary_0(family_5, thread_5, last_0) - boundary_0(family_5, thread_5, first_4);
}

struct Bend_0
{
     sine_0 : f32,
     half_tangent_0 : f32,
     arc_0 : f32,
};

fn bend_of_0( family_6 : u32,  thread_6 : u32) -> Bend_0
{
    var _S58 : u32 = families_0[family_6].bend_table_0 + select(thread_6 * u32(4), u32(0), (families_0[family_6].is_alike_0) != u32(0));
    var bend_0 : Bend_0;
    bend_0.sine_0 = table_number_0(_S58);
    bend_0.half_tangent_0 = table_number_0(_S58 + u32(1));
    bend_0.arc_0 = table_number_0(_S58 + u32(2));
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
    var _S59 : i32 = i32((((word_1 >> (u32(1)))) & (u32(127))));
    var _S60 : i32 = i32((((word_1 >> (u32(8)))) & (u32(127))));
    var _S61 : i32 = i32((((word_1 >> (u32(15)))) & (u32(63))));
    var _S62 : i32 = i32((((word_1 >> (u32(21)))) & (u32(63))));
    var run_0 : Run_0;
    var _S63 : bool = ((((word_1 >> (u32(27)))) & (u32(1)))) == u32(1);
    run_0.straight_0 = _S63;
    var _S64 : i32 = - _S59;
    var _S65 : f32 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_2, _S64, i32(0));
    run_0.from_start_0 = _S65;
    var _S66 : i32 = _S60 + i32(1);
    var _S67 : f32 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_2, i32(1), _S66);
    run_0.to_end_0 = _S67;
    var _S68 : bool = _S65 < _S67;
    run_0.near_start_0 = _S68;
    var _S69 : i32 = select(_S66, _S64 - _S61, _S68);
    var _S70 : i32 = select(_S66 + _S62, _S64, _S68);
    run_0.bend_1 = bend_of_0(own_0, thread_7);
    run_0.distance_0 = select(min(_S65, _S67), 1.0e+06f, _S63);
    run_0.reach_0 = min(0.5f * (_S65 + _S67), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_2, _S69, _S70), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S59 == i32(0);
    run_0.last_crossing_0 = _S60 == i32(0);
    return run_0;
}

struct Section_0
{
     across_3 : f32,
     drop_0 : f32,
     slope_0 : f32,
};

fn section_at_0( cell_5 : Cell_0) -> Section_0
{
    var _S71 : f32 = cell_5.half_width_1 * 1.0154266357421875f;
    var section_0 : Section_0;
    var _S72 : f32 = clamp(cell_5.across_2, - cell_5.half_width_1, cell_5.half_width_1);
    section_0.across_3 = _S72;
    var _S73 : f32 = _S71 * _S71 - square_1(_S72);
    var _S74 : f32 = rsqrt_0(_S73);
    section_0.drop_0 = _S71 - _S73 * _S74;
    section_0.slope_0 = - _S72 * _S74;
    return section_0;
}

fn edge_drop_0( family_7 : u32,  thread_8 : u32,  step_1 : i32) -> f32
{
    return table_number_0(families_0[family_7].bend_table_0 + select(u32(turns_and_remainder_0(family_7, f32(i32(thread_8) + step_1)).y) * u32(4), u32(0), (families_0[family_7].is_alike_0) != u32(0)) + u32(3));
}

fn dive_0( other_1 : u32,  shown_1 : Shown_0,  run_1 : Run_0,  crossed_1 : Cell_0) -> vec2<f32>
{
    var _S75 : bool = (crossed_1.below_0) < (crossed_1.above_0);
    var _S76 : f32 = min(crossed_1.below_0, crossed_1.above_0);
    var _S77 : f32 = select(crossed_1.above_0 + crossed_1.across_2, crossed_1.below_0 - crossed_1.across_2, _S75) - crossed_1.half_width_1;
    var _S78 : bool = select(run_1.last_crossing_0, run_1.first_crossing_0, _S75);
    var _S79 : f32;
    if(shown_1.on_top_0)
    {
        _S79 = 0.0f;
    }
    else
    {
        _S79 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_2, i32(0));
    }
    var _S80 : f32;
    if((shown_1.on_top_0) != _S78)
    {
        _S80 = 0.0f;
    }
    else
    {
        _S80 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_2, select(i32(1), i32(-1), _S75));
    }
    var _S81 : f32 = 1.0f / max(2.0f * _S77, 9.999999960041972e-13f);
    var _S82 : f32 = clamp((_S77 - _S76) * _S81, 0.0f, 1.0f);
    return vec2<f32>(_S79 + (_S80 - _S79) * (_S82 * _S82 * (3.0f - 2.0f * _S82)), (_S79 - _S80) * (6.0f * _S82 * (1.0f - _S82) * _S81) * select(-1.0f, 1.0f, _S75));
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
    var _S83 : f32 = direction_2.x;
    control_0.per_x_0 = 1.0f / max(abs(_S83), 9.99999971718068537e-10f);
    var _S84 : f32 = direction_2.y;
    control_0.per_y_0 = 1.0f / max(abs(_S84), 9.99999971718068537e-10f);
    control_0.right_0 = _S83 > 0.0f;
    control_0.up_0 = _S84 > 0.0f;
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

fn outline_distance_0( cell_6 : Cell_0,  shown_2 : Shown_0,  run_2 : Run_0,  lengthwise_0 : bool,  forwards_0 : bool) -> f32
{
    var _S85 : f32 = select(- cell_6.across_2, cell_6.across_2, forwards_0);
    var _S86 : f32 = select(cell_6.below_0, cell_6.above_0, forwards_0);
    var _S87 : f32 = - cell_6.half_width_1;
    var _S88 : bool = _S85 < _S87;
    var _S89 : bool = _S85 >= (cell_6.half_width_1);
    var _S90 : bool = (((lengthwise_0 & ((!select(run_2.first_crossing_0, run_2.last_crossing_0, forwards_0))))) & ((!shown_2.hole_3)));
    var _S91 : f32 = select(cell_6.half_width_1, _S87, _S88) - _S85;
    var _S92 : f32 = select(_S86, 2.0f * _S86 + _S85 - cell_6.half_width_1, ((shown_2.hole_3) | (((_S90 & ((!shown_2.on_top_0)))))));
    if((((_S90 & ((shown_2.on_top_0)))) & ((!((select(run_2.last_crossing_0, run_2.first_crossing_0, forwards_0) & (_S88)))))))
    {
        return select(run_2.from_start_0, run_2.to_end_0, forwards_0);
    }
    return select(_S91, _S92, _S89);
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
    var _S93 : f32 = previous_1.rate_0 * step_4;
    var _S94 : f32 = rate_1 * step_4;
    if(((((((((!previous_1.known_0) | ((here_0.hole_4)))) | (((previous_1.yarn_0) != (here_0.yarn_1))))) | (((previous_1.rate_0) >= 0.0f)))) | ((rate_1 <= 0.0f))))
    {
        return -1.0f;
    }
    if((((3.0f * previous_1.clearance_0 + _S93) >= 0.0f) & (((3.0f * clearance_1 - _S94) >= 0.0f))))
    {
        return -1.0f;
    }
    var _S95 : f32 = clearance_1 - previous_1.clearance_0;
    var _S96 : f32 = 6.0f * _S95 - 4.0f * _S93 - 2.0f * _S94;
    var _S97 : f32 = -2.0f * _S93 / max(_S96 + sqrt(max(_S96 * _S96 - 4.0f * (3.0f * (_S93 + _S94 - 2.0f * _S95)) * _S93, 0.0f)), 9.99999968265522539e-21f);
    var _S98 : f32 = 1.0f - _S97;
    return select(-1.0f, _S98 * step_4, ((((_S97 > 0.01999999955296516f) & ((_S98 > 0.01999999955296516f)))) & ((((previous_1.clearance_0 * (2.0f * _S97 + 1.0f) + _S93 * _S97) * _S98 * _S98 + (clearance_1 * (2.0f * _S98 + 1.0f) - _S94 * _S98) * _S97 * _S97) < 0.0f))));
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
    var _S99 : f32 = min(here_2.edge_x_0 * this_2.per_x_0, here_2.edge_y_0 * this_2.per_y_0);
    return min(this_2.step_2, select(max(_S99, 0.0f) + this_2.epsilon_0, _S99 - this_2.epsilon_0, ((((!here_2.hole_4) & (((rate_3 * _S99 + clearance_3) < 0.0f)))) & ((_S99 > (2.0f * this_2.epsilon_0))))));
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
    var _S100 : f32 = end_0 - start_1;
    var _S101 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S100;
    var _S102 : f32 = 3.0f * _S100 - 2.0f * start_rate_0 - end_rate_0;
    var share_1 : f32 = start_1 / max(- _S100, 9.99999968265522539e-21f);
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
        var _S103 : f32 = clamp(share_1 - (((_S101 * share_1 + _S102) * share_1 + start_rate_0) * share_1 + start_1) / min((3.0f * _S101 * share_1 + 2.0f * _S102) * share_1 + start_rate_0, 0.10000000149011612f * _S100 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S104 : i32 = i_0 + i32(1);
        share_1 = _S103;
        i_0 = _S104;
    }
    return share_1;
}

fn between_0( above_1 : f32,  under_0 : f32,  above_gap_0 : f32,  under_gap_0 : f32) -> f32
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

fn fibre_direction_0( across_slope_0 : f32,  along_slope_0 : f32,  sine_1 : f32,  cosine_0 : f32) -> vec2<f32>
{
    var _S105 : f32 = along_slope_0 * along_slope_0 + 1.0f;
    var _S106 : f32 = rsqrt_0(_S105);
    var _S107 : f32 = sine_1 * _S106 * rsqrt_0(_S105 + across_slope_0 * across_slope_0);
    return vec2<f32>(- _S107 * _S105, _S107 * across_slope_0 * along_slope_0 + cosine_0 * _S106);
}

fn arc_sine_0( x_8 : f32) -> f32
{
    var _S108 : f32 = abs(x_8);
    var _S109 : bool = _S108 > 0.5f;
    var _S110 : f32 = select(_S108 * _S108, 0.5f * (1.0f - _S108), _S109);
    var _S111 : f32 = select(_S108, sqrt(max(_S110, 0.0f)), _S109);
    var _S112 : f32 = ((((0.04216320067644119f * _S110 + 0.02418131195008755f) * _S110 + 0.04547002539038658f) * _S110 + 0.07495300471782684f) * _S110 + 0.16666752099990845f) * _S110 * _S111 + _S111;
    var _S113 : f32 = select(_S112, 1.57079637050628662f - 2.0f * _S112, _S109);
    return select(_S113, - _S113, x_8 < 0.0f);
}

struct Hair_0
{
     cover_0 : f32,
     normal_3 : vec3<f32>,
     tangent_2 : vec3<f32>,
};

fn Hair_x24init_0( cover_1 : f32,  normal_4 : vec3<f32>,  tangent_3 : vec3<f32>) -> Hair_0
{
    var _S114 : Hair_0;
    _S114.cover_0 = cover_1;
    _S114.normal_3 = normal_4;
    _S114.tangent_2 = tangent_3;
    return _S114;
}

fn fade_0( size_1 : f32,  period_1 : f32) -> f32
{
    return clamp((1.0f - size_1 / period_1) * 1.33333337306976318f, 0.0f, 1.0f);
}

fn share_of_0( bits_0 : u32) -> f32
{
    return (f32((bits_0 & (u32(1023)))) + 0.5f) * 0.0009765625f;
}

fn table_colour_0( index_6 : u32) -> vec3<f32>
{
    return vec3<f32>(table_number_0(index_6), table_number_0(index_6 + u32(1)), table_number_0(index_6 + u32(2)));
}

struct Albedos_0
{
     diffuse_reflect_0 : vec3<f32>,
     diffuse_transmit_0 : vec3<f32>,
     specular_reflect_0 : vec3<f32>,
     specular_transmit_0 : vec3<f32>,
};

fn table_albedos_0( row_0 : u32) -> Albedos_0
{
    var albedos_0 : Albedos_0;
    albedos_0.diffuse_reflect_0 = table_colour_0(row_0);
    albedos_0.diffuse_transmit_0 = table_colour_0(row_0 + u32(3));
    albedos_0.specular_reflect_0 = table_colour_0(row_0 + u32(6));
    albedos_0.specular_transmit_0 = table_colour_0(row_0 + u32(9));
    return albedos_0;
}

fn albedos_of_0( family_8 : u32,  thread_9 : u32) -> Albedos_0
{
    return table_albedos_0(families_0[family_8].albedo_table_0 + families_0[family_8].albedo_stride_0 * thread_9);
}

fn fibre_cell_0( across_4 : f32,  along_0 : f32,  width_2 : f32) -> vec3<f32>
{
    var _S115 : f32 = floor(across_4 / width_2);
    return vec3<f32>(_S115, along_0 / (width_2 * 40.0f) + 0.61799997091293335f * _S115, 2.0f * (across_4 / width_2 - _S115) - 1.0f);
}

fn ply_offset_0( family_9 : u32,  point_1 : SurfacePoint_0,  back_4 : bool) -> f32
{
    var _S116 : f32 = (point_1.fibre_across_0 * families_0[family_9].ply_cosine_0 + point_1.fibre_along_0 * select(families_0[family_9].ply_sine_0, - families_0[family_9].ply_sine_0, back_4)) * families_0[family_9].plies_per_mm_0;
    return 2.0f * (_S116 - floor(_S116)) - 1.0f;
}

fn signed_noise_0( bits_1 : u32) -> f32
{
    return (f32((bits_1 & (u32(65535)))) + 0.5f) * 0.000030517578125f - 1.0f;
}

fn smooth_share_0( share_2 : f32) -> f32
{
    return share_2 * share_2 * (3.0f - 2.0f * share_2);
}

fn wave_noise_0( key_1 : u32,  position_4 : f32) -> vec2<f32>
{
    var _S117 : f32 = floor(position_4);
    var _S118 : f32 = position_4 - _S117;
    var _S119 : u32 = u32(i32(_S117));
    var _S120 : f32 = signed_noise_0(hash_bits_0(key_1, _S119));
    var _S121 : f32 = signed_noise_0(hash_bits_0(key_1, _S119 + u32(1)));
    return vec2<f32>(mix(_S120, _S121, smooth_share_0(_S118)), 6.0f * _S118 * (1.0f - _S118) * (_S121 - _S120));
}

fn cell_noise_0( key_2 : u32,  cell_7 : vec3<f32>) -> vec2<f32>
{
    var _S122 : f32 = cell_7.y;
    var _S123 : f32 = floor(_S122);
    var _S124 : u32 = u32(i32(cell_7.x)) * u32(65536) + u32(i32(_S123));
    var _S125 : u32 = hash_bits_0(key_2, _S124);
    var _S126 : u32 = hash_bits_0(key_2, _S124 + u32(1));
    return mix(vec2<f32>(signed_noise_0(_S125), signed_noise_0((_S125 >> (u32(16))))), vec2<f32>(signed_noise_0(_S126), signed_noise_0((_S126 >> (u32(16))))), vec2<f32>(smooth_share_0(_S122 - _S123)));
}

fn thread_gain_0( thread_10 : u32,  amount_0 : f32,  seed_1 : u32) -> f32
{
    return amount_0 * (2.0f * uniform_hash_0(thread_10, u32(0), (seed_1 ^ (u32(2135587861)))) - 1.0f) + 1.0f;
}

fn bounded_gain_0( gain_1 : f32,  albedo_1 : vec3<f32>,  room_0 : vec3<f32>) -> f32
{
    var _S127 : vec3<f32> = room_0 / max(albedo_1, vec3<f32>(9.99999997475242708e-07f));
    return min(gain_1, max(min(min(_S127.x, _S127.y), _S127.z), 0.0f));
}

fn flattened_0( largest_0 : f32,  albedo_2 : vec3<f32>,  room_1 : vec3<f32>) -> f32
{
    var _S128 : vec3<f32> = room_1 / max(albedo_2, vec3<f32>(9.99999997475242708e-07f)) - vec3<f32>(1.0f);
    return min(max(min(min(_S128.x, _S128.y), _S128.z), 0.0f) / max(largest_0, 9.99999997475242708e-07f), 1.0f);
}

fn fibre_gain_0( thread_11 : u32,  cell_8 : u32,  amount_1 : f32,  seed_2 : u32) -> f32
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_11, cell_8, (seed_2 ^ (u32(2654435769))))), 10.0f) - 1.0f) + 1.0f;
}

struct YarnFrame_0
{
     normal_5 : vec3<f32>,
     tangent_4 : vec3<f32>,
     loss_0 : f32,
};

fn under_hair_0( frame_0 : YarnFrame_0,  hair_0 : Hair_0) -> YarnFrame_0
{
    var _S129 : vec3<f32> = select_vector_1((dot(frame_0.tangent_4, hair_0.tangent_2)) < 0.0f, (vec3<f32>(0) - hair_0.tangent_2), hair_0.tangent_2);
    var blended_0 : YarnFrame_0;
    var _S130 : vec3<f32> = vec3<f32>(hair_0.cover_0);
    var _S131 : vec3<f32> = normalize(mix(frame_0.normal_5, hair_0.normal_3, _S130));
    blended_0.normal_5 = _S131;
    var _S132 : vec3<f32> = mix(frame_0.tangent_4, _S129, _S130);
    var _S133 : vec3<f32> = _S132 - vec3<f32>(dot(_S132, _S131)) * _S131;
    blended_0.tangent_4 = _S133 * vec3<f32>(rsqrt_0(max(dot(_S133, _S133), 9.999999960041972e-13f)));
    blended_0.loss_0 = frame_0.loss_0 * (1.0f - hair_0.cover_0);
    return blended_0;
}

fn diffuse_gain_0( frame_1 : YarnFrame_0,  blend_0 : f32) -> f32
{
    return min(0.85000002384185791f * blend_0 * frame_1.loss_0 + 1.0f, 1.0f / (0.5f * blend_0 * (frame_1.normal_5.z - 1.0f) + 1.0f));
}

fn diffuse_reflection_0( light_1 : vec3<f32>,  normal_6 : vec3<f32>,  blend_1 : f32) -> f32
{
    var _S134 : f32 = light_1.z;
    if(_S134 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S134, 0.0f), max(dot(light_1, normal_6), 0.0f), blend_1);
}

fn projected_area_1( direction_3 : vec3<f32>,  tangent_5 : vec3<f32>,  roughness_1 : f32) -> f32
{
    var _S135 : f32 = dot(direction_3, tangent_5);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S135 * _S135 + 1.0f, roughness_1 * roughness_1));
}

fn mean_attenuation_0( depth_0 : f32) -> f32
{
    if(depth_0 < 0.10000000149011612f)
    {
        return (((depth_0 / 120.0f - 0.0416666679084301f) * depth_0 + 0.1666666716337204f) * depth_0 - 0.5f) * depth_0 + 1.0f;
    }
    return (1.0f - exponential_0(- depth_0)) / depth_0;
}

fn flake_density_0( squared_along_0 : f32,  roughness_2 : f32) -> f32
{
    var _S136 : f32 = roughness_2 * roughness_2;
    var _S137 : f32 = squared_along_0 * (1.0f - _S136) + _S136;
    return 0.31830987334251404f * _S136 * roughness_2 / (_S137 * _S137);
}

fn density_between_0( light_2 : vec3<f32>,  view_1 : vec3<f32>,  tangent_6 : vec3<f32>,  roughness_3 : f32) -> f32
{
    var _S138 : vec3<f32> = light_2 + view_1;
    var _S139 : f32 = dot(_S138, tangent_6);
    return flake_density_0(min(_S139 * _S139 / max(square_0(_S138), 9.999999960041972e-13f), 1.0f), roughness_3);
}

fn transmission_1( light_3 : vec3<f32>,  view_2 : vec3<f32>,  normal_7 : vec3<f32>,  tangent_7 : vec3<f32>,  roughness_4 : f32,  optical_depth_1 : f32) -> f32
{
    var _S140 : f32 = - dot(light_3, normal_7);
    var _S141 : f32 = dot(view_2, normal_7);
    if(((_S140 <= 0.0f) | ((_S141 <= 0.0f))))
    {
        return 0.0f;
    }
    var _S142 : f32 = 1.0f / max(_S141, 9.99999997475242708e-07f);
    var _S143 : f32 = projected_area_1(light_3, tangent_7, roughness_4) / max(_S140, 9.99999997475242708e-07f);
    var _S144 : f32 = projected_area_1(view_2, tangent_7, roughness_4) * _S142;
    return density_between_0(light_3, view_2, tangent_7, roughness_4) * 0.25f * optical_depth_1 * exponential_0(- optical_depth_1 * min(_S143, _S144)) * mean_attenuation_0(optical_depth_1 * abs(_S143 - _S144)) * _S142;
}

fn reflection_0( light_4 : vec3<f32>,  view_3 : vec3<f32>,  normal_8 : vec3<f32>,  tangent_8 : vec3<f32>,  roughness_5 : f32,  optical_depth_2 : f32) -> f32
{
    var _S145 : f32 = dot(light_4, normal_8);
    var _S146 : f32 = dot(view_3, normal_8);
    if(((_S145 <= 0.0f) | ((_S146 <= 0.0f))))
    {
        return 0.0f;
    }
    var _S147 : f32 = max(_S145, 9.99999997475242708e-07f);
    var _S148 : f32 = max(_S146, 9.99999997475242708e-07f);
    var _S149 : f32 = projected_area_1(light_4, tangent_8, roughness_5) * _S148 + projected_area_1(view_3, tangent_8, roughness_5) * _S147;
    var _S150 : f32 = optical_depth_2 * _S149 / (_S147 * _S148);
    return 0.25f * density_between_0(light_4, view_3, tangent_8, roughness_5) * (_S150 * mean_attenuation_0(_S150)) * _S147 / _S149;
}

fn with_added_0( sums_1 : Components_0,  more_0 : Components_0,  weight_1 : f32) -> Components_0
{
    var result_0 : Components_0;
    result_0.diffuse_warp_0 = sums_1.diffuse_warp_0 + weight_1 * more_0.diffuse_warp_0;
    result_0.diffuse_weft_0 = sums_1.diffuse_weft_0 + weight_1 * more_0.diffuse_weft_0;
    result_0.specular_warp_0 = sums_1.specular_warp_0 + weight_1 * more_0.specular_warp_0;
    result_0.specular_weft_0 = sums_1.specular_weft_0 + weight_1 * more_0.specular_weft_0;
    result_0.light_visibility_1 = sums_1.light_visibility_1 + weight_1 * more_0.light_visibility_1;
    result_0.hole_2 = sums_1.hole_2 + weight_1 * more_0.hole_2;
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

fn wrapped_cell_0( position_5 : f32,  count_2 : f32) -> f32
{
    return min(floor((position_5 - floor(position_5)) * count_2), count_2 - 1.0f);
}

fn arc_tangent_quotient_0( x_9 : f32,  y_2 : f32) -> f32
{
    return ((((((0.0f * x_9 + 0.00809729471802711f) * x_9 + -0.0377517081797123f) * x_9 + 0.08475969731807709f) * x_9 + -0.13537675142288208f) * x_9 + 0.19895026087760925f) * x_9 + -0.33327975869178772f) * x_9 + 0.99999970197677612f;
}

fn arc_tangent_of_ratio_0( ratio_0 : f32) -> f32
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0f);
}

fn arc_tangent_0( y_3 : f32,  x_10 : f32) -> f32
{
    var _S151 : f32 = abs(x_10);
    var _S152 : f32 = abs(y_3);
    var angle_0 : f32 = arc_tangent_of_ratio_0(min(_S151, _S152) / max(max(_S151, _S152), 1.00000000317107685e-30f));
    var angle_1 : f32 = select(angle_0, 1.57079637050628662f - angle_0, _S152 > _S151);
    var angle_2 : f32 = select(angle_1, 3.14159274101257324f - angle_1, x_10 < 0.0f);
    return select(angle_2, - angle_2, y_3 < 0.0f);
}

struct NodeTaps_0
{
     nodes_0 : vec4<u32>,
     weights_0 : vec4<u32>,
     inverse_sum_0 : f32,
};

fn node_taps_of_0( direction_4 : vec3<f32>,  azimuths_0 : u32) -> NodeTaps_0
{
    var _S153 : f32 = arc_tangent_0(direction_4.y, direction_4.x) * (0.5f * f32(azimuths_0) * 0.31830987334251404f);
    var _S154 : f32 = floor(_S153);
    var _S155 : f32 = _S153 - _S154;
    var _S156 : f32 = sqrt(clamp((1.0f - abs(direction_4.z)) / 0.97000002861022949f, 0.0f, 1.0f));
    var _S157 : f32 = 7.0f * _S156 * sqrt(_S156);
    var _S158 : f32 = min(floor(_S157), 6.0f);
    var _S159 : f32 = _S157 - _S158;
    var _S160 : u32 = u32(i32(_S154) + i32(azimuths_0)) % azimuths_0;
    var _S161 : u32 = u32(_S158);
    var _S162 : u32 = _S160 * u32(8) + _S161;
    var _S163 : u32 = (_S160 + u32(1)) % azimuths_0;
    var _S164 : u32 = _S163 * u32(8) + _S161;
    var taps_0 : NodeTaps_0;
    taps_0.nodes_0 = vec4<u32>(_S162, _S162 + u32(1), _S164, _S164 + u32(1));
    var _S165 : f32 = 1.0f - _S155;
    var _S166 : f32 = 1.0f - _S159;
    var _S167 : vec4<u32> = vec4<u32>(vec4<f32>(_S165 * _S166, _S165 * _S159, _S155 * _S166, _S155 * _S159) * vec4<f32>(252.0f) + vec4<f32>(0.5f));
    taps_0.weights_0 = _S167;
    taps_0.inverse_sum_0 = 1.0f / f32(_S167.x + _S167.y + _S167.z + _S167.w);
    return taps_0;
}

fn node_taps_0( direction_5 : vec3<f32>) -> NodeTaps_0
{
    var _S168 : NodeTaps_0 = node_taps_of_0(direction_5, u32(32));
    return _S168;
}

fn half_vector_0( light_5 : vec3<f32>,  view_4 : vec3<f32>) -> vec3<f32>
{
    var _S169 : vec3<f32> = light_5 + view_4;
    return _S169 * vec3<f32>(rsqrt_0(max(square_0(_S169), 9.999999960041972e-13f)));
}

fn joint_terms_0( taps_1 : NodeTaps_0,  table_1 : u32,  ratio_1 : u32) -> vec4<f32>
{
    var _S170 : vec4<f32> = vec4<f32>(0.0f);
    var i_1 : u32 = u32(0);
    var sums_2 : vec4<f32> = _S170;
    for(;;)
    {
        if(i_1 < u32(4))
        {
        }
        else
        {
            break;
        }
        var _S171 : u32 = table_1 + u32(4) * taps_1.nodes_0[i_1] + u32(2) * ratio_1;
        var _S172 : vec2<u32> = vec2<u32>(words_0[_S171], words_0[_S171 + u32(1)]);
        var sums_3 : vec4<f32> = sums_2 + vec4<f32>(((vec4<i32>(vec2<i32>((_S172 << (vec2<u32>(u32(16))))), vec2<i32>(_S172)).xzyw) >> (vec4<u32>(u32(16))))) * vec4<f32>(f32(taps_1.weights_0[i_1]));
        i_1 = i_1 + u32(1);
        sums_2 = sums_3;
    }
    return sums_2 * vec4<f32>((taps_1.inverse_sum_0 / 4096.0f));
}

fn bytes_of_sums_0( even_0 : u32,  odd_0 : u32) -> vec4<f32>
{
    return vec4<f32>(f32((even_0 & (u32(65535)))), f32((odd_0 & (u32(65535)))), f32((even_0 >> (u32(16)))), f32((odd_0 >> (u32(16)))));
}

fn interpolate_0( taps_2 : NodeTaps_0,  packs_1 : vec4<u32>) -> vec4<f32>
{
    var _S173 : vec4<u32> = vec4<u32>(u32(16711935));
    var _S174 : vec4<u32> = ((packs_1 & (_S173))) * taps_2.weights_0;
    var _S175 : vec4<u32> = ((((packs_1 >> (vec4<u32>(u32(8))))) & (_S173))) * taps_2.weights_0;
    return bytes_of_sums_0(_S174.x + _S174.y + _S174.z + _S174.w, _S175.x + _S175.y + _S175.z + _S175.w) * vec4<f32>(taps_2.inverse_sum_0);
}

fn interpolate_table_0( taps_3 : NodeTaps_0,  table_2 : u32,  stride_0 : u32) -> vec4<f32>
{
    var _S176 : vec4<u32> = vec4<u32>(table_2) + taps_3.nodes_0 * vec4<u32>(stride_0);
    return interpolate_0(taps_3, vec4<u32>(words_0[_S176.x], words_0[_S176.y], words_0[_S176.z], words_0[_S176.w]));
}

struct Group_0
{
     normal_9 : vec3<f32>,
     weight_2 : f32,
     tangent_9 : vec3<f32>,
     variance_0 : vec3<f32>,
     covariance_0 : vec3<f32>,
     roughness_6 : f32,
};

fn group_at_0( row_1 : u32,  roughness_7 : f32) -> Group_0
{
    var group_0 : Group_0;
    group_0.normal_9 = vec3<f32>(table_number_0(row_1), table_number_0(row_1 + u32(1)), table_number_0(row_1 + u32(2)));
    group_0.weight_2 = table_number_0(row_1 + u32(3));
    var _S177 : vec3<f32> = vec3<f32>(table_number_0(row_1 + u32(4)), table_number_0(row_1 + u32(5)), table_number_0(row_1 + u32(6)));
    group_0.tangent_9 = _S177;
    var _S178 : f32 = table_number_0(row_1 + u32(7));
    var _S179 : f32 = table_number_0(row_1 + u32(8));
    group_0.variance_0 = vec3<f32>(_S178, _S179, 1.0f - square_0(_S177) - _S178 - _S179);
    group_0.covariance_0 = vec3<f32>(table_number_0(row_1 + u32(9)), table_number_0(row_1 + u32(10)), table_number_0(row_1 + u32(11)));
    group_0.roughness_6 = roughness_7;
    return group_0;
}

fn Group_variance_along_0( this_5 : Group_0,  direction_6 : vec3<f32>) -> f32
{
    var _S180 : f32 = direction_6.x;
    var _S181 : f32 = direction_6.y;
    var _S182 : f32 = direction_6.z;
    return max(dot(this_5.variance_0, direction_6 * direction_6) + 2.0f * dot(this_5.covariance_0, vec3<f32>(_S180 * _S181, _S180 * _S182, _S181 * _S182)), 0.0f);
}

fn mean_area_0( group_1 : Group_0,  direction_7 : vec3<f32>) -> f32
{
    var _S183 : f32 = dot(direction_7, group_1.tangent_9);
    var _S184 : f32 = group_1.roughness_6;
    var _S185 : f32 = _S184 * _S184;
    return sqrt(max((_S185 - 1.0f) * (_S183 * _S183 + Group_variance_along_0(group_1, direction_7)) + 1.0f, _S185));
}

fn mean_density_0( group_2 : Group_0,  half_0 : vec3<f32>) -> f32
{
    var _S186 : f32 = group_2.roughness_6;
    var _S187 : f32 = max(sqrt(max(1.0f - _S186 * _S186, 0.0f)) / group_2.roughness_6, 0.00100000004749745f);
    var _S188 : f32 = max(sqrt(3.0f * Group_variance_along_0(group_2, half_0)), group_2.roughness_6 * 0.01999999955296516f + 0.00009999999747379f);
    var _S189 : f32 = dot(half_0, group_2.tangent_9);
    var _S190 : f32 = _S187 * (_S189 - _S188);
    var _S191 : f32 = _S187 * (_S189 + _S188);
    var _S192 : f32 = _S190 * _S191;
    var _S193 : f32 = 2.0f * _S188 * _S187;
    return 0.15915493667125702f / group_2.roughness_6 * ((1.0f - _S192) / ((_S190 * _S190 + 1.0f) * (_S191 * _S191 + 1.0f)) + arc_tangent_0(_S193, 1.0f + _S192) / _S193);
}

fn layer_value_0( group_3 : Group_0,  half_1 : vec3<f32>,  light_6 : vec3<f32>,  view_5 : vec3<f32>,  optical_depth_3 : f32) -> f32
{
    var _S194 : bool = (light_6.z) < 0.0f;
    var _S195 : f32 = dot(light_6, group_3.normal_9);
    var _S196 : f32 = max(dot(view_5, group_3.normal_9), 0.01999999955296516f);
    var _S197 : f32 = mean_area_0(group_3, light_6) / max(select(_S195, - _S195, _S194), 0.01999999955296516f);
    var _S198 : f32 = mean_area_0(group_3, view_5) / _S196;
    var _S199 : f32 = optical_depth_3 * max(select(_S197 + _S198, abs(_S197 - _S198), _S194), 0.00100000004749745f);
    return 0.25f * mean_density_0(group_3, half_1) * select(1.0f - 0.34999999403953552f * (1.0f - square_0(group_3.normal_9)), 1.0f, _S194) * (optical_depth_3 * select(1.0f, exponential_0(- optical_depth_3 * min(_S197, _S198)), _S194) * (1.0f - exponential_0(- _S199)) / _S199 / _S196);
}

struct Bound_0
{
     thread_12 : u32,
     turns_2 : f32,
     cell_9 : f32,
     visible_0 : f32,
     width_3 : f32,
     gap_0 : f32,
};

fn bound_at_0( family_10 : u32,  position_6 : f32) -> Bound_0
{
    var _S200 : Cell_0 = locate_0(family_10, position_6);
    var _S201 : f32 = table_number_0(families_0[family_10].before_0 + u32(2) * _S200.thread_2 + u32(1));
    var bound_0 : Bound_0;
    bound_0.thread_12 = _S200.thread_2;
    bound_0.turns_2 = round((position_6 - families_0[family_10].start_0 - _S201 - _S200.below_0) * families_0[family_10].inverse_period_0);
    bound_0.cell_9 = _S200.below_0;
    var _S202 : f32 = 2.0f * _S200.half_width_1;
    bound_0.width_3 = _S202;
    bound_0.visible_0 = clamp((_S200.across_2 + _S200.half_width_1) / _S202, 0.0f, 1.0f);
    bound_0.gap_0 = min(_S200.below_0, _S200.below_0 - _S200.across_2 - _S200.half_width_1) + max(_S200.across_2 - _S200.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
     low_1 : Bound_0,
     high_1 : Bound_0,
};

fn stretch_of_0( family_11 : u32,  centre_1 : f32,  size_2 : f32) -> Stretch_0
{
    var _S203 : f32 = centre_1 - floor((centre_1 - families_0[family_11].start_0) * families_0[family_11].inverse_period_0) * families_0[family_11].period_0;
    var _S204 : f32 = 0.5f * max(size_2, families_0[family_11].smallest_box_0);
    var stretch_0 : Stretch_0;
    stretch_0.low_1 = bound_at_0(family_11, _S203 - _S204);
    stretch_0.high_1 = bound_at_0(family_11, _S203 + _S204);
    return stretch_0;
}

fn Stretch_turns_0( this_6 : Stretch_0) -> f32
{
    return this_6.high_1.turns_2 - this_6.low_1.turns_2;
}

fn lengths_0( family_12 : u32,  stretch_1 : Stretch_0) -> vec3<f32>
{
    var _S205 : f32 = Stretch_turns_0(stretch_1);
    var _S206 : u32 = families_0[family_12].before_0 + u32(2) * stretch_1.low_1.thread_12;
    var _S207 : u32 = families_0[family_12].before_0 + u32(2) * stretch_1.high_1.thread_12;
    var _S208 : f32 = table_number_0(_S207) - table_number_0(_S206);
    var _S209 : f32 = table_number_0(_S207 + u32(1)) - table_number_0(_S206 + u32(1));
    return vec3<f32>(_S208 + stretch_1.high_1.visible_0 * stretch_1.high_1.width_3 - stretch_1.low_1.visible_0 * stretch_1.low_1.width_3 + _S205 * families_0[family_12].visible_total_0, _S209 - _S208 + stretch_1.high_1.gap_0 - stretch_1.low_1.gap_0 + _S205 * (families_0[family_12].period_0 - families_0[family_12].visible_total_0), _S209 + stretch_1.high_1.cell_9 - stretch_1.low_1.cell_9 + _S205 * families_0[family_12].period_0);
}

fn integrals_along_0( family_13 : u32,  stretch_2 : Stretch_0,  quantity_0 : u32) -> vec2<f32>
{
    var _S210 : u32 = u32(3) * families_0[family_13].quantities_0;
    var _S211 : u32 = families_0[family_13].colour_threads_0 + _S210 * stretch_2.low_1.thread_12 + quantity_0;
    var _S212 : u32 = families_0[family_13].colour_threads_0 + _S210 * stretch_2.high_1.thread_12 + quantity_0;
    var _S213 : u32 = families_0[family_13].colour_threads_0 + _S210 * u32(families_0[family_13].count_0) + quantity_0;
    var _S214 : f32 = table_number_0(_S211);
    var _S215 : f32 = table_number_0(_S212);
    var _S216 : f32 = Stretch_turns_0(stretch_2);
    var _S217 : u32 = u32(2) * families_0[family_13].quantities_0;
    return vec2<f32>(table_number_0(_S212 + families_0[family_13].quantities_0) - table_number_0(_S211 + families_0[family_13].quantities_0) + _S215 * stretch_2.high_1.visible_0 * stretch_2.high_1.width_3 - _S214 * stretch_2.low_1.visible_0 * stretch_2.low_1.width_3 + _S216 * table_number_0(_S213 + families_0[family_13].quantities_0), table_number_0(_S212 + _S217) - table_number_0(_S211 + _S217) + _S215 * stretch_2.high_1.cell_9 - _S214 * stretch_2.low_1.cell_9 + _S216 * table_number_0(_S213 + _S217));
}

fn Stretch_wraps_0( this_7 : Stretch_0) -> bool
{
    return (this_7.high_1.thread_12) < (this_7.low_1.thread_12);
}

fn Stretch_differences_0( this_8 : Stretch_0,  entries_0 : vec4<u32>,  whole_0 : u32) -> vec4<u32>
{
    var _S218 : u32 = entries_0.z;
    var _S219 : u32 = entries_0.x;
    return vec4<u32>(_S218 - _S219 + select(u32(0), whole_0, Stretch_wraps_0(this_8)), entries_0.w - _S218, entries_0.y - _S219, whole_0);
}

fn row_differences_0( across_5 : Stretch_0,  row_2 : u32,  count_3 : u32,  quantities_1 : u32) -> vec4<u32>
{
    var _S220 : u32 = row_2 + across_5.low_1.thread_12 * quantities_1;
    var _S221 : u32 = row_2 + across_5.high_1.thread_12 * quantities_1;
    return Stretch_differences_0(across_5, vec4<u32>(words_0[_S220], words_0[_S220 + quantities_1], words_0[_S221], words_0[_S221 + quantities_1]), words_0[row_2 + count_3 * quantities_1]);
}

fn Stretch_weights_0( this_9 : Stretch_0) -> vec4<f32>
{
    return vec4<f32>(1.0f, this_9.high_1.visible_0, - this_9.low_1.visible_0, Stretch_turns_0(this_9) - select(0.0f, 1.0f, Stretch_wraps_0(this_9)));
}

fn integral_on_top_0( family_14 : u32,  across_6 : Stretch_0,  along_1 : Stretch_0,  crossing_count_0 : u32,  quantity_1 : u32) -> f32
{
    var _S222 : u32 = u32(families_0[family_14].count_0);
    var _S223 : u32 = (_S222 + u32(1)) * families_0[family_14].quantities_0;
    var _S224 : u32 = families_0[family_14].colour_areas_0 + quantity_1;
    var _S225 : vec4<u32> = row_differences_0(across_6, _S224 + along_1.low_1.thread_12 * _S223, _S222, families_0[family_14].quantities_0);
    var _S226 : vec4<u32> = row_differences_0(across_6, _S224 + along_1.high_1.thread_12 * _S223, _S222, families_0[family_14].quantities_0);
    var _S227 : vec4<u32> = row_differences_0(across_6, _S224 + crossing_count_0 * _S223, _S222, families_0[family_14].quantities_0);
    var _S228 : vec4<f32> = Stretch_weights_0(across_6);
    return dot(vec4<f32>(dot(vec4<f32>(vec4<i32>(_S226 - _S225 + select_vector_2(Stretch_wraps_0(along_1), _S227, vec4<u32>(vec4<i32>(i32(0)))))), _S228), dot(vec4<f32>(vec4<i32>(row_differences_0(across_6, _S224 + (along_1.high_1.thread_12 + u32(1)) * _S223, _S222, families_0[family_14].quantities_0) - _S226)), _S228), dot(vec4<f32>(vec4<i32>(row_differences_0(across_6, _S224 + (along_1.low_1.thread_12 + u32(1)) * _S223, _S222, families_0[family_14].quantities_0) - _S225)), _S228), dot(vec4<f32>(vec4<i32>(_S227)), _S228)), Stretch_weights_0(along_1)) * families_0[family_14].area_unit_0;
}

fn with_added_albedos_0( albedos_1 : Albedos_0,  weight_3 : f32,  row_3 : u32) -> Albedos_0
{
    var _S229 : Albedos_0 = table_albedos_0(row_3);
    var sum_0 : Albedos_0;
    var _S230 : vec3<f32> = vec3<f32>(weight_3);
    sum_0.diffuse_reflect_0 = albedos_1.diffuse_reflect_0 + _S230 * _S229.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_1.diffuse_transmit_0 + _S230 * _S229.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_1.specular_reflect_0 + _S230 * _S229.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_1.specular_transmit_0 + _S230 * _S229.specular_transmit_0;
    return sum_0;
}

fn mean_albedos_0( family_15 : u32,  crossing_1 : u32,  own_1 : Stretch_0,  other_2 : Stretch_0,  back_5 : bool) -> Albedos_0
{
    var albedos_2 : Albedos_0 = table_albedos_0(families_0[family_15].colour_mean_0);
    if((families_0[family_15].quantities_0) == u32(1))
    {
        return albedos_2;
    }
    var _S231 : vec3<f32> = lengths_0(crossing_1, other_2);
    var is_exposed_0 : bool = false;
    var weight_4 : f32 = 0.0f;
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
        var _S232 : vec2<f32> = integrals_along_0(family_15, own_1, quantity_2);
        var _S233 : f32 = integral_on_top_0(family_15, own_1, other_2, u32(families_0[crossing_1].count_0), quantity_2);
        var _S234 : f32 = _S232.x;
        var _S235 : f32 = _S234 * _S231.x;
        var _S236 : f32 = select(_S233, _S235 - _S233, back_5);
        var _S237 : bool = quantity_2 == u32(0);
        if(_S237)
        {
            is_exposed_0 = _S236 > (16.0f * families_0[family_15].area_unit_0 * min(_S235 / families_0[family_15].crossing_area_0, 1.0f) + 0.00000999999974738f * _S235);
        }
        var _S238 : f32 = _S234 * _S231.y + select(0.0f, _S236, is_exposed_0) + 0.000244140625f * _S231.z * _S232.y;
        if(_S237)
        {
            weight_4 = 1.0f / max(_S238, 9.99999968265522539e-21f);
        }
        else
        {
            albedos_2 = with_added_albedos_0(albedos_2, _S238 * weight_4, families_0[family_15].colour_axes_0 + u32(12) * (quantity_2 - u32(1)));
        }
        quantity_2 = quantity_2 + u32(1);
    }
    albedos_2.diffuse_reflect_0 = saturate(albedos_2.diffuse_reflect_0);
    albedos_2.diffuse_transmit_0 = saturate(albedos_2.diffuse_transmit_0);
    albedos_2.specular_reflect_0 = saturate(albedos_2.specular_reflect_0);
    albedos_2.specular_transmit_0 = saturate(albedos_2.specular_transmit_0);
    return albedos_2;
}

fn lerp_albedos_0( first_5 : Albedos_0,  second_1 : Albedos_0,  weight_5 : f32) -> Albedos_0
{
    var albedos_3 : Albedos_0;
    var _S239 : vec3<f32> = vec3<f32>(weight_5);
    albedos_3.diffuse_reflect_0 = mix(first_5.diffuse_reflect_0, second_1.diffuse_reflect_0, _S239);
    albedos_3.diffuse_transmit_0 = mix(first_5.diffuse_transmit_0, second_1.diffuse_transmit_0, _S239);
    albedos_3.specular_reflect_0 = mix(first_5.specular_reflect_0, second_1.specular_reflect_0, _S239);
    albedos_3.specular_transmit_0 = mix(first_5.specular_transmit_0, second_1.specular_transmit_0, _S239);
    return albedos_3;
}

fn tinted_0( albedos_4 : Albedos_0,  tint_0 : vec3<f32>) -> Albedos_0
{
    var result_2 : Albedos_0 = albedos_4;
    result_2.diffuse_reflect_0 = result_2.diffuse_reflect_0 * tint_0;
    result_2.diffuse_transmit_0 = result_2.diffuse_transmit_0 * tint_0;
    return result_2;
}

struct FaceRadiance_0
{
     warp_3 : vec3<f32>,
     weft_3 : vec3<f32>,
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
    var _S240 : vec3<f32> = vec3<f32>((1.0f - open_of_other_0)) * passed_0;
    var found_0 : FaceRadiance_0;
    var _S241 : vec3<f32> = sends_0.sky_warp_0 + _S240 * sends_0.crossing_warp_0;
    found_0.warp_3 = _S241;
    var _S242 : vec3<f32> = sends_0.sky_weft_0 + _S240 * sends_0.crossing_weft_0;
    found_0.weft_3 = _S242;
    found_0.mean_1 = vec3<f32>(sends_0.blocks_warp_0) * _S241 + vec3<f32>(sends_0.blocks_weft_0) * _S242;
    found_0.leaked_0 = from_other_0;
    return found_0;
}

fn view_terms_0( view_6 : vec3<f32>,  terms_0 : ptr<function, array<f32, i32(6)>>)
{
    var _S243 : f32 = 1.0f - view_6.z;
    var _S244 : f32 = _S243 * _S243;
    (*terms_0)[i32(0)] = 1.0f;
    var _S245 : f32 = view_6.x;
    var _S246 : f32 = _S245 * _S245;
    var _S247 : f32 = view_6.y;
    var _S248 : f32 = _S247 * _S247;
    (*terms_0)[i32(1)] = sqrt(max(_S246 + _S248, 9.999999960041972e-13f));
    (*terms_0)[i32(2)] = _S244;
    (*terms_0)[i32(3)] = _S244 * _S244;
    (*terms_0)[i32(4)] = _S246 - _S248;
    (*terms_0)[i32(5)] = 0.0f;
    return;
}

fn view_terms_1( view_7 : vec3<f32>,  terms_1 : ptr<function, array<f32, i32(6)>>)
{
    var _S249 : f32 = 1.0f - view_7.z;
    var _S250 : f32 = _S249 * _S249;
    (*terms_1)[i32(0)] = 1.0f;
    var _S251 : f32 = view_7.x;
    var _S252 : f32 = _S251 * _S251;
    var _S253 : f32 = view_7.y;
    var _S254 : f32 = _S253 * _S253;
    (*terms_1)[i32(1)] = sqrt(max(_S252 + _S254, 9.999999960041972e-13f));
    (*terms_1)[i32(2)] = _S250;
    (*terms_1)[i32(3)] = _S250 * _S250;
    (*terms_1)[i32(4)] = _S252 - _S254;
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
     back_6 : vec3<f32>,
     through_0 : vec3<f32>,
};

struct Interior_0
{
     warp_4 : vec3<f32>,
     weft_4 : vec3<f32>,
     leaked_1 : vec3<f32>,
     far_1 : vec3<f32>,
     far_leaked_0 : vec3<f32>,
};

fn bounced_by_0( blocked_1 : Blocked_0,  yarn_2 : Scattered_0,  interior_0 : Interior_0) -> Bounced_0
{
    var _S255 : vec3<f32> = vec3<f32>((blocked_1.by_warp_0 + blocked_1.by_weft_0)) * interior_0.leaked_1;
    var _S256 : vec3<f32> = vec3<f32>(blocked_1.far_0) * yarn_2.through_0;
    var bounced_0 : Bounced_0;
    bounced_0.reflected_0 = yarn_2.back_6 * (vec3<f32>(blocked_1.by_warp_0) * interior_0.warp_4 + vec3<f32>(blocked_1.by_weft_0) * interior_0.weft_4) + _S256 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S256 * interior_0.far_1 + yarn_2.back_6 * _S255;
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
    var _S257 : f32 = light_7.z;
    return select_vector_1((_S257 * view_8.z) < 0.0f, bounced_1.transmitted_0, bounced_1.reflected_0) * vec3<f32>((abs(_S257) * 0.31830987334251404f));
}

fn sheen_scale_0( x_11 : f32,  y_4 : f32) -> f32
{
    return (((((0.0f * x_11 + (((((-1.1402510404586792f * y_4 + 0.40672621130943298f) * y_4 + 1.65398800373077393f) * y_4 + -1.29730904102325439f) * y_4 + 0.30570998787879944f) * y_4 + -0.0220868494361639f)) * x_11 + (((((-0.21142719686031342f * y_4 + 1.05947399139404297f) * y_4 + -0.41116121411323547f) * y_4 + -0.93859231472015381f) * y_4 + 0.51606941223144531f) * y_4 + 0.05409301072359085f)) * x_11 + (((((1.22944498062133789f * y_4 + -0.45962560176849365f) * y_4 + -1.63861405849456787f) * y_4 + 1.33565104007720947f) * y_4 + -0.45725581049919128f) * y_4 + 0.08243165910243988f)) * x_11 + (((((0.39779931306838989f * y_4 + -1.18879103660583496f) * y_4 + 0.28251591324806213f) * y_4 + 1.168984055519104f) * y_4 + -0.76864629983901978f) * y_4 + 0.0091691892594099f)) * x_11 + (((((-0.26563560962677002f * y_4 + -0.19379159808158875f) * y_4 + 0.2677634060382843f) * y_4 + 0.00270519289188087f) * y_4 + 0.14349560439586639f) * y_4 + 0.10290180146694183f)) * x_11 + (((((-0.20701569318771362f * y_4 + 0.24526430666446686f) * y_4 + 0.19551840424537659f) * y_4 + 0.07586126774549484f) * y_4 + 0.38894739747047424f) * y_4 + 0.15043120086193085f);
}

fn sheen_shear_0( x_12 : f32,  y_5 : f32) -> f32
{
    return ((((0.0f * x_12 + (((((-0.10608240216970444f * y_5 + 1.99214303493499756f) * y_5 + -1.42255294322967529f) * y_5 + -1.09495604038238525f) * y_5 + 0.59180057048797607f) * y_5 + 0.06902855634689331f)) * x_12 + (((((-0.46220690011978149f * y_5 + -0.29113379120826721f) * y_5 + 1.39025199413299561f) * y_5 + 0.35589990019798279f) * y_5 + -1.17120099067687988f) * y_5 + 0.15940259397029877f)) * x_12 + (((((2.26068711280822754f * y_5 + -3.64728999137878418f) * y_5 + -0.72173482179641724f) * y_5 + 3.07659196853637695f) * y_5 + -0.6827620267868042f) * y_5 + -0.3039557933807373f)) * x_12 + (((((0.81201767921447754f * y_5 + 0.36014080047607422f) * y_5 + -1.72646903991699219f) * y_5 + -0.22630110383033752f) * y_5 + 0.89514690637588501f) * y_5 + -0.10397960245609283f)) * x_12 + (((((-0.37648698687553406f * y_5 + 1.10974001884460449f) * y_5 + 0.17824520170688629f) * y_5 + -1.04968702793121338f) * y_5 + 0.1461234986782074f) * y_5 + -0.00475129019469023f);
}

fn sheen_reflectance_0( x_13 : f32,  y_6 : f32) -> f32
{
    return ((((0.0f * x_13 + (((((12.95646953582763672f * y_6 + -21.38032913208007812f) * y_6 + -7.37853097915649414f) * y_6 + 34.55607986450195312f) * y_6 + -23.61347007751464844f) * y_6 + 5.00126314163208008f)) * x_13 + (((((10.91487026214599609f * y_6 + -6.08202791213989258f) * y_6 + -38.2036285400390625f) * y_6 + 53.3440399169921875f) * y_6 + -21.91996002197265625f) * y_6 + 2.01606011390686035f)) * x_13 + (((((-14.52206039428710938f * y_6 + 36.803619384765625f) * y_6 + -22.94047927856445312f) * y_6 + -10.07973003387451172f) * y_6 + 15.77003955841064453f) * y_6 + -4.92722177505493164f)) * x_13 + (((((-7.62505722045898438f * y_6 + 1.27310299873352051f) * y_6 + 31.19523048400878906f) * y_6 + -44.39989852905273438f) * y_6 + 26.44947052001953125f) * y_6 + -8.73507976531982422f)) * x_13 + (((((5.65633487701416016f * y_6 + -17.66820907592773438f) * y_6 + 24.65356063842773438f) * y_6 + -19.38941001892089844f) * y_6 + 11.06159019470214844f) * y_6 + -3.06573700904846191f);
}

fn sheen_lobe_0( cos_view_0 : f32,  roughness_8 : f32) -> vec3<f32>
{
    var _S258 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S259 : f32 = 2.0f * sqrt(_S258) - 1.0f;
    var _S260 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_8, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S259, _S260), 0.00999999977648258f, 1.0f), clamp((1.0f - _S258) * sheen_shear_0(_S259, _S260), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S259, _S260), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_8 : vec3<f32>,  view_9 : vec3<f32>,  scale_0 : f32,  shear_0 : f32) -> f32
{
    var _S261 : f32 = light_8.z;
    if(((_S261 <= 0.0f) | (((view_9.z) <= 0.0f))))
    {
        return 0.0f;
    }
    var _S262 : vec2<f32> = view_9.xy;
    var _S263 : f32 = dot(_S262, _S262);
    var _S264 : vec2<f32> = select_vector_0(_S263 > 9.99999968265522539e-21f, _S262 * vec2<f32>(rsqrt_0(max(_S263, 9.99999968265522539e-21f))), vec2<f32>(1.0f, 0.0f));
    var _S265 : f32 = scale_0 * dot(light_8.xy, _S264) + shear_0 * _S261;
    var _S266 : f32 = scale_0 * (light_8.y * _S264.x - light_8.x * _S264.y);
    var _S267 : f32 = _S265 * _S265 + _S266 * _S266 + _S261 * _S261;
    return 0.31830987334251404f * scale_0 * scale_0 * _S261 / max(_S267 * _S267, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_9 : vec3<f32>,  view_10 : vec3<f32>,  strength_0 : f32,  roughness_9 : f32) -> vec2<f32>
{
    var _S268 : vec3<f32> = sheen_lobe_0(view_10.z, roughness_9);
    var _S269 : f32 = strength_0 * _S268.z;
    return vec2<f32>(_S269 * transformed_cosine_0(light_9, view_10, _S268.x, _S268.y), 1.0f - _S269);
}

fn accumulate_0( index_7 : u32,  light_10 : vec4<f32>)
{
    var _S270 : f32 = layers_0[index_7].share_0;
    radiance_0[index_7] = radiance_0[index_7] + vec4<f32>(layers_0[index_7].share_0) * light_10;
    layers_0[index_7].share_0 = _S270 * (1.0f - light_10.w);
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

fn face_point_0( _S271 : u32,  _S272 : u32,  _S273 : f32,  _S274 : f32) -> VisiblePoint_0
{
    var _S275 : u32 = u32(3) * _S272;
    var _S276 : Vertex_0 = vertex_at_0(_S275);
    var _S277 : Vertex_0 = vertex_at_0(_S275 + u32(1));
    var _S278 : Vertex_0 = vertex_at_0(_S275 + u32(2));
    var _S279 : vec3<f32> = position_of_0(_S276);
    var _S280 : vec3<f32> = position_of_0(_S277) - _S279;
    var _S281 : vec3<f32> = position_of_0(_S278) - _S279;
    var _S282 : f32 = _S277.u_0 - _S276.u_0;
    var _S283 : f32 = _S277.v_0 - _S276.v_0;
    var _S284 : vec2<f32> = vec2<f32>(_S282, _S283);
    var _S285 : f32 = _S278.u_0 - _S276.u_0;
    var _S286 : f32 = _S278.v_0 - _S276.v_0;
    var _S287 : vec2<f32> = vec2<f32>(_S285, _S286);
    var _S288 : vec3<f32> = vec3<f32>(select(1.0f, -1.0f, (_S282 * _S286 - _S283 * _S285) < 0.0f));
    var _S289 : vec3<f32> = _S288 * (vec3<f32>(_S286) * _S280 - vec3<f32>(_S283) * _S281);
    var _S290 : vec3<f32> = _S288 * (vec3<f32>(_S282) * _S281 - vec3<f32>(_S285) * _S280);
    var point_2 : VisiblePoint_0;
    var _S291 : vec3<f32> = vec3<f32>(_S273);
    var _S292 : vec3<f32> = vec3<f32>(_S274);
    var _S293 : vec3<f32> = normalize(vec3<f32>((1.0f - _S273 - _S274)) * normal_of_0(_S276) + _S291 * normal_of_0(_S277) + _S292 * normal_of_0(_S278));
    point_2.normal_0 = _S293;
    var _S294 : vec3<f32> = normalize(_S289 - _S293 * vec3<f32>(dot(_S293, _S289)));
    point_2.axis_x_0 = _S294;
    point_2.axis_y_0 = cross(_S293, _S294);
    var _S295 : vec3<f32> = normalize(cross(_S280, _S281));
    point_2.face_normal_0 = select_vector_1((dot(_S295, _S293)) < 0.0f, (vec3<f32>(0) - _S295), _S295);
    point_2.position_0 = _S279 + _S291 * _S280 + _S292 * _S281;
    point_2.view_0 = _S293;
    var _S296 : vec2<f32> = vec2<f32>(_S276.u_0, _S276.v_0) + vec2<f32>(_S273) * _S284 + vec2<f32>(_S274) * _S287;
    point_2.uv_1 = _S296;
    var _S297 : bool = (dot(cross(_S289, _S290), _S293)) < 0.0f;
    var _S298 : vec2<f32> = vec2<f32>(fabrics_0[_S271].uv_width_0, select(fabrics_0[_S271].uv_height_0, - fabrics_0[_S271].uv_height_0, _S297));
    point_2.draft_per_uv_0 = _S298;
    point_2.draft_0 = _S296 * _S298 + vec2<f32>(0.0f, select(0.0f, fabrics_0[_S271].uv_height_0, _S297));
    var _S299 : vec2<f32> = vec2<f32>(0.0f);
    point_2.draft_dx_0 = _S299;
    point_2.draft_dy_0 = _S299;
    return point_2;
}

fn visible_point_0( _S300 : u32,  _S301 : u32,  _S302 : vec2<u32>) -> VisiblePoint_0
{
    var _S303 : u32 = u32(3) * _S301;
    var _S304 : Vertex_0 = vertex_at_0(_S303);
    var _S305 : Vertex_0 = vertex_at_0(_S303 + u32(1));
    var _S306 : Vertex_0 = vertex_at_0(_S303 + u32(2));
    var _S307 : vec3<f32> = position_of_0(_S304);
    var _S308 : vec3<f32> = position_of_0(_S305) - _S307;
    var _S309 : vec3<f32> = position_of_0(_S306) - _S307;
    var _S310 : vec3<f32> = cross(_S308, _S309);
    var _S311 : f32 = f32(frame_record_0.width_0);
    var _S312 : vec3<f32> = camera_right_0() * vec3<f32>((2.0f / _S311));
    var _S313 : f32 = f32(frame_record_0.height_0);
    var _S314 : vec3<f32> = camera_up_0() * vec3<f32>((-2.0f / _S313));
    var _S315 : vec3<f32> = camera_forward_0() + vec3<f32>((f32(_S302.x) + 0.5f - 0.5f * _S311)) * _S312 + vec3<f32>((f32(_S302.y) + 0.5f - 0.5f * _S313)) * _S314;
    var _S316 : f32 = dot(_S315, _S310);
    var _S317 : f32 = 1.0f / select(1.00000000317107685e-30f, _S316, (abs(_S316)) > 1.00000000317107685e-30f);
    var _S318 : vec3<f32> = _S307 - camera_origin_0();
    var _S319 : vec3<f32> = vec3<f32>((dot(_S318, _S310) * _S317));
    var _S320 : vec3<f32> = _S315 * _S319 - _S318;
    var _S321 : vec3<f32> = _S319 * (_S312 - _S315 * vec3<f32>((dot(_S312, _S310) * _S317)));
    var _S322 : vec3<f32> = _S319 * (_S314 - _S315 * vec3<f32>((dot(_S314, _S310) * _S317)));
    var _S323 : vec3<f32> = vec3<f32>((1.0f / max(square_0(_S310), 1.00000000317107685e-30f)));
    var _S324 : vec3<f32> = cross(_S309, _S310) * _S323;
    var _S325 : vec3<f32> = cross(_S310, _S308) * _S323;
    var _S326 : vec2<f32> = vec2<f32>(_S305.u_0 - _S304.u_0, _S305.v_0 - _S304.v_0);
    var _S327 : vec2<f32> = vec2<f32>(_S306.u_0 - _S304.u_0, _S306.v_0 - _S304.v_0);
    var point_3 : VisiblePoint_0 = face_point_0(_S300, _S301, dot(_S320, _S324), dot(_S320, _S325));
    point_3.position_0 = _S307 + _S320;
    point_3.view_0 = (vec3<f32>(0) - normalize(_S315));
    point_3.draft_dx_0 = (vec2<f32>(dot(_S321, _S324)) * _S326 + vec2<f32>(dot(_S321, _S325)) * _S327) * point_3.draft_per_uv_0;
    point_3.draft_dy_0 = (vec2<f32>(dot(_S322, _S324)) * _S326 + vec2<f32>(dot(_S322, _S325)) * _S327) * point_3.draft_per_uv_0;
    return point_3;
}

fn filtered_albedo_0( _S328 : u32,  _S329 : VisiblePoint_0) -> vec3<f32>
{
    var _S330 : u32 = fabrics_0[_S328].albedo_map_levels_0;
    if((fabrics_0[_S328].albedo_map_levels_0) == u32(0))
    {
        return vec3<f32>(1.0f);
    }
    var _S331 : vec2<f32> = vec2<f32>(fabrics_0[_S328].uv_width_0, fabrics_0[_S328].uv_height_0);
    var _S332 : vec2<f32> = _S329.draft_dx_0 / _S331;
    var _S333 : vec2<f32> = _S329.draft_dy_0 / _S331;
    var _S334 : u32 = _S330 - u32(1);
    var _S335 : u32 = (u32(1) << (_S334));
    var _S336 : f32 = clamp(0.5f * binary_logarithm_0(max(abs(_S332.x * _S333.y - _S332.y * _S333.x), 9.99999968265522539e-21f) * (square_1(f32(_S335)) / 3.0f)), 0.0f, f32(_S330) - 1.0f);
    var _S337 : u32 = min(u32(_S336), max(_S330, u32(2)) - u32(2));
    var _S338 : u32 = min(_S337 + u32(1), _S334);
    var _S339 : u32 = (u32(1) << ((u32(2) * _S330)));
    return mix(map_level_0(fabrics_0[_S328].albedo_map_0 + (_S339 - ((_S339 >> ((u32(2) * _S337))))) / u32(3), (_S335 >> (_S337)), _S329.uv_1), map_level_0(fabrics_0[_S328].albedo_map_0 + (_S339 - ((_S339 >> ((u32(2) * _S338))))) / u32(3), (_S335 >> (_S338)), _S329.uv_1), vec3<f32>(((exponential_0(1.38629436492919922f * (_S336 - f32(_S337))) - 1.0f) / 3.0f)));
}

fn light_sample_count_0() -> u32
{
    return frame_record_0.lights_0 + frame_record_0.environment_samples_0;
}

fn visibility_at_0( _S340 : u32,  _S341 : vec2<u32>) -> f32
{
    if((frame_record_0.casts_shadows_0) == u32(0))
    {
        return 1.0f;
    }
    return visibilities_0[(_S340 * frame_record_0.height_0 + _S341.y) * frame_record_0.width_0 + _S341.x];
}

struct LightSample_0
{
     towards_0 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_1 : f32,
};

fn environment_texel_0( _S342 : u32,  _S343 : u32) -> vec3<f32>
{
    var _S344 : u32 = frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + frame_record_0.environment_rows_0 * (frame_record_0.environment_columns_0 + u32(1)) + u32(3) * (_S342 * frame_record_0.environment_columns_0 + _S343);
    return vec3<f32>(scene_number_0(_S344), scene_number_0(_S344 + u32(1)), scene_number_0(_S344 + u32(2)));
}

fn sample_environment_0( _S345 : vec2<f32>,  _S346 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S347 : u32 = frame_record_0.environment_rows_0;
    var _S348 : Choice_0 = choose_0(frame_record_0.environment_table_0, frame_record_0.environment_rows_0, _S345.y);
    var _S349 : u32 = frame_record_0.environment_columns_0;
    var _S350 : Choice_0 = choose_0(frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + _S348.index_3 * (frame_record_0.environment_columns_0 + u32(1)), frame_record_0.environment_columns_0, _S345.x);
    var _S351 : vec3<f32> = environment_texel_0(_S348.index_3, _S350.index_3);
    (*_S346) = _S351 * vec3<f32>((frame_record_0.environment_total_0 / max(mean_0(_S351), 9.99999968265522539e-21f)));
    var _S352 : f32 = 3.14159274101257324f / f32(_S347);
    var _S353 : f32 = mix(sine_cosine_0(f32(_S348.index_3) * _S352).y, sine_cosine_0(f32(_S348.index_3 + u32(1)) * _S352).y, _S348.remainder_0);
    var _S354 : f32 = sqrt(max(1.0f - _S353 * _S353, 0.0f));
    var _S355 : vec2<f32> = sine_cosine_0((f32(_S350.index_3) + _S350.remainder_0) * (6.28318548202514648f / f32(_S349)));
    var _S356 : f32 = _S354 * _S355.x;
    var _S357 : f32 = - _S354 * _S355.y;
    return vec3<f32>(frame_record_0.environment_cosine_0 * _S356 + frame_record_0.environment_sine_0 * _S357, _S353, frame_record_0.environment_cosine_0 * _S357 - frame_record_0.environment_sine_0 * _S356);
}

fn light_sample_0( _S358 : u32,  _S359 : vec2<u32>,  _S360 : vec3<f32>) -> LightSample_0
{
    var sample_0 : LightSample_0;
    sample_0.distance_1 = 1.00000001504746622e+30f;
    var _S361 : u32 = frame_record_0.lights_0;
    if(_S358 >= (frame_record_0.lights_0))
    {
        var weight_6 : vec3<f32>;
        var _S362 : vec3<f32> = sample_environment_0(pixel_sequence_0(_S359, frame_record_0.pass_number_0 * frame_record_0.environment_samples_0 + (_S358 - _S361), u32(3)), &(weight_6));
        sample_0.towards_0 = _S362;
        sample_0.irradiance_1 = weight_6 / vec3<f32>(f32(frame_record_0.environment_samples_0));
        return sample_0;
    }
    var _S363 : Light_0 = scene_light_0(frame_record_0.light_records_0 + u32(7) * _S358);
    sample_0.irradiance_1 = vec3<f32>(_S363.red_0, _S363.green_0, _S363.blue_0);
    sample_0.towards_0 = vec3<f32>(_S363.x_7, _S363.y_1, _S363.z_1);
    if((_S363.is_point_0) != u32(0))
    {
        var _S364 : vec3<f32> = sample_0.towards_0 - _S360;
        var _S365 : f32 = max(square_0(_S364), 9.999999960041972e-13f);
        sample_0.distance_1 = sqrt(_S365);
        sample_0.irradiance_1 = sample_0.irradiance_1 / vec3<f32>(_S365);
        sample_0.towards_0 = normalize(_S364);
    }
    return sample_0;
}

struct FamilyAlbedos_0
{
     warp_5 : Albedos_0,
     weft_5 : Albedos_0,
};

struct Estimate_0
{
     components_0 : Components_0,
     close_0 : CloseUp_0,
     albedos_5 : FamilyAlbedos_0,
};

struct Regime_0
{
     prefiltered_0 : f32,
     threads_1 : f32,
     points_0 : f32,
};

fn regime_of_0( _S366 : u32,  _S367 : Footprint_0,  _S368 : f32) -> Regime_0
{
    var _S369 : f32 = Footprint_spread_side_0(_S367);
    var _S370 : f32 = clamp((binary_logarithm_0(max(_S369, 9.99999971718068537e-10f)) - fabrics_0[_S366].lobes_0.unit_level_0 - -0.7369655966758728f) / 1.41503751277923584f, 0.0f, 1.0f);
    var regime_0 : Regime_0;
    var _S371 : f32 = _S370 * _S370 * (3.0f - 2.0f * _S370);
    regime_0.prefiltered_0 = _S371;
    var _S372 : f32 = _S369 * fabrics_0[_S366].lobes_0.threads_per_mm_0;
    regime_0.threads_1 = _S372;
    regime_0.points_0 = select(0.0f, clamp(_S372 * 12.0f, 1.0f, mix(max(8.0f / _S368, 1.0f), 1.0f, _S371)), _S371 < 1.0f);
    return regime_0;
}

fn varies_at_0( _S373 : u32,  _S374 : f32) -> bool
{
    return (((((fabrics_0[_S373].fibre_noise_0) > 0.0f) | (((fabrics_0[_S373].colour_noise_0) > 0.0f)))) | (((((fabrics_0[_S373].has_detail_0) != u32(0)) & ((_S374 >= 0.0f))))));
}

struct Hit_0
{
     x_14 : f32,
     y_7 : f32,
     hole_5 : bool,
     height_6 : f32,
};

struct Sample_0
{
     crossing_2 : Crossing_0,
     shown_3 : Shown_0,
     run_3 : Run_0,
     section_1 : Section_0,
     height_7 : f32,
     slope_across_0 : f32,
     slope_along_0 : f32,
     slope_x_1 : f32,
     slope_y_1 : f32,
};

fn crossing_at_0( _S375 : u32,  _S376 : f32,  _S377 : f32,  _S378 : bool) -> Crossing_0
{
    var crossing_3 : Crossing_0;
    crossing_3.warp_2 = locate_0(fabrics_0[_S375].warp_0, _S376);
    crossing_3.weft_2 = locate_0(fabrics_0[_S375].weft_0, _S377);
    var _S379 : u32 = fabrics_0[_S375].run_words_0 + u32(2) * (crossing_3.weft_2.thread_2 * fabrics_0[_S375].ends_1 + crossing_3.warp_2.thread_2);
    var _S380 : u32 = words_0[_S379];
    crossing_3.warp_word_0 = _S380;
    crossing_3.weft_word_0 = words_0[_S379 + u32(1)];
    crossing_3.warp_above_0 = (((_S380 & (u32(1)))) == u32(1)) != _S378;
    return crossing_3;
}

fn sample_at_0( _S381 : u32,  _S382 : f32,  _S383 : f32,  _S384 : bool) -> Sample_0
{
    var sample_1 : Sample_0;
    var _S385 : Crossing_0 = crossing_at_0(_S381, _S382, _S383, _S384);
    sample_1.crossing_2 = _S385;
    var _S386 : Shown_0 = shown_at_0(_S385, _S384);
    sample_1.shown_3 = _S386;
    var _S387 : u32 = select(fabrics_0[_S381].weft_0, fabrics_0[_S381].warp_0, _S386.is_warp_2);
    var _S388 : u32 = select(fabrics_0[_S381].warp_0, fabrics_0[_S381].weft_0, _S386.is_warp_2);
    var _S389 : Cell_0 = select_cell_0(_S386.is_warp_2, sample_1.crossing_2.warp_2, sample_1.crossing_2.weft_2);
    var _S390 : Cell_0 = select_cell_0(_S386.is_warp_2, sample_1.crossing_2.weft_2, sample_1.crossing_2.warp_2);
    var _S391 : Run_0 = unpack_0(_S387, _S388, _S389.thread_2, _S390, _S386.word_0);
    var _S392 : Section_0 = section_at_0(_S389);
    var _S393 : bool = ((_S386.on_top_0) & (((_S391.distance_0) < (_S392.drop_0 * _S391.bend_1.sine_0))));
    var _S394 : f32 = select(-1.0f, 1.0f, ((_S386.on_top_0) & ((!_S393))));
    var _S395 : f32 = select(_S391.reach_0, _S391.other_reach_0, _S393);
    var _S396 : f32 = select(max(_S395 - _S391.distance_0, 0.0f), _S395 + _S391.distance_0, _S393);
    var _S397 : f32 = _S395 / _S391.bend_1.sine_0 - _S394 * _S392.drop_0;
    var _S398 : f32 = _S396 * _S396;
    var _S399 : f32 = max(_S397 * _S397 - _S398, 9.99999968265522539e-21f);
    var _S400 : f32 = rsqrt_0(_S399);
    var _S401 : f32 = _S398 / (_S399 * _S400 + _S397);
    var _S402 : bool = _S396 > 0.0f;
    var _S403 : f32 = select(-1.0f, 1.0f, _S386.on_top_0) * select(-1.0f, 1.0f, _S391.near_start_0);
    var _S404 : f32 = _S392.slope_0 * select(1.0f, _S397 * _S400, _S402);
    sample_1.slope_across_0 = _S404;
    var _S405 : f32 = select(0.0f, _S403 * _S396 * _S400, _S402);
    sample_1.slope_along_0 = _S405;
    var _S406 : vec2<f32> = dive_0(_S388, _S386, _S391, _S390);
    sample_1.height_7 = select(families_0[_S387].height_scale_0 * _S394, 0.0f, _S391.straight_0) * (_S395 * _S391.bend_1.half_tangent_0 - _S401) - families_0[_S387].height_scale_0 * _S392.drop_0 - _S406.x;
    var _S407 : f32 = families_0[_S387].height_scale_0 * _S404;
    var _S408 : f32 = families_0[_S387].height_scale_0 * _S405 - _S406.y;
    sample_1.slope_x_1 = select(_S408, _S407, _S386.is_warp_2);
    sample_1.slope_y_1 = select(_S407, _S408, _S386.is_warp_2);
    sample_1.run_3 = _S391;
    sample_1.section_1 = _S392;
    return sample_1;
}

fn steps_per_length_0( _S409 : u32,  _S410 : SearchQuality_0,  _S411 : vec3<f32>) -> f32
{
    return max(max(abs(_S411.x) * fabrics_0[_S409].threads_per_x_0, abs(_S411.y) * fabrics_0[_S409].threads_per_y_0) * _S410.steps_per_thread_0, abs(_S411.z) * fabrics_0[_S409].per_relief_0 * _S410.steps_per_relief_0);
}

fn cell_maximum_0( _S412 : u32,  _S413 : Crossing_0) -> f32
{
    var _S414 : u32 = select(fabrics_0[_S412].weft_0, fabrics_0[_S412].warp_0, _S413.warp_above_0);
    return f32((select(_S413.weft_word_0, _S413.warp_word_0, _S413.warp_above_0) >> (u32(28)))) * families_0[_S414].height_scale_0 * families_0[_S414].level_0;
}

fn probe_0( _S415 : u32,  _S416 : f32,  _S417 : f32,  _S418 : bool,  _S419 : bool,  _S420 : bool) -> Probe_0
{
    var _S421 : Sample_0 = sample_at_0(_S415, _S416, _S417, _S418);
    var probe_1 : Probe_0;
    probe_1.height_4 = _S421.height_7;
    probe_1.hole_4 = _S421.shown_3.hole_3;
    probe_1.slope_x_0 = _S421.slope_x_1;
    probe_1.slope_y_0 = _S421.slope_y_1;
    probe_1.yarn_1 = select(_S421.crossing_2.weft_2.thread_2 * u32(2), _S421.crossing_2.warp_2.thread_2 * u32(2) + u32(1), _S421.shown_3.is_warp_2);
    probe_1.cell_max_0 = cell_maximum_0(_S415, _S421.crossing_2);
    probe_1.side_x_0 = select(_S421.crossing_2.warp_2.below_0, _S421.crossing_2.warp_2.above_0, _S419);
    probe_1.side_y_0 = select(_S421.crossing_2.weft_2.below_0, _S421.crossing_2.weft_2.above_0, _S420);
    probe_1.edge_x_0 = outline_distance_0(_S421.crossing_2.warp_2, _S421.shown_3, _S421.run_3, !_S421.shown_3.is_warp_2, _S419);
    probe_1.edge_y_0 = outline_distance_0(_S421.crossing_2.weft_2, _S421.shown_3, _S421.run_3, _S421.shown_3.is_warp_2, _S420);
    return probe_1;
}

fn is_free_0( _S422 : u32,  _S423 : SearchQuality_0,  _S424 : vec3<f32>,  _S425 : vec3<f32>,  _S426 : bool,  _S427 : f32) -> bool
{
    var _S428 : f32 = _S425.z;
    if(_S428 <= 0.0f)
    {
        return false;
    }
    var _S429 : f32 = 1.0f / max(_S423.shadow_share_0 * steps_per_length_0(_S422, _S423, _S425), 9.99999971718068537e-10f);
    var _S430 : StepControl_0 = step_control_0(_S425.xy, _S429);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_4 : u32 = u32(0);
    var distance_2 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        if(((count_4 < u32(1024)) & (((_S424.z + _S428 * distance_2) < _S427))))
        {
        }
        else
        {
            break;
        }
        var _S431 : vec3<f32> = _S424 + _S425 * vec3<f32>(distance_2);
        var _S432 : Probe_0 = probe_0(_S422, _S431.x, _S431.y, _S426, _S430.right_0, _S430.up_0);
        var _S433 : f32 = _S431.z;
        var _S434 : f32 = _S433 - _S432.height_4;
        var _S435 : f32 = _S428 - _S432.slope_x_0 * _S425.x - _S432.slope_y_0 * _S425.y;
        if(((!_S432.hole_4) & ((_S434 < 0.0f))))
        {
            return false;
        }
        var _S436 : f32 = way_back_to_dip_0(previous_3, _S434, _S435, last_step_0, _S432);
        if(_S436 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S436;
            distance_2 = distance_2 - _S436;
            last_step_0 = last_step_1;
            count_4 = count_4 + u32(1);
            continue;
        }
        var _S437 : bool = _S433 > (_S432.cell_max_0);
        var last_step_2 : f32 = select(StepControl_to_next_sample_0(_S430, _S432, _S434, _S435), max(StepControl_to_cell_exit_0(_S430, _S432.side_x_0, _S432.side_y_0), _S429), _S437);
        var distance_3 : f32 = distance_2 + last_step_2;
        previous_3 = after_sample_0(_S434, _S435, _S432, _S437);
        distance_2 = distance_3;
        last_step_0 = last_step_2;
        count_4 = count_4 + u32(1);
    }
    return true;
}

fn passes_through_0( _S438 : u32,  _S439 : SearchQuality_0,  _S440 : f32,  _S441 : f32,  _S442 : vec3<f32>,  _S443 : bool) -> bool
{
    if(!sample_at_0(_S438, _S440, _S441, _S443).shown_3.hole_3)
    {
        return false;
    }
    var _S444 : vec3<f32> = vec3<f32>(_S440, _S441, 0.0f);
    var passes_0 : bool = true;
    var side_1 : u32 = u32(0);
    for(;;)
    {
        if(((side_1 < u32(2)) & (passes_0)))
        {
        }
        else
        {
            break;
        }
        var _S445 : bool = is_free_0(_S438, _S439, _S444, select_vector_1(side_1 == u32(0), _S442, vec3<f32>(- _S442.x, - _S442.y, _S442.z)), _S443 != (side_1 == u32(1)), fabrics_0[_S438].height_high_0);
        var _S446 : u32 = side_1 + u32(1);
        passes_0 = _S445;
        side_1 = _S446;
    }
    return passes_0;
}

struct ViewRayEnd_0
{
     height_8 : f32,
     last_step_3 : f32,
     depth_1 : f32,
     rate_4 : f32,
     smooth_0 : bool,
     previous_4 : PreviousSample_0,
};

fn max_height_along_0( _S447 : u32,  _S448 : f32,  _S449 : f32,  _S450 : f32,  _S451 : vec3<f32>,  _S452 : bool) -> f32
{
    var _S453 : f32 = _S451.x;
    var _S454 : f32 = _S451.y;
    var _S455 : u32 = (words_0[fabrics_0[_S447].max_heights_0 + u32(4) * (locate_0(fabrics_0[_S447].weft_0, _S449).thread_2 / u32(2) * fabrics_0[_S447].max_height_columns_0 + locate_0(fabrics_0[_S447].warp_0, _S448).thread_2 / u32(2)) + (select(u32(0), u32(1), _S453 > 0.0f) + select(u32(0), u32(2), _S454 > 0.0f))] >> (u32(select(i32(0), i32(4), _S452))));
    var _S456 : f32 = max(abs(_S453) * fabrics_0[_S447].threads_per_x_0, abs(_S454) * fabrics_0[_S447].threads_per_y_0) / _S451.z;
    var _S457 : f32 = fabrics_0[_S447].height_high_0;
    var max_height_0 : f32 = fabrics_0[_S447].height_high_0;
    var number_1 : i32 = i32(3);
    for(;;)
    {
        if(number_1 >= i32(0))
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S450) * _S456) <= (PYRAMID_RADII_0[number_1]))
        {
            max_height_0 = min(max_height_0, f32((((_S455 >> (u32(i32(8) * number_1)))) & (u32(15)))) * 0.06666667014360428f * _S457);
        }
        number_1 = number_1 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S458 : u32,  _S459 : f32,  _S460 : f32,  _S461 : bool,  _S462 : bool,  _S463 : bool) -> vec3<f32>
{
    var _S464 : Crossing_0 = crossing_at_0(_S458, _S459, _S460, _S461);
    return vec3<f32>(cell_maximum_0(_S458, _S464), select(_S464.warp_2.below_0, _S464.warp_2.above_0, _S462), select(_S464.weft_2.below_0, _S464.weft_2.above_0, _S463));
}

fn first_sample_height_0( _S465 : u32,  _S466 : ViewRay_0,  _S467 : StepControl_0,  _S468 : bool) -> f32
{
    var _S469 : f32 = max_height_along_0(_S465, _S466.origin_0.x, _S466.origin_0.y, 0.0f, vec3<f32>(_S466.slope_1, 1.0f), _S468);
    var count_5 : u32 = u32(0);
    var height_9 : f32 = _S469;
    for(;;)
    {
        if(count_5 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S470 : vec2<f32> = ViewRay_at_0(_S466, height_9);
        var _S471 : vec3<f32> = cell_bounds_0(_S465, _S470.x, _S470.y, _S468, _S467.right_0, _S467.up_0);
        var _S472 : f32 = height_9 - _S471.x;
        var _S473 : f32 = StepControl_to_cell_exit_0(_S467, _S471.y, _S471.z);
        var height_10 : f32 = height_9 - clamp(_S472, 0.0f, _S473);
        if(_S472 <= _S473)
        {
            height_9 = height_10;
            break;
        }
        count_5 = count_5 + u32(1);
        height_9 = height_10;
    }
    return height_9;
}

fn search_down_0( _S474 : u32,  _S475 : ViewRay_0,  _S476 : StepControl_0,  _S477 : bool) -> ViewRayEnd_0
{
    var _S478 : f32 = fabrics_0[_S474].height_low_0 - (fabrics_0[_S474].height_high_0 - fabrics_0[_S474].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_8 = first_sample_height_0(_S474, _S475, _S476, _S477);
    end_1.last_step_3 = _S476.epsilon_0;
    end_1.previous_4 = no_previous_sample_0();
    end_1.depth_1 = 0.0f;
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
        var _S479 : vec2<f32> = ViewRay_at_0(_S475, end_1.height_8);
        var _S480 : Probe_0 = probe_0(_S474, _S479.x, _S479.y, _S477, _S476.right_0, _S476.up_0);
        var _S481 : f32 = end_1.height_8 - _S480.height_4;
        var _S482 : f32 = ViewRay_rate_0(_S475, _S480);
        end_1.depth_1 = - _S481;
        end_1.rate_4 = _S482;
        var _S483 : bool = !_S480.hole_4;
        end_1.smooth_0 = ((((end_1.previous_4.known_0) & (_S483))) & (((end_1.previous_4.yarn_0) == (_S480.yarn_1))));
        if((((_S483 & ((_S481 <= 0.0f)))) | (((end_1.height_8) <= _S478))))
        {
            break;
        }
        var _S484 : f32 = way_back_to_dip_0(end_1.previous_4, _S481, _S482, end_1.last_step_3, _S480);
        if(_S484 >= 0.0f)
        {
            end_1.height_8 = end_1.height_8 + _S484;
            end_1.last_step_3 = end_1.last_step_3 - _S484;
            count_6 = count_6 + u32(1);
            continue;
        }
        var _S485 : f32 = min(StepControl_to_cell_exit_0(_S476, _S480.side_x_0, _S480.side_y_0), end_1.height_8 - _S480.cell_max_0);
        var _S486 : f32 = StepControl_to_next_sample_0(_S476, _S480, _S481, _S482);
        end_1.previous_4 = after_sample_0(_S481, _S482, _S480, _S485 > _S486);
        var _S487 : f32 = max(_S485, _S486);
        end_1.last_step_3 = _S487;
        end_1.height_8 = end_1.height_8 - _S487;
        count_6 = count_6 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S488 : u32,  _S489 : ViewRay_0,  _S490 : StepControl_0,  _S491 : bool,  _S492 : ViewRayEnd_0,  _S493 : u32) -> f32
{
    var _S494 : f32 = fabrics_0[_S488].height_high_0 - fabrics_0[_S488].height_low_0;
    var above_2 : f32 = _S492.height_8 + _S492.last_step_3;
    var above_gap_1 : f32 = clamp(_S492.previous_4.clearance_0, 0.0f, _S494);
    var under_gap_1 : f32 = clamp(_S492.depth_1, 0.0f, _S494);
    var middle_0 : f32 = select(between_0(above_2, _S492.height_8, above_gap_1, under_gap_1), above_2 - cubic_root_0(above_gap_1, - under_gap_1, _S492.previous_4.rate_0 * _S492.last_step_3, _S492.rate_4 * _S492.last_step_3) * _S492.last_step_3, _S492.smooth_0);
    var side_2 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S492.height_8;
    var above_3 : f32 = above_2;
    var i_2 : u32 = u32(0);
    for(;;)
    {
        if(i_2 < _S493)
        {
        }
        else
        {
            break;
        }
        var _S495 : vec2<f32> = ViewRay_at_0(_S489, middle_0);
        var _S496 : Probe_0 = probe_0(_S488, _S495.x, _S495.y, _S491, _S490.right_0, _S490.up_0);
        var _S497 : f32 = clamp(middle_0 - select(_S496.height_4, -1.0e+09f, _S496.hole_4), - _S494, _S494);
        if(_S497 <= 0.0f)
        {
            var _S498 : f32 = select(above_gap_2, 0.5f * above_gap_2, side_2 > 0.0f);
            var _S499 : f32 = - _S497;
            under_1 = middle_0;
            above_gap_2 = _S498;
            under_gap_2 = _S499;
            side_2 = 1.0f;
        }
        else
        {
            var _S500 : f32 = select(under_gap_2, 0.5f * under_gap_2, side_2 < 0.0f);
            above_3 = middle_0;
            above_gap_2 = _S497;
            under_gap_2 = _S500;
            side_2 = -1.0f;
        }
        var _S501 : f32 = select(between_0(above_3, under_1, above_gap_2, under_gap_2), clamp(middle_0 + _S497 / min(ViewRay_rate_0(_S489, _S496), -9.99999997475242708e-07f), under_1, above_3), _S492.smooth_0);
        var _S502 : u32 = i_2 + u32(1);
        middle_0 = _S501;
        i_2 = _S502;
    }
    return select(under_1, middle_0, _S492.smooth_0);
}

fn first_hit_of_yarn_0( _S503 : u32,  _S504 : SearchQuality_0,  _S505 : f32,  _S506 : f32,  _S507 : vec3<f32>,  _S508 : bool) -> Hit_0
{
    var _S509 : f32 = max(_S507.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S505, _S506);
    var _S510 : vec2<f32> = _S507.xy / vec2<f32>(_S509);
    ray_0.slope_1 = _S510;
    var _S511 : StepControl_0 = step_control_0((vec2<f32>(0) - _S510), 1.0f / max(steps_per_length_0(_S503, _S504, _S507) / _S509, 9.99999971718068537e-10f));
    var _S512 : ViewRayEnd_0 = search_down_0(_S503, ray_0, _S511, _S508);
    var hit_0 : Hit_0;
    hit_0.hole_5 = false;
    var _S513 : f32 = refined_height_0(_S503, ray_0, _S511, _S508, _S512, _S504.refinements_0);
    hit_0.height_6 = _S513;
    var _S514 : vec2<f32> = ViewRay_at_0(ray_0, _S513);
    hit_0.x_14 = _S514.x;
    hit_0.y_7 = _S514.y;
    return hit_0;
}

fn first_hit_0( _S515 : u32,  _S516 : SearchQuality_0,  _S517 : f32,  _S518 : f32,  _S519 : vec3<f32>,  _S520 : bool) -> Hit_0
{
    if(!passes_through_0(_S515, _S516, _S517, _S518, _S519, _S520))
    {
        return first_hit_of_yarn_0(_S515, _S516, _S517, _S518, _S519, _S520);
    }
    var hit_1 : Hit_0;
    hit_1.x_14 = _S517;
    hit_1.y_7 = _S518;
    hit_1.height_6 = 0.0f;
    hit_1.hole_5 = true;
    return hit_1;
}

fn surface_at_0( _S521 : u32,  _S522 : f32,  _S523 : f32,  _S524 : bool) -> SurfacePoint_0
{
    var _S525 : Sample_0 = sample_at_0(_S521, _S522, _S523, _S524);
    var _S526 : u32 = select(fabrics_0[_S521].weft_0, fabrics_0[_S521].warp_0, _S525.shown_3.is_warp_2);
    var _S527 : f32 = families_0[_S526].twist_sine_0 * select(1.0f, -1.0f, _S524);
    var _S528 : f32 = select(-1.0f, 1.0f, _S525.shown_3.is_warp_2);
    var _S529 : vec2<f32> = fibre_direction_0(_S525.slope_across_0, _S528 * _S525.slope_along_0, _S527, families_0[_S526].twist_cosine_0);
    var _S530 : f32 = _S529.x;
    var _S531 : f32 = _S529.y;
    var _S532 : f32 = select(_S525.slope_y_1, _S525.slope_x_1, _S525.shown_3.is_warp_2) * _S530 + _S528 * select(_S525.slope_x_1, _S525.slope_y_1, _S525.shown_3.is_warp_2) * _S531;
    var _S533 : f32 = select(_S525.crossing_2.weft_2.half_width_1, _S525.crossing_2.warp_2.half_width_1, _S525.shown_3.is_warp_2) * 1.0154266357421875f;
    var _S534 : f32 = _S533 * arc_sine_0(clamp(_S525.section_1.across_3 / _S533, -1.0f, 1.0f));
    var _S535 : f32 = select(- _S522, _S523, _S525.shown_3.is_warp_2);
    var point_4 : SurfacePoint_0;
    point_4.hole_0 = _S525.shown_3.hole_3;
    point_4.is_warp_0 = _S525.shown_3.is_warp_2;
    point_4.warp_thread_0 = _S525.crossing_2.warp_2.thread_2;
    point_4.weft_thread_0 = _S525.crossing_2.weft_2.thread_2;
    point_4.height_2 = _S525.height_7;
    point_4.normal_1 = normalize(vec3<f32>(- _S525.slope_x_1, - _S525.slope_y_1, 1.0f));
    point_4.tangent_0 = normalize(select_vector_1(_S525.shown_3.is_warp_2, vec3<f32>(_S530, _S531, _S532), vec3<f32>(- _S531, _S530, _S532)));
    point_4.across_0 = _S525.section_1.across_3;
    point_4.fibre_across_0 = _S534 * families_0[_S526].twist_cosine_0 + _S535 * _S527;
    point_4.fibre_along_0 = _S535 * families_0[_S526].twist_cosine_0 - _S534 * _S527;
    return point_4;
}

struct YarnPoint_0
{
     back_7 : bool,
     hole_6 : bool,
     is_warp_3 : bool,
     x_15 : f32,
     y_8 : f32,
     height_11 : f32,
     normal_10 : vec3<f32>,
     tangent_10 : vec3<f32>,
     surface_normal_0 : vec3<f32>,
     diffuse_gain_1 : f32,
     roughness_10 : f32,
     albedos_6 : Albedos_0,
};

fn has_hairs_0( _S536 : u32) -> bool
{
    return (((families_0[fabrics_0[_S536].warp_0].hairiness_0) > 0.0f) | (((families_0[fabrics_0[_S536].weft_0].hairiness_0) > 0.0f)));
}

fn hair_at_0( _S537 : u32,  _S538 : vec2<f32>,  _S539 : bool,  _S540 : f32) -> Hair_0
{
    var _S541 : f32 = fabrics_0[_S537].fibre_size_0;
    var _S542 : f32 = 17.0f * fabrics_0[_S537].fibre_size_0;
    var _S543 : f32 = fade_0(_S540, _S542);
    var _S544 : vec2<f32> = _S538 / vec2<f32>(_S542);
    var _S545 : u32 = hash_key_0(select(u32(0), u32(1), _S539), ((fabrics_0[_S537].seed_0) ^ (u32(1013904242))));
    var _S546 : f32 = 1.0f / max(_S540, 0.07999999821186066f * fabrics_0[_S537].fibre_size_0);
    var _S547 : f32 = min(0.63999998569488525f * fabrics_0[_S537].fibre_size_0 * _S546, 1.0f);
    const _S548 : vec2<f32> = vec2<f32>(0.0f, 1.0f);
    var cover_2 : f32 = 0.0f;
    var hair_away_0 : f32 = 0.0f;
    var hair_across_0 : vec2<f32> = _S548;
    var number_2 : u32 = u32(0);
    for(;;)
    {
        if(((_S543 > 0.0f) & ((number_2 < u32(18)))))
        {
        }
        else
        {
            break;
        }
        var _S549 : u32 = number_2 / u32(9);
        var _S550 : u32 = number_2 / u32(3) - u32(3) * _S549;
        var _S551 : vec2<f32> = floor(_S544) + vec2<f32>(f32(number_2 - u32(3) * _S550 - u32(9) * _S549), f32(_S550)) - vec2<f32>(1.0f);
        var _S552 : u32 = hash_bits_0(_S545 + _S549, u32(i32(_S551.x)) * u32(65536) + u32(i32(_S551.y)));
        var _S553 : u32 = hash_bits_0(_S545, _S552);
        var _S554 : vec2<f32> = _S544 - _S551 - vec2<f32>(share_of_0(_S552), share_of_0((_S552 >> (u32(10)))));
        var _S555 : vec2<f32> = sine_cosine_0(3.14159274101257324f * share_of_0((_S552 >> (u32(20)))));
        var _S556 : f32 = mix(5.0f, 16.0f, share_of_0((_S553 >> (u32(10))))) / 17.0f;
        var _S557 : f32 = _S554.x;
        var _S558 : f32 = _S555.y;
        var _S559 : f32 = _S554.y;
        var _S560 : f32 = _S555.x;
        var _S561 : f32 = (_S557 * _S558 + _S559 * _S560) / _S556;
        var _S562 : f32 = 0.69999998807907104f * (2.0f * share_of_0((_S553 >> (u32(20)))) - 1.0f);
        var _S563 : f32 = 2.0f * _S562 * _S561;
        var _S564 : f32 = rsqrt_0(_S563 * _S563 + 1.0f);
        var _S565 : f32 = (_S559 * _S558 - _S557 * _S560 - _S562 * _S556 * _S561 * _S561) * _S564 * 17.0f;
        var _S566 : f32 = clamp((0.31999999284744263f - abs(_S565)) * _S541 * _S546 + 0.5f, 0.0f, _S547);
        if((((((share_of_0(_S553)) < (families_0[select(fabrics_0[_S537].weft_0, fabrics_0[_S537].warp_0, ((((_S553 >> (u32(30)))) & (u32(1)))) == u32(1))].hairiness_0)) & (((abs(_S561)) < 1.0f)))) & ((_S566 > cover_2))))
        {
            var _S567 : vec2<f32> = vec2<f32>(- _S560 - _S563 * _S558, _S558 - _S563 * _S560) * vec2<f32>(_S564);
            cover_2 = _S566;
            hair_away_0 = _S565;
            hair_across_0 = _S567;
        }
        number_2 = number_2 + u32(1);
    }
    var _S568 : f32 = clamp(hair_away_0 * 2.5f, -0.80000001192092896f, 0.80000001192092896f);
    var hair_1 : Hair_0;
    hair_1.cover_0 = _S543 * cover_2;
    hair_1.normal_3 = vec3<f32>(vec2<f32>(_S568) * hair_across_0, sqrt(1.0f - _S568 * _S568));
    hair_1.tangent_2 = vec3<f32>(hair_across_0.y, - hair_across_0.x, 0.0f);
    return hair_1;
}

fn thread_number_0( _S569 : u32,  _S570 : SurfacePoint_0,  _S571 : f32,  _S572 : f32) -> u32
{
    var _S573 : u32 = select(fabrics_0[_S569].weft_0, fabrics_0[_S569].warp_0, _S570.is_warp_0);
    return u32(i32(floor((select(_S572, _S571, _S570.is_warp_0) - _S570.across_0) / families_0[_S573].period_0)) * i32(families_0[_S573].count_0) + i32(select(_S570.weft_thread_0, _S570.warp_thread_0, _S570.is_warp_0))) * u32(2) + select(u32(0), u32(1), _S570.is_warp_0);
}

struct FibreNoise_0
{
     bundle_0 : vec2<f32>,
     bundle_weight_0 : f32,
     fibre_0 : vec2<f32>,
     fibre_weight_0 : f32,
     offset_1 : f32,
     slope_2 : f32,
};

fn fibre_noise_at_0( _S574 : u32,  _S575 : u32,  _S576 : SurfacePoint_0,  _S577 : u32,  _S578 : f32) -> FibreNoise_0
{
    var _S579 : f32 = 5.0f * fabrics_0[_S574].fibre_size_0;
    var _S580 : vec2<f32> = wave_noise_0(hash_key_0(_S577, ((fabrics_0[_S574].seed_0) ^ (u32(458671337)))), _S576.fibre_along_0 / (25.0f * fabrics_0[_S574].fibre_size_0));
    var _S581 : f32 = _S576.fibre_across_0 + families_0[_S575].fibre_tilt_0 * 0.5f * 25.0f * fabrics_0[_S574].fibre_size_0 * _S580.x;
    var _S582 : vec3<f32> = fibre_cell_0(_S581, _S576.fibre_along_0, fabrics_0[_S574].fibre_size_0);
    var noise_0 : FibreNoise_0;
    noise_0.bundle_0 = cell_noise_0(hash_key_0(_S577, ((fabrics_0[_S574].seed_0) ^ (u32(1757159915)))), fibre_cell_0(_S581, _S576.fibre_along_0, _S579));
    noise_0.bundle_weight_0 = fade_0(_S578, _S579);
    noise_0.fibre_0 = cell_noise_0(hash_key_0(_S577, ((fabrics_0[_S574].seed_0) ^ (u32(48610963)))), _S582);
    noise_0.fibre_weight_0 = fade_0(_S578, fabrics_0[_S574].fibre_size_0);
    noise_0.offset_1 = _S582.z;
    noise_0.slope_2 = 0.5f * _S580.y;
    return noise_0;
}

fn detail_gain_0( _S583 : u32,  _S584 : u32,  _S585 : SurfacePoint_0,  _S586 : vec2<f32>,  _S587 : bool,  _S588 : u32,  _S589 : f32) -> vec2<f32>
{
    var _S590 : vec2<f32> = vec2<f32>(0.0f);
    var gain_2 : vec2<f32>;
    if((families_0[_S584].has_plies_0) > 0.0f)
    {
        gain_2 = vec2<f32>((0.60000002384185791f * fade_0(_S589, 1.0f / families_0[_S584].plies_per_mm_0))) * vec2<f32>(0.20000000298023224f - square_1(square_1(ply_offset_0(_S584, _S585, _S587))), 0.20000000298023224f);
    }
    else
    {
        gain_2 = _S590;
    }
    if((families_0[_S584].fibre_tone_0) > 0.0f)
    {
        var _S591 : FibreNoise_0 = fibre_noise_at_0(_S583, _S584, _S585, _S588, _S589);
        gain_2 = gain_2 + vec2<f32>(families_0[_S584].fibre_tone_0) * vec2<f32>(_S591.bundle_weight_0 * _S591.bundle_0.y + _S591.fibre_weight_0 * _S591.fibre_0.y, _S591.bundle_weight_0 + _S591.fibre_weight_0);
    }
    if((families_0[_S584].slub_0) > 0.0f)
    {
        gain_2 = gain_2 + vec2<f32>((0.25f * families_0[_S584].slub_0 * fade_0(_S589, 1.0f / families_0[_S584].slubs_per_mm_0))) * vec2<f32>(wave_noise_0(hash_key_0(_S588, ((fabrics_0[_S583].seed_0) ^ (u32(1373058189)))), select(- _S586.x, _S586.y, _S585.is_warp_0) * families_0[_S584].slubs_per_mm_0).x * mix(0.40000000596046448f, 1.0f, min(square_1(_S585.across_0 * families_0[_S584].per_half_width_0), 1.0f)), 1.0f);
    }
    return gain_2;
}

fn vary_albedos_0( _S592 : u32,  _S593 : Albedos_0,  _S594 : u32,  _S595 : u32,  _S596 : vec2<f32>) -> Albedos_0
{
    var _S597 : vec3<f32> = max(_S593.specular_reflect_0, _S593.specular_transmit_0);
    var _S598 : vec3<f32> = _S593.diffuse_reflect_0 + _S593.diffuse_transmit_0;
    var _S599 : vec3<f32> = vec3<f32>(fabrics_0[_S592].layer_bound_0);
    var _S600 : vec3<f32> = vec3<f32>(1.0f);
    var _S601 : vec3<f32> = _S600 - _S599 * _S597;
    var colour_1 : f32 = bounded_gain_0(thread_gain_0(_S594, fabrics_0[_S592].colour_noise_0, fabrics_0[_S592].seed_0), _S598, _S601);
    var _S602 : vec3<f32> = vec3<f32>((colour_1 * (1.0f + flattened_0(_S596.y, vec3<f32>(colour_1) * _S598, _S601) * _S596.x)));
    var _S603 : f32 = bounded_gain_0(fibre_gain_0(_S594, _S595, fabrics_0[_S592].fibre_noise_0, fabrics_0[_S592].seed_0), _S597, min((_S600 - _S602 * _S598) / _S599, vec3<f32>(1.0f)));
    var varied_0 : Albedos_0;
    varied_0.diffuse_reflect_0 = _S602 * _S593.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S602 * _S593.diffuse_transmit_0;
    var _S604 : vec3<f32> = vec3<f32>(_S603);
    varied_0.specular_reflect_0 = _S604 * _S593.specular_reflect_0;
    varied_0.specular_transmit_0 = _S604 * _S593.specular_transmit_0;
    return varied_0;
}

fn varied_at_0( _S605 : u32,  _S606 : SurfacePoint_0,  _S607 : Albedos_0,  _S608 : f32,  _S609 : f32,  _S610 : bool,  _S611 : f32,  _S612 : f32) -> Albedos_0
{
    var _S613 : u32 = thread_number_0(_S605, _S606, _S608, _S609);
    var _S614 : vec3<f32> = fibre_cell_0(_S606.fibre_across_0, _S606.fibre_along_0, fabrics_0[_S605].fibre_size_0);
    var _S615 : vec2<f32> = vec2<f32>(0.0f);
    var gain_3 : vec2<f32>;
    if((((fabrics_0[_S605].has_detail_0) != u32(0)) & ((_S611 >= 0.0f))))
    {
        gain_3 = detail_gain_0(_S605, select(fabrics_0[_S605].weft_0, fabrics_0[_S605].warp_0, _S606.is_warp_0), _S606, vec2<f32>(_S608, _S609), _S610, _S613, _S611) * vec2<f32>(1.0f - _S612, 1.0f);
    }
    else
    {
        gain_3 = _S615;
    }
    return vary_albedos_0(_S605, _S607, _S613, u32(i32(_S614.x)) * u32(65536) + u32(i32(floor(_S614.y))), gain_3);
}

fn turned_frame_0( _S616 : u32,  _S617 : u32,  _S618 : SurfacePoint_0,  _S619 : bool,  _S620 : u32,  _S621 : f32) -> YarnFrame_0
{
    var frame_2 : YarnFrame_0;
    frame_2.normal_5 = _S618.normal_1;
    frame_2.tangent_4 = _S618.tangent_0;
    frame_2.loss_0 = 0.0f;
    if((families_0[_S617].has_plies_0) > 0.0f)
    {
        var _S622 : f32 = fade_0(_S621, 1.0f / families_0[_S617].plies_per_mm_0);
        var _S623 : f32 = _S622 * 0.41999998688697815f * ply_offset_0(_S617, _S618, _S619);
        var _S624 : vec3<f32> = cross(frame_2.tangent_4, frame_2.normal_5);
        var _S625 : vec3<f32> = vec3<f32>(families_0[_S617].ply_cosine_0);
        var _S626 : vec3<f32> = vec3<f32>(select(families_0[_S617].ply_sine_0, - families_0[_S617].ply_sine_0, _S619));
        var _S627 : vec3<f32> = _S625 * _S624 + _S626 * frame_2.tangent_4;
        var _S628 : vec3<f32> = vec3<f32>(sqrt(1.0f - _S623 * _S623));
        var _S629 : vec3<f32> = vec3<f32>(_S623);
        frame_2.tangent_4 = _S625 * (_S625 * frame_2.tangent_4 - _S626 * _S624) + _S626 * (_S628 * _S627 - _S629 * frame_2.normal_5);
        frame_2.normal_5 = _S628 * frame_2.normal_5 + _S629 * _S627;
        frame_2.loss_0 = _S622 * _S622 * 0.41999998688697815f * 0.41999998688697815f / 6.0f;
    }
    var _S630 : f32 = families_0[_S617].fibre_tilt_0;
    if((families_0[_S617].fibre_tilt_0) > 0.0f)
    {
        var _S631 : FibreNoise_0 = fibre_noise_at_0(_S616, _S617, _S618, _S620, _S621);
        var _S632 : f32 = 1.09858846664428711f * _S630 * (_S631.bundle_weight_0 * _S631.bundle_0.x + _S631.fibre_weight_0 * (_S631.fibre_0.x + _S631.offset_1));
        var _S633 : f32 = _S630 * (1.42099642753601074f * (_S631.bundle_weight_0 * _S631.bundle_0.y + _S631.fibre_weight_0 * _S631.fibre_0.y) - _S631.bundle_weight_0 * _S631.slope_2);
        var _S634 : f32 = square_1(_S631.fibre_weight_0);
        frame_2.loss_0 = frame_2.loss_0 + 0.5f * _S630 * _S630 * ((0.24761904776096344f * (square_1(_S631.bundle_weight_0) + _S634) + _S634 / 3.0f) * 1.09858846664428711f * 1.09858846664428711f);
        var _S635 : vec3<f32> = cross(frame_2.tangent_4, frame_2.normal_5);
        var _S636 : vec2<f32> = sine_cosine_0(_S632);
        var _S637 : vec2<f32> = sine_cosine_0(_S633);
        var _S638 : vec3<f32> = vec3<f32>(_S636.y);
        var _S639 : vec3<f32> = vec3<f32>(_S636.x);
        var _S640 : vec3<f32> = _S638 * _S635 - _S639 * frame_2.normal_5;
        frame_2.normal_5 = _S638 * frame_2.normal_5 + _S639 * _S635;
        frame_2.tangent_4 = vec3<f32>(_S637.y) * frame_2.tangent_4 + vec3<f32>(_S637.x) * _S640;
    }
    return frame_2;
}

fn yarn_point_of_0( _S641 : u32,  _S642 : SurfacePoint_0,  _S643 : f32,  _S644 : f32,  _S645 : bool,  _S646 : bool,  _S647 : f32) -> YarnPoint_0
{
    var _S648 : u32 = select(fabrics_0[_S641].weft_0, fabrics_0[_S641].warp_0, _S642.is_warp_0);
    var _S649 : bool = (((fabrics_0[_S641].has_detail_0) != u32(0)) & ((_S647 >= 0.0f)));
    var _S650 : vec3<f32> = vec3<f32>(0.0f);
    var _S651 : Hair_0 = Hair_x24init_0(0.0f, _S650, _S650);
    var _S652 : bool;
    if(_S649)
    {
        _S652 = has_hairs_0(_S641);
    }
    else
    {
        _S652 = false;
    }
    var hair_2 : Hair_0;
    if(_S652)
    {
        hair_2 = hair_at_0(_S641, vec2<f32>(_S643, _S644), _S645, _S647);
    }
    else
    {
        hair_2 = _S651;
    }
    var albedos_7 : Albedos_0 = albedos_of_0(_S648, select(_S642.weft_thread_0, _S642.warp_thread_0, _S642.is_warp_0));
    var albedos_8 : Albedos_0;
    if(varies_at_0(_S641, _S647))
    {
        albedos_8 = varied_at_0(_S641, _S642, albedos_7, _S643, _S644, _S645, _S647, hair_2.cover_0);
    }
    else
    {
        albedos_8 = albedos_7;
    }
    var point_5 : YarnPoint_0;
    point_5.back_7 = _S645;
    point_5.hole_6 = _S646;
    point_5.is_warp_3 = _S642.is_warp_0;
    point_5.x_15 = _S643;
    point_5.y_8 = _S644;
    point_5.height_11 = _S642.height_2;
    point_5.normal_10 = _S642.normal_1;
    point_5.tangent_10 = _S642.tangent_0;
    point_5.surface_normal_0 = _S642.normal_1;
    point_5.diffuse_gain_1 = 1.0f;
    if(_S649)
    {
        var _S653 : YarnFrame_0 = turned_frame_0(_S641, _S648, _S642, _S645, thread_number_0(_S641, _S642, _S643, _S644), _S647);
        var frame_3 : YarnFrame_0;
        if(has_hairs_0(_S641))
        {
            frame_3 = under_hair_0(_S653, hair_2);
        }
        else
        {
            frame_3 = _S653;
        }
        point_5.normal_10 = frame_3.normal_5;
        point_5.tangent_10 = frame_3.tangent_4;
        point_5.diffuse_gain_1 = diffuse_gain_0(frame_3, fabrics_0[_S641].diffuse_blend_0);
    }
    point_5.roughness_10 = families_0[_S648].roughness_0;
    point_5.albedos_6 = albedos_8;
    return point_5;
}

fn unoccluded_0( _S654 : u32,  _S655 : SearchQuality_0,  _S656 : f32,  _S657 : f32,  _S658 : f32,  _S659 : vec3<f32>,  _S660 : bool) -> bool
{
    if((_S659.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S654, _S655, vec3<f32>(_S656, _S657, _S658 + fabrics_0[_S654].lift_0), _S659, _S660, max_height_along_0(_S654, _S656, _S657, _S658, _S659, _S660));
}

fn is_lit_0( _S661 : u32,  _S662 : SearchQuality_0,  _S663 : YarnPoint_0,  _S664 : vec3<f32>) -> bool
{
    if(_S663.hole_6)
    {
        return true;
    }
    var _S665 : vec3<f32> = to_face_frame_0(_S664, _S663.back_7);
    var _S666 : f32 = _S665.z;
    var _S667 : bool = _S666 < 0.0f;
    var normal_11 : vec3<f32>;
    var height_12 : f32;
    if(_S667)
    {
        var _S668 : SurfacePoint_0 = surface_at_0(_S661, _S663.x_15, _S663.y_8, !_S663.back_7);
        normal_11 = _S668.normal_1;
        height_12 = _S668.height_2;
    }
    else
    {
        normal_11 = _S663.surface_normal_0;
        height_12 = _S663.height_11;
    }
    var _S669 : vec3<f32> = vec3<f32>(_S665.xy, abs(_S666));
    if((dot(normal_11, _S669)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S661, _S662, _S663.x_15, _S663.y_8, height_12, _S669, (_S663.back_7) != _S667);
}

fn components_of_point_0( _S670 : u32,  _S671 : SearchQuality_0,  _S672 : YarnPoint_0,  _S673 : vec3<f32>,  _S674 : vec3<f32>) -> Components_0
{
    var result_3 : Components_0 = no_components_0();
    result_3.hole_2 = select(0.0f, 1.0f, _S672.hole_6);
    var _S675 : bool;
    if(_S672.hole_6)
    {
        _S675 = true;
    }
    else
    {
        _S675 = !is_lit_0(_S670, _S671, _S672, _S673);
    }
    if(_S675)
    {
        return result_3;
    }
    var _S676 : vec3<f32> = to_face_frame_0(_S673, _S672.back_7);
    var _S677 : vec3<f32> = to_face_frame_0(_S674, _S672.back_7);
    var _S678 : bool = (_S676.z) < 0.0f;
    var _S679 : f32 = _S672.diffuse_gain_1 * diffuse_reflection_0(select_vector_1(_S678, (vec3<f32>(0) - _S676), _S676), _S672.normal_10, fabrics_0[_S670].diffuse_blend_0);
    var _S680 : f32;
    if(_S678)
    {
        _S680 = transmission_1(_S676, _S677, _S672.normal_10, _S672.tangent_10, _S672.roughness_10, fabrics_0[_S670].optical_depth_0);
    }
    else
    {
        _S680 = reflection_0(_S676, _S677, _S672.normal_10, _S672.tangent_10, _S672.roughness_10, fabrics_0[_S670].optical_depth_0);
    }
    result_3.diffuse_warp_0 = select(0.0f, _S679, _S672.is_warp_3);
    result_3.diffuse_weft_0 = select(_S679, 0.0f, _S672.is_warp_3);
    result_3.specular_warp_0 = select(0.0f, _S680, _S672.is_warp_3);
    result_3.specular_weft_0 = select(_S680, 0.0f, _S672.is_warp_3);
    result_3.light_visibility_1 = 1.0f;
    return result_3;
}

fn openness_number_0( _S681 : u32,  _S682 : u32) -> f32
{
    return table_number_0(fabrics_0[_S681].openness_0 + _S682);
}

fn blocked_of_terms_0( _S683 : u32,  _S684 : u32,  _S685 : array<f32, i32(6)>,  _S686 : u32) -> Blocked_0
{
    var shares_0 : array<f32, i32(3)>;
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
        shares_0[share_4] = 0.0f;
        var term_0 : u32 = u32(0);
        for(;;)
        {
            if(term_0 < _S686)
            {
            }
            else
            {
                break;
            }
            shares_0[share_4] = shares_0[share_4] + openness_number_0(_S683, _S684 + share_4 * _S686 + term_0) * _S685[term_0];
            term_0 = term_0 + u32(1);
        }
        shares_0[share_4] = saturate(shares_0[share_4]);
        share_4 = share_4 + u32(1);
    }
    var blocked_2 : Blocked_0;
    blocked_2.by_warp_0 = shares_0[i32(0)] * shares_0[i32(2)];
    blocked_2.by_weft_0 = shares_0[i32(0)] * (1.0f - shares_0[i32(2)]);
    blocked_2.far_0 = shares_0[i32(1)];
    return blocked_2;
}

fn blocked_at_0( _S687 : u32,  _S688 : bool,  _S689 : bool,  _S690 : f32,  _S691 : f32) -> Blocked_0
{
    var _S692 : f32 = _S691 * openness_number_0(_S687, u32(158));
    var terms_2 : array<f32, i32(6)> = array<f32, i32(6)>( 1.0f, _S690, _S692, _S690 * _S690, _S690 * _S692, _S692 * _S692 );
    return blocked_of_terms_0(_S687, u32(60) + (select(u32(0), u32(2), _S689) + select(u32(1), u32(0), _S688)) * u32(18), terms_2, u32(6));
}

fn with_blocked_0( _S693 : u32,  _S694 : Blocked_0,  _S695 : YarnPoint_0,  _S696 : bool,  _S697 : f32) -> Blocked_0
{
    if(((_S695.hole_6) | (((_S695.is_warp_3) != _S696))))
    {
        return _S694;
    }
    var _S698 : Blocked_0 = blocked_at_0(_S693, _S696, _S695.back_7, _S695.surface_normal_0.z, _S695.height_11);
    var result_4 : Blocked_0;
    result_4.by_warp_0 = _S694.by_warp_0 + _S697 * _S698.by_warp_0;
    result_4.by_weft_0 = _S694.by_weft_0 + _S697 * _S698.by_weft_0;
    result_4.far_0 = _S694.far_0 + _S697 * _S698.far_0;
    return result_4;
}

struct CoverageTaps_0
{
     nodes_1 : array<u32, i32(9)>,
};

fn pyramid_level_0( _S699 : u32,  _S700 : f32) -> vec3<f32>
{
    var _S701 : u32 = fabrics_0[_S699].lobes_0.levels_0 + u32(4) * u32(min(_S700, fabrics_0[_S699].lobes_0.last_level_0));
    return vec3<f32>(table_number_0(_S701), table_number_0(_S701 + u32(1)), table_number_0(_S701 + u32(2)));
}

fn coverage_taps_0( _S702 : u32,  _S703 : Footprint_0,  _S704 : bool) -> CoverageTaps_0
{
    var _S705 : Lobes_std430_0 = fabrics_0[_S702].lobes_0;
    var _S706 : f32 = Footprint_spread_side_0(_S703) * fabrics_0[_S702].lobes_0.inverse_base_size_0;
    var _S707 : vec3<f32> = pyramid_level_0(_S702, floor(binary_logarithm_0(max(0.68000000715255737f * _S706, 1.0f))));
    var _S708 : f32 = 1.0f / max(_S706, 9.99999997475242708e-07f);
    var _S709 : vec2<f32> = vec2<f32>(families_0[fabrics_0[_S702].warp_0].inverse_period_0, families_0[fabrics_0[_S702].weft_0].inverse_period_0);
    var _S710 : vec2<f32> = _S703.centre_0 * _S709;
    var _S711 : vec2<f32> = vec2<f32>(min(max(sqrt(clamp(1.29999995231628418f * (1.0f - _S708 * _S708), 0.0f, 1.0f)), 0.3333333432674408f * _S708), 1.0f));
    var _S712 : vec2<f32> = _S703.dx_0 * _S709 * _S711;
    var _S713 : vec2<f32> = _S703.dy_0 * _S709 * _S711;
    var taps_4 : CoverageTaps_0;
    var number_3 : u32 = u32(0);
    for(;;)
    {
        if(number_3 < u32(9))
        {
        }
        else
        {
            break;
        }
        var _S714 : vec2<f32> = _S710 + vec2<f32>(TAP_OFFSETS_0[number_3].x) * _S712 + vec2<f32>(TAP_OFFSETS_0[number_3].y) * _S713;
        var _S715 : f32 = _S707.y;
        taps_4.nodes_1[number_3] = select(u32(0), _S705.face_nodes_0, _S704) + u32(wrapped_cell_0(_S714.y, _S707.z) * _S715 + wrapped_cell_0(_S714.x, _S715) + _S707.x);
        number_3 = number_3 + u32(1);
    }
    return taps_4;
}

fn joint_ratios_0( _S716 : u32,  _S717 : vec3<f32>,  _S718 : vec3<f32>,  _S719 : bool) -> vec2<f32>
{
    var _S720 : NodeTaps_0 = node_taps_of_0(_S718, u32(16));
    var _S721 : NodeTaps_0 = node_taps_of_0(_S717, u32(16));
    var _S722 : u32 = fabrics_0[_S716].lobes_0.joint_0 + u32(2) * (select(u32(0), u32(2), _S719) + select(u32(0), u32(1), (_S717.z) < 0.0f)) * u32(512);
    var _S723 : u32 = _S722 + u32(512);
    return clamp(vec2<f32>(1.0f) + vec2<f32>(dot(joint_terms_0(_S720, _S722, u32(0)), joint_terms_0(_S721, _S723, u32(0))), dot(joint_terms_0(_S720, _S722, u32(1)), joint_terms_0(_S721, _S723, u32(1)))), vec2<f32>(0.0f), vec2<f32>(4.0f));
}

fn coverage_of_pack_0( _S724 : u32,  _S725 : CoverageTaps_0,  _S726 : u32) -> vec4<f32>
{
    var number_4 : u32 = u32(0);
    var even_1 : u32 = u32(0);
    var odd_1 : u32 = u32(0);
    for(;;)
    {
        if(number_4 < u32(9))
        {
        }
        else
        {
            break;
        }
        var _S727 : u32 = words_0[fabrics_0[_S724].lobes_0.coverage_0 + _S725.nodes_1[number_4] * fabrics_0[_S724].lobes_0.packs_0 + _S726];
        var even_2 : u32 = even_1 + ((_S727 & (u32(16711935))));
        var odd_2 : u32 = odd_1 + ((((_S727 >> (u32(8)))) & (u32(16711935))));
        number_4 = number_4 + u32(1);
        even_1 = even_2;
        odd_1 = odd_2;
    }
    return bytes_of_sums_0(even_1, odd_1) / vec4<f32>(9.0f);
}

fn coverage_of_holes_0( _S728 : u32,  _S729 : CoverageTaps_0) -> f32
{
    var number_5 : u32 = u32(0);
    var total_0 : u32 = u32(0);
    for(;;)
    {
        if(number_5 < u32(9))
        {
        }
        else
        {
            break;
        }
        var total_1 : u32 = total_0 + ((((words_0[fabrics_0[_S728].lobes_0.coverage_holes_0 + _S729.nodes_1[number_5] / u32(4)] >> ((u32(8) * (_S729.nodes_1[number_5] % u32(4)))))) & (u32(255))));
        number_5 = number_5 + u32(1);
        total_0 = total_1;
    }
    return f32(total_0) / 9.0f;
}

fn prefiltered_hole_0( _S730 : u32,  _S731 : CoverageTaps_0,  _S732 : NodeTaps_0,  _S733 : bool) -> f32
{
    var _S734 : f32 = interpolate_table_0(_S732, fabrics_0[_S730].lobes_0.projected_area_0 + fabrics_0[_S730].lobes_0.packs_0, fabrics_0[_S730].lobes_0.packs_0 + u32(1)).x;
    return min(coverage_of_holes_0(_S730, _S731) * _S734 * _S734 * select(fabrics_0[_S730].lobes_0.front_hole_weight_0, fabrics_0[_S730].lobes_0.back_hole_weight_0, _S733), 1.0f);
}

fn prefiltered_components_0( _S735 : u32,  _S736 : Footprint_0,  _S737 : vec3<f32>,  _S738 : vec3<f32>,  _S739 : bool) -> Components_0
{
    var _S740 : CoverageTaps_0 = coverage_taps_0(_S735, _S736, _S739);
    var _S741 : NodeTaps_0 = node_taps_0(_S738);
    var view_nodes_0 : NodeTaps_0 = _S741;
    var _S742 : NodeTaps_0 = node_taps_0(_S737);
    var light_nodes_0 : NodeTaps_0 = _S742;
    var _S743 : u32 = select(u32(0), u32(1), _S739);
    view_nodes_0.nodes_0 = view_nodes_0.nodes_0 + vec4<u32>((_S743 * u32(256)));
    light_nodes_0.nodes_0 = light_nodes_0.nodes_0 + vec4<u32>(((u32(2) * _S743 + select(u32(0), u32(1), (_S737.z) < 0.0f)) * u32(256)));
    var _S744 : vec3<f32> = half_vector_0(_S737, _S738);
    var _S745 : vec2<f32> = joint_ratios_0(_S735, _S737, _S738, _S739);
    var _S746 : Lobes_std430_0 = fabrics_0[_S735].lobes_0;
    var _S747 : u32 = select(fabrics_0[_S735].lobes_0.front_warp_packs_0, fabrics_0[_S735].lobes_0.back_warp_packs_0, _S739);
    var sums_4 : Components_0;
    sums_4.diffuse_warp_0 = 0.0f;
    sums_4.diffuse_weft_0 = 0.0f;
    sums_4.specular_warp_0 = 0.0f;
    sums_4.specular_weft_0 = 0.0f;
    sums_4.light_visibility_1 = 0.0f;
    var pack_0 : u32 = u32(0);
    var total_2 : f32 = 0.0f;
    for(;;)
    {
        if(pack_0 < (_S746.packs_0))
        {
        }
        else
        {
            break;
        }
        var _S748 : vec4<f32> = coverage_of_pack_0(_S735, _S740, pack_0);
        var _S749 : vec4<f32> = interpolate_table_0(view_nodes_0, _S746.projected_area_0 + pack_0, _S746.packs_0 + u32(1));
        var _S750 : vec4<f32> = interpolate_table_0(light_nodes_0, _S746.light_visibility_0 + pack_0, _S746.packs_0) / vec4<f32>(255.0f);
        var _S751 : vec4<f32> = interpolate_table_0(light_nodes_0, _S746.irradiance_0 + pack_0, _S746.packs_0) * vec4<f32>(0.00124827399849892f);
        var _S752 : bool = pack_0 < _S747;
        var _S753 : f32 = families_0[select(fabrics_0[_S735].weft_0, fabrics_0[_S735].warp_0, _S752)].roughness_0;
        var number_6 : u32 = u32(0);
        var diffuse_0 : f32 = 0.0f;
        var specular_0 : f32 = 0.0f;
        var lit_0 : f32 = 0.0f;
        for(;;)
        {
            if(number_6 < u32(4))
            {
            }
            else
            {
                break;
            }
            var _S754 : Group_0 = group_at_0(_S746.moments_0 + u32(12) * (u32(4) * (_S743 * _S746.packs_0 + pack_0) + number_6), _S753);
            var _S755 : f32 = _S748[number_6] * _S749[number_6] * _S749[number_6] * _S754.weight_2;
            var diffuse_1 : f32 = diffuse_0 + _S755 * _S751[number_6];
            var specular_1 : f32 = specular_0 + _S755 * layer_value_0(_S754, _S744, _S737, _S738, fabrics_0[_S735].optical_depth_0) * _S750[number_6];
            var lit_1 : f32 = lit_0 + _S755 * _S750[number_6];
            var total_3 : f32 = total_2 + _S755;
            number_6 = number_6 + u32(1);
            diffuse_0 = diffuse_1;
            specular_0 = specular_1;
            lit_0 = lit_1;
            total_2 = total_3;
        }
        sums_4.diffuse_warp_0 = sums_4.diffuse_warp_0 + select(0.0f, diffuse_0, _S752);
        sums_4.diffuse_weft_0 = sums_4.diffuse_weft_0 + select(diffuse_0, 0.0f, _S752);
        sums_4.specular_warp_0 = sums_4.specular_warp_0 + select(0.0f, specular_0, _S752);
        sums_4.specular_weft_0 = sums_4.specular_weft_0 + select(specular_0, 0.0f, _S752);
        sums_4.light_visibility_1 = sums_4.light_visibility_1 + lit_0 * select(_S745.y, _S745.x, _S752);
        pack_0 = pack_0 + u32(1);
    }
    var _S756 : f32 = prefiltered_hole_0(_S735, _S740, view_nodes_0, _S739);
    sums_4.hole_2 = _S756;
    var _S757 : f32 = 1.0f - _S756;
    var _S758 : f32 = _S757 / max(total_2, 9.999999960041972e-13f);
    var _S759 : f32 = _S758 * _S745.x;
    sums_4.diffuse_warp_0 = sums_4.diffuse_warp_0 * _S759;
    var _S760 : f32 = _S758 * _S745.y;
    sums_4.diffuse_weft_0 = sums_4.diffuse_weft_0 * _S760;
    sums_4.specular_warp_0 = sums_4.specular_warp_0 * _S759;
    sums_4.specular_weft_0 = sums_4.specular_weft_0 * _S760;
    sums_4.light_visibility_1 = min(sums_4.light_visibility_1 * _S758, _S757);
    return sums_4;
}

fn albedos_over_0( _S761 : u32,  _S762 : Footprint_0,  _S763 : bool) -> FamilyAlbedos_0
{
    var _S764 : vec2<f32> = _S762.dx_0;
    var _S765 : vec2<f32> = _S762.dy_0;
    var _S766 : vec2<f32> = sqrt(_S764 * _S764 + _S765 * _S765);
    var _S767 : Stretch_0 = stretch_of_0(fabrics_0[_S761].warp_0, _S762.centre_0.x, _S766.x);
    var _S768 : Stretch_0 = stretch_of_0(fabrics_0[_S761].weft_0, _S762.centre_0.y, _S766.y);
    var albedos_9 : FamilyAlbedos_0;
    albedos_9.warp_5 = mean_albedos_0(fabrics_0[_S761].warp_0, fabrics_0[_S761].weft_0, _S767, _S768, _S763);
    albedos_9.weft_5 = mean_albedos_0(fabrics_0[_S761].weft_0, fabrics_0[_S761].warp_0, _S768, _S767, _S763);
    return albedos_9;
}

fn lobes_estimate_of_pass_0( _S769 : u32,  _S770 : Footprint_0,  _S771 : f32,  _S772 : vec2<f32>,  _S773 : vec3<f32>,  _S774 : vec3<f32>) -> Estimate_0
{
    var _S775 : f32;
    var _S776 : Regime_0 = regime_of_0(_S769, _S770, _S771);
    var _S777 : bool = (_S774.z) < 0.0f;
    var _S778 : vec3<f32> = to_face_frame_0(_S774, _S777);
    var _S779 : f32 = Footprint_spread_side_0(_S770);
    var _S780 : bool = varies_at_0(_S769, _S779);
    var _S781 : f32 = 1.0f - _S776.prefiltered_0;
    var _S782 : bool = ((_S781 > 0.0f) & (((_S780 | (((((families_0[fabrics_0[_S769].warp_0].quantities_0) > u32(1)) | (((families_0[fabrics_0[_S769].weft_0].quantities_0) > u32(1))))))))));
    var box_0 : Footprint_0 = _S770;
    var _S783 : vec3<f32> = vec3<f32>(0.0f);
    var _S784 : SurfacePoint_0 = SurfacePoint_x24init_0(false, false, u32(0), u32(0), 0.0f, _S783, _S783, 0.0f, 0.0f, 0.0f);
    var _S785 : Components_0 = no_components_0();
    var close_1 : CloseUp_0 = no_close_up_0();
    var _S786 : u32 = select(u32(1), u32(0), _S782);
    var points_1 : Components_0 = _S785;
    var central_weight_0 : f32 = 0.0f;
    var central_0 : SurfacePoint_0 = _S784;
    var central_place_0 : vec2<f32> = _S770.centre_0;
    var number_7 : u32 = _S786;
    for(;;)
    {
        var _S787 : f32 = f32(number_7);
        _S775 = _S776.points_0;
        if(_S787 < (_S776.points_0 + 1.0f))
        {
        }
        else
        {
            break;
        }
        var _S788 : bool = number_7 == u32(0);
        var _S789 : u32 = number_7 - u32(1);
        var _S790 : vec2<f32> = POINT_OFFSETS_0[select(_S789, u32(0), _S788)] + _S772;
        var _S791 : vec2<f32> = select_vector_0(_S788, vec2<f32>(0.0f), _S790 - round(_S790));
        var _S792 : vec2<f32> = _S770.centre_0 + vec2<f32>(_S791.x) * _S770.dx_0 + vec2<f32>(_S791.y) * _S770.dy_0;
        var _S793 : SearchQuality_0 = quality_of_0(select(_S776.threads_1, 0.0f, _S788));
        var _S794 : Hit_0 = first_hit_0(_S769, _S793, _S792.x, _S792.y, _S778, _S777);
        var _S795 : SurfacePoint_0 = surface_at_0(_S769, _S794.x_14, _S794.y_7, _S777);
        if(_S788)
        {
            var central_weight_1 : f32 = select(_S781, 0.0f, _S794.hole_5);
            var central_place_1 : vec2<f32> = vec2<f32>(_S794.x_14, _S794.y_7);
            box_0.centre_0 = mix(_S770.centre_0, central_place_1, vec2<f32>(central_weight_1));
            central_weight_0 = central_weight_1;
            central_0 = _S795;
            central_place_0 = central_place_1;
            number_7 = number_7 + u32(1);
            continue;
        }
        var _S796 : YarnPoint_0 = yarn_point_of_0(_S769, _S795, _S794.x_14, _S794.y_7, _S777, _S794.hole_5, _S779);
        var _S797 : f32 = min(_S776.points_0 - f32(_S789), 1.0f);
        var _S798 : Components_0 = with_added_0(points_1, components_of_point_0(_S769, _S793, _S796, _S773, _S774), _S797);
        if((fabrics_0[_S769].openness_0) != u32(4294967295))
        {
            close_1.warp_1 = with_blocked_0(_S769, close_1.warp_1, _S796, true, _S797);
            close_1.weft_1 = with_blocked_0(_S769, close_1.weft_1, _S796, false, _S797);
        }
        points_1 = _S798;
        number_7 = number_7 + u32(1);
    }
    close_1.weight_0 = _S781;
    var _S799 : f32 = max(_S775, 1.0f);
    close_1.warp_1 = scaled_0(close_1.warp_1, 1.0f / _S799);
    close_1.weft_1 = scaled_0(close_1.weft_1, 1.0f / _S799);
    var estimate_0 : Estimate_0;
    estimate_0.close_0 = close_1;
    estimate_0.components_0 = with_added_0(_S785, points_1, _S781 / _S799);
    if((_S776.prefiltered_0) > 0.0f)
    {
        var _S800 : Components_0 = prefiltered_components_0(_S769, _S770, to_face_frame_0(_S773, _S777), _S778, _S777);
        estimate_0.components_0 = with_added_0(estimate_0.components_0, _S800, _S776.prefiltered_0);
    }
    estimate_0.albedos_5 = albedos_over_0(_S769, box_0, _S777);
    if((_S780 & ((central_weight_0 > 0.0f))))
    {
        var _S801 : SurfacePoint_0 = central_0;
        var _S802 : Albedos_0;
        if(central_0.is_warp_0)
        {
            _S802 = estimate_0.albedos_5.warp_5;
        }
        else
        {
            _S802 = estimate_0.albedos_5.weft_5;
        }
        var _S803 : bool;
        if((fabrics_0[_S769].has_detail_0) != u32(0))
        {
            _S803 = has_hairs_0(_S769);
        }
        else
        {
            _S803 = false;
        }
        var _S804 : f32;
        if(_S803)
        {
            _S804 = hair_at_0(_S769, central_place_0, _S777, _S779).cover_0;
        }
        else
        {
            _S804 = 0.0f;
        }
        var _S805 : Albedos_0 = lerp_albedos_0(_S802, varied_at_0(_S769, central_0, _S802, central_place_0.x, central_place_0.y, _S777, _S779, _S804), central_weight_0);
        if(_S801.is_warp_0)
        {
            estimate_0.albedos_5.warp_5 = _S805;
        }
        else
        {
            estimate_0.albedos_5.weft_5 = _S805;
        }
    }
    return estimate_0;
}

fn scattered_by_0( _S806 : u32,  _S807 : Albedos_0,  _S808 : u32,  _S809 : vec3<f32>) -> Scattered_0
{
    var _S810 : u32 = u32(159) + u32(2) * _S808;
    var yarn_3 : Scattered_0;
    yarn_3.back_6 = _S809 * _S807.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S806, _S810)) * _S807.specular_reflect_0;
    yarn_3.through_0 = _S809 * _S807.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S806, _S810 + u32(1))) * _S807.specular_transmit_0;
    return yarn_3;
}

fn sent_0( _S811 : u32,  _S812 : u32,  _S813 : vec3<f32>,  _S814 : vec3<f32>,  _S815 : vec3<f32>,  _S816 : vec3<f32>,  _S817 : ptr<function, vec3<f32>>,  _S818 : ptr<function, vec3<f32>>)
{
    var _S819 : u32 = u32(146) + u32(4) * _S812;
    var _S820 : f32 = openness_number_0(_S811, _S819 + u32(1));
    var _S821 : f32 = openness_number_0(_S811, _S819 + u32(2));
    var _S822 : vec3<f32> = vec3<f32>(1.0f);
    var _S823 : vec3<f32> = _S822 - _S815 * vec3<f32>(openness_number_0(_S811, _S819));
    var _S824 : vec3<f32> = _S822 - _S816 * vec3<f32>(openness_number_0(_S811, _S819 + u32(3)));
    var _S825 : vec3<f32> = _S822 / (_S823 * _S824 - _S815 * _S816 * vec3<f32>((_S820 * _S821)));
    (*_S817) = (_S813 * _S824 + _S815 * vec3<f32>(_S820) * _S814) * _S825;
    (*_S818) = (_S814 * _S823 + _S816 * vec3<f32>(_S821) * _S813) * _S825;
    return;
}

fn face_sends_0( _S826 : u32,  _S827 : u32,  _S828 : Scattered_0,  _S829 : Scattered_0) -> FaceSends_0
{
    var _S830 : u32 = u32(2) * _S827;
    var _S831 : u32 = u32(142) + _S830;
    var _S832 : f32 = openness_number_0(_S826, _S831);
    var _S833 : f32 = openness_number_0(_S826, _S831 + u32(1));
    var _S834 : vec3<f32> = vec3<f32>((1.0f - _S832)) * _S828.back_6;
    var _S835 : vec3<f32> = vec3<f32>((1.0f - _S833)) * _S829.back_6;
    var sends_1 : FaceSends_0;
    var _S836 : u32 = u32(154) + _S830;
    var _S837 : f32 = openness_number_0(_S826, _S836);
    sends_1.blocks_warp_0 = _S837;
    var _S838 : f32 = openness_number_0(_S826, _S836 + u32(1));
    sends_1.blocks_weft_0 = _S838;
    sends_1.open_0 = _S837 * _S832 + _S838 * _S833;
    var _S839 : vec3<f32> = vec3<f32>(_S832) * _S828.back_6;
    var _S840 : vec3<f32> = vec3<f32>(_S833) * _S829.back_6;
    var _S841 : vec3<f32> = sends_1.sky_warp_0;
    var _S842 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S826, _S827, _S839, _S840, _S834, _S835, &(_S841), &(_S842));
    sends_1.sky_warp_0 = _S841;
    sends_1.sky_weft_0 = _S842;
    var _S843 : vec3<f32> = sends_1.crossing_warp_0;
    var _S844 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S826, _S827, _S828.through_0, _S829.through_0, _S834, _S835, &(_S843), &(_S844));
    sends_1.crossing_warp_0 = _S843;
    sends_1.crossing_weft_0 = _S844;
    return sends_1;
}

fn interior_of_0( _S845 : u32,  _S846 : vec3<f32>,  _S847 : bool) -> Interior_0
{
    var _S848 : Scattered_0 = scattered_by_0(_S845, table_albedos_0(families_0[fabrics_0[_S845].warp_0].colour_mean_0), u32(0), _S846);
    var _S849 : Scattered_0 = scattered_by_0(_S845, table_albedos_0(families_0[fabrics_0[_S845].weft_0].colour_mean_0), u32(1), _S846);
    var _S850 : FaceSends_0 = face_sends_0(_S845, select(u32(0), u32(1), _S847), _S848, _S849);
    var _S851 : FaceSends_0 = face_sends_0(_S845, select(u32(1), u32(0), _S847), _S848, _S849);
    var _S852 : vec3<f32> = vec3<f32>(_S850.blocks_warp_0);
    var _S853 : vec3<f32> = vec3<f32>(_S850.blocks_weft_0);
    var _S854 : vec3<f32> = _S852 * _S850.crossing_warp_0 + _S853 * _S850.crossing_weft_0;
    var _S855 : vec3<f32> = vec3<f32>(_S851.blocks_warp_0);
    var _S856 : vec3<f32> = vec3<f32>(_S851.blocks_weft_0);
    var _S857 : vec3<f32> = _S855 * _S851.crossing_warp_0 + _S856 * _S851.crossing_weft_0;
    var _S858 : f32 = 1.0f - _S850.open_0;
    var _S859 : f32 = 1.0f - _S851.open_0;
    var _S860 : vec3<f32> = vec3<f32>(1.0f);
    var _S861 : vec3<f32> = _S860 / (_S860 - _S854 * _S857 * vec3<f32>((_S858 * _S859)));
    var _S862 : vec3<f32> = _S857 * (vec3<f32>(_S850.open_0) + vec3<f32>(_S858) * (_S852 * _S850.sky_warp_0 + _S853 * _S850.sky_weft_0)) * _S861;
    var _S863 : vec3<f32> = _S854 * (vec3<f32>(_S851.open_0) + vec3<f32>(_S859) * (_S855 * _S851.sky_warp_0 + _S856 * _S851.sky_weft_0)) * _S861;
    var _S864 : FaceRadiance_0 = face_radiance_0(_S850, _S851.open_0, _S862, _S863);
    var _S865 : FaceRadiance_0 = face_radiance_0(_S851, _S850.open_0, _S863, _S862);
    var interior_1 : Interior_0;
    interior_1.warp_4 = _S864.warp_3;
    interior_1.weft_4 = _S864.weft_3;
    interior_1.leaked_1 = _S864.leaked_0;
    interior_1.far_1 = _S865.mean_1;
    interior_1.far_leaked_0 = _S865.leaked_0;
    return interior_1;
}

fn blocked_from_0( _S866 : u32,  _S867 : vec3<f32>,  _S868 : bool,  _S869 : bool) -> Blocked_0
{
    var terms_3 : array<f32, i32(6)>;
    view_terms_0(_S867, &(terms_3));
    return blocked_of_terms_0(_S866, (select(u32(0), u32(2), _S869) + select(u32(1), u32(0), _S868)) * u32(15), terms_3, u32(5));
}

fn warp_seen_from_0( _S870 : u32,  _S871 : vec3<f32>,  _S872 : bool) -> f32
{
    var terms_4 : array<f32, i32(6)>;
    view_terms_1(_S871, &(terms_4));
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
        var share_6 : f32 = share_5 + openness_number_0(_S870, u32(132) + select(u32(0), u32(5), _S872) + term_1) * terms_4[term_1];
        term_1 = term_1 + u32(1);
        share_5 = share_6;
    }
    return saturate(share_5);
}

fn bounced_of_families_0( _S873 : u32,  _S874 : FamilyAlbedos_0,  _S875 : vec3<f32>,  _S876 : Interior_0,  _S877 : Blocked_0,  _S878 : Blocked_0) -> Bounced_0
{
    return sum_of_0(bounced_by_0(_S877, scattered_by_0(_S873, _S874.warp_5, u32(0), _S875), _S876), bounced_by_0(_S878, scattered_by_0(_S873, _S874.weft_5, u32(1), _S875), _S876));
}

fn bounced_far_0( _S879 : u32,  _S880 : FamilyAlbedos_0,  _S881 : vec3<f32>,  _S882 : Interior_0,  _S883 : vec3<f32>,  _S884 : bool,  _S885 : f32,  _S886 : f32,  _S887 : f32) -> Bounced_0
{
    var _S888 : Blocked_0 = blocked_from_0(_S879, _S883, true, _S884);
    var _S889 : Blocked_0 = blocked_from_0(_S879, _S883, false, _S884);
    var _S890 : f32 = _S885 / max(1.0f - _S888.by_warp_0 - _S888.by_weft_0, 0.10000000149011612f);
    var _S891 : f32 = (0.0020000000949949f * warp_seen_from_0(_S879, _S883, _S884) + _S890) / (_S890 + _S886 / max(1.0f - _S889.by_warp_0 - _S889.by_weft_0, 0.10000000149011612f) + 0.0020000000949949f);
    var _S892 : f32 = 1.0f - _S887;
    return bounced_of_families_0(_S879, _S880, _S881, _S882, scaled_0(_S888, _S891 * _S892), scaled_0(_S889, (1.0f - _S891) * _S892));
}

fn bounced_over_0( _S893 : u32,  _S894 : Components_0,  _S895 : CloseUp_0,  _S896 : FamilyAlbedos_0,  _S897 : vec3<f32>,  _S898 : vec3<f32>) -> Bounced_0
{
    var _S899 : bool = (_S898.z) < 0.0f;
    var _S900 : Interior_0 = interior_of_0(_S893, _S897, _S899);
    var bounced_2 : Bounced_0 = bounced_far_0(_S893, _S896, _S897, _S900, to_face_frame_0(_S898, _S899), _S899, _S894.diffuse_warp_0, _S894.diffuse_weft_0, _S894.hole_2);
    if((_S895.weight_0) > 0.0f)
    {
        var _S901 : Bounced_0 = bounced_of_families_0(_S893, _S896, _S897, _S900, _S895.warp_1, _S895.weft_1);
        var _S902 : vec3<f32> = vec3<f32>(_S895.weight_0);
        bounced_2.reflected_0 = mix(bounced_2.reflected_0, _S901.reflected_0, _S902);
        bounced_2.transmitted_0 = mix(bounced_2.transmitted_0, _S901.transmitted_0, _S902);
    }
    return bounced_2;
}

fn composed_0( _S903 : u32,  _S904 : Components_0,  _S905 : CloseUp_0,  _S906 : FamilyAlbedos_0,  _S907 : vec3<f32>,  _S908 : vec3<f32>,  _S909 : vec3<f32>) -> vec3<f32>
{
    var _S910 : Albedos_0 = tinted_0(_S906.warp_5, _S907);
    var _S911 : Albedos_0 = tinted_0(_S906.weft_5, _S907);
    var _S912 : vec3<f32> = vec3<f32>(_S904.diffuse_warp_0);
    var _S913 : vec3<f32> = vec3<f32>(_S904.diffuse_weft_0);
    var _S914 : vec3<f32> = vec3<f32>(_S904.specular_warp_0);
    var _S915 : vec3<f32> = vec3<f32>(_S904.specular_weft_0);
    var _S916 : vec3<f32> = _S910.diffuse_reflect_0 * _S912 + _S911.diffuse_reflect_0 * _S913 + _S910.specular_reflect_0 * _S914 + _S911.specular_reflect_0 * _S915;
    var _S917 : f32 = _S909.z;
    var body_0 : vec3<f32>;
    if((_S908.z * _S917) < 0.0f)
    {
        body_0 = _S910.diffuse_transmit_0 * _S912 + _S911.diffuse_transmit_0 * _S913 + _S910.specular_transmit_0 * _S914 + _S911.specular_transmit_0 * _S915;
    }
    else
    {
        body_0 = _S916;
    }
    if((fabrics_0[_S903].openness_0) != u32(4294967295))
    {
        body_0 = body_0 + bounced_value_0(bounced_over_0(_S903, _S904, _S905, _S906, _S907, _S909), _S908, _S909);
    }
    var _S918 : f32 = fabrics_0[_S903].sheen_strength_0;
    if((fabrics_0[_S903].sheen_strength_0) <= 0.0f)
    {
        return body_0;
    }
    var _S919 : bool = _S917 < 0.0f;
    var _S920 : vec2<f32> = sheen_with_transmittance_0(to_face_frame_0(_S908, _S919), to_face_frame_0(_S909, _S919), _S918, fabrics_0[_S903].sheen_roughness_0);
    return vec3<f32>(_S920.y) * body_0 + vec3<f32>(((_S904.light_visibility_1 + _S904.hole_2) * _S920.x));
}

fn light_of_footprint_0( _S921 : u32,  _S922 : VisiblePoint_0,  _S923 : vec2<u32>,  _S924 : vec3<f32>) -> vec4<f32>
{
    var footprint_0 : Footprint_0;
    footprint_0.centre_0 = _S922.draft_0;
    footprint_0.dx_0 = _S922.draft_dx_0;
    footprint_0.dy_0 = _S922.draft_dy_0;
    var _S925 : vec2<f32> = fract(vec2<f32>(f32(((frame_record_0.pass_number_0) & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
    var _S926 : vec3<f32> = to_local_0(_S922, _S922.view_0);
    var _S927 : u32 = light_sample_count_0();
    var _S928 : vec3<f32> = vec3<f32>(0.0f);
    var number_8 : u32 = u32(0);
    var radiance_1 : vec3<f32> = _S928;
    var hole_7 : f32 = 0.0f;
    for(;;)
    {
        if(number_8 < (max(_S927, u32(1))))
        {
        }
        else
        {
            break;
        }
        var _S929 : f32;
        if(number_8 < _S927)
        {
            _S929 = visibility_at_0(number_8, _S923);
        }
        else
        {
            _S929 = 0.0f;
        }
        var _S930 : bool;
        if(_S929 <= 0.0f)
        {
            _S930 = number_8 > u32(0);
        }
        else
        {
            _S930 = false;
        }
        if(_S930)
        {
            number_8 = number_8 + u32(1);
            continue;
        }
        var _S931 : LightSample_0 = light_sample_0(number_8, _S923, _S922.position_0);
        var _S932 : vec3<f32> = to_local_0(_S922, _S931.towards_0);
        var _S933 : Estimate_0 = lobes_estimate_of_pass_0(_S921, footprint_0, 1.0f, _S925, _S932, _S926);
        radiance_1 = radiance_1 + vec3<f32>(_S929) * _S931.irradiance_1 * composed_0(_S921, _S933.components_0, _S933.close_0, _S933.albedos_5, _S924, _S932, _S926);
        hole_7 = _S933.components_0.hole_2;
        number_8 = number_8 + u32(1);
    }
    var _S934 : f32 = fabrics_0[_S921].sheen_strength_0;
    if((fabrics_0[_S921].sheen_strength_0) > 0.0f)
    {
        hole_7 = hole_7 * (1.0f - _S934 * sheen_lobe_0(abs(_S926.z), fabrics_0[_S921].sheen_roughness_0).z);
    }
    return vec4<f32>(radiance_1, 1.0f - hole_7);
}

@compute
@workgroup_size(8, 8, 1)
fn shade_lobes(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S935 : u32 = id_0.x;
    var _S936 : bool;
    if(_S935 >= (frame_record_0.width_0))
    {
        _S936 = true;
    }
    else
    {
        _S936 = (id_0.y) >= (frame_record_0.height_0);
    }
    if(_S936)
    {
        return;
    }
    var _S937 : u32 = id_0.y * frame_record_0.width_0 + _S935;
    var _S938 : u32 = layers_0[_S937].face_0;
    if((layers_0[_S937].face_0) == u32(0))
    {
        return;
    }
    var _S939 : u32 = _S938 - u32(1);
    var _S940 : u32 = fabric_of_0(_S939);
    var _S941 : vec2<u32> = id_0.xy;
    var _S942 : VisiblePoint_0 = visible_point_0(_S940, _S939, _S941);
    var _S943 : vec4<f32> = light_of_footprint_0(_S940, _S942, _S941, filtered_albedo_0(_S940, _S942));
    accumulate_0(_S937, _S943);
    return;
}

