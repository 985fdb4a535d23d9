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

@binding(6) @group(0) var<storage, read_write> visibilities_0 : array<f32>;

@binding(2) @group(0) var<storage, read> words_0 : array<u32>;

fn select_vector_0( condition_0 : bool,  yes_0 : vec3<f32>,  no_0 : vec3<f32>) -> vec3<f32>
{
    var chosen_0 : vec3<f32>;
    chosen_0[i32(0)] = select(no_0[i32(0)], yes_0[i32(0)], condition_0);
    chosen_0[i32(1)] = select(no_0[i32(1)], yes_0[i32(1)], condition_0);
    chosen_0[i32(2)] = select(no_0[i32(2)], yes_0[i32(2)], condition_0);
    return chosen_0;
}

var<private> TAP_OFFSETS_0 : array<vec2<f32>, i32(9)> = array<vec2<f32>, i32(9)>( vec2<f32>(-0.3333333432674408f, -0.3333333432674408f), vec2<f32>(-0.3333333432674408f, 0.0f), vec2<f32>(-0.3333333432674408f, 0.3333333432674408f), vec2<f32>(0.0f, -0.3333333432674408f), vec2<f32>(0.0f, 0.0f), vec2<f32>(0.0f, 0.3333333432674408f), vec2<f32>(0.3333333432674408f, -0.3333333432674408f), vec2<f32>(0.3333333432674408f, 0.0f), vec2<f32>(0.3333333432674408f, 0.3333333432674408f) );
var<private> PYRAMID_RADII_0 : array<f32, i32(4)> = array<f32, i32(4)>( 1.0f, 2.0f, 4.0f, 8.0f );
fn rsqrt_0( x_0 : f32) -> f32
{
    return 1.0f / sqrt(x_0);
}

fn select_vector_1( condition_1 : bool,  yes_1 : vec2<f32>,  no_1 : vec2<f32>) -> vec2<f32>
{
    var chosen_1 : vec2<f32>;
    chosen_1[i32(0)] = select(no_1[i32(0)], yes_1[i32(0)], condition_1);
    chosen_1[i32(1)] = select(no_1[i32(1)], yes_1[i32(1)], condition_1);
    return chosen_1;
}

fn firstbitlow_0( value_0 : u32) -> u32
{
    var _S1 : u32 = firstTrailingBit(value_0);
    return _S1;
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

fn scramble_0( value_1 : u32) -> u32
{
    var _S2 : u32 = value_1 * u32(747796405) + u32(2891336453);
    var _S3 : u32 = ((((_S2 >> ((((_S2 >> (u32(28)))) + u32(4))))) ^ (_S2))) * u32(277803737);
    return (((_S3 >> (u32(22)))) ^ (_S3));
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
    var _S4 : vec2<f32> = floor(place_0);
    var _S5 : vec2<f32> = place_0 - _S4;
    var _S6 : vec2<f32> = _S5 * _S5 * (vec2<f32>(3.0f) - vec2<f32>(2.0f) * _S5);
    var _S7 : u32 = u32(i32(_S4.x)) * u32(65536) + u32(i32(_S4.y));
    var _S8 : f32 = _S6.x;
    return mix(mix(uneven_corner_0(key_2, _S7), uneven_corner_0(key_2, _S7 + u32(65536)), _S8), mix(uneven_corner_0(key_2, _S7 + u32(1)), uneven_corner_0(key_2, _S7 + u32(65537)), _S8), _S6.y);
}

fn uniform_hash_0( thread_1 : u32,  cell_2 : u32,  stream_1 : u32) -> f32
{
    return (f32(((hash_bits_0(hash_key_0(thread_1, stream_1), cell_2)) >> (u32(9)))) + 0.5f) * 1.1920928955078125e-07f;
}

fn pixel_sequence_0( pixel_0 : vec2<u32>,  index_0 : u32,  stream_2 : u32) -> vec2<f32>
{
    var _S9 : u32 = pixel_0.x;
    var _S10 : u32 = pixel_0.y;
    return fract(vec2<f32>(uniform_hash_0(_S9, _S10, stream_2), uniform_hash_0(_S9, _S10, stream_2 + u32(1))) + vec2<f32>(f32((index_0 & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
}

fn scene_number_0( index_1 : u32) -> f32
{
    return (bitcast<f32>((scene_words_0[index_1])));
}

struct Choice_0
{
     index_2 : u32,
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
        var _S11 : u32 = (low_0 + high_0) / u32(2);
        if((scene_number_0(table_0 + _S11)) <= number_0)
        {
            low_0 = _S11;
        }
        else
        {
            high_0 = _S11;
        }
    }
    var _S12 : u32 = table_0 + low_0;
    var _S13 : f32 = scene_number_0(_S12);
    var _S14 : f32 = scene_number_0(_S12 + u32(1));
    var choice_0 : Choice_0;
    choice_0.index_2 = low_0;
    choice_0.remainder_0 = saturate((number_0 - _S13) / max(_S14 - _S13, 9.999999960041972e-13f));
    return choice_0;
}

fn mean_0( colour_0 : vec3<f32>) -> f32
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

fn sine_cosine_0( x_2 : f32) -> vec2<f32>
{
    var _S15 : f32 = floor(x_2 * 0.63661974668502808f + 0.5f);
    var _S16 : f32 = x_2 - _S15 * 1.5703125f - _S15 * 0.00048375129699707f - _S15 * 7.54979012640433211e-08f;
    var _S17 : f32 = _S16 * _S16;
    var _S18 : f32 = ((-0.00019515295571182f * _S17 + 0.00833216123282909f) * _S17 - 0.16666655242443085f) * _S17 * _S16 + _S16;
    var _S19 : f32 = ((0.00002443315679557f * _S17 - 0.00138873164542019f) * _S17 + 0.04166664555668831f) * _S17 * _S17 - 0.5f * _S17 + 1.0f;
    var _S20 : u32 = (u32(i32(_S15)) & (u32(3)));
    var _S21 : vec2<f32> = select_vector_1(((_S20 & (u32(1)))) != u32(0), vec2<f32>(_S19, _S18), vec2<f32>(_S18, _S19));
    var _S22 : f32 = _S21.x;
    var _S23 : f32 = _S21.y;
    return vec2<f32>(select(_S22, - _S22, ((_S20 & (u32(2)))) != u32(0)), select(_S23, - _S23, (((_S20 + u32(1)) & (u32(2)))) != u32(0)));
}

struct Light_0
{
     is_point_0 : u32,
     x_3 : f32,
     y_1 : f32,
     z_1 : f32,
     red_0 : f32,
     green_0 : f32,
     blue_0 : f32,
};

fn scene_light_0( first_1 : u32) -> Light_0
{
    var record_1 : Light_0;
    record_1.is_point_0 = scene_words_0[first_1];
    record_1.x_3 = (bitcast<f32>((scene_words_0[first_1 + u32(1)])));
    record_1.y_1 = (bitcast<f32>((scene_words_0[first_1 + u32(2)])));
    record_1.z_1 = (bitcast<f32>((scene_words_0[first_1 + u32(3)])));
    record_1.red_0 = (bitcast<f32>((scene_words_0[first_1 + u32(4)])));
    record_1.green_0 = (bitcast<f32>((scene_words_0[first_1 + u32(5)])));
    record_1.blue_0 = (bitcast<f32>((scene_words_0[first_1 + u32(6)])));
    return record_1;
}

fn inverse_of_0( component_0 : f32) -> f32
{
    return 1.0f / select(9.99999968265522539e-21f, component_0, (abs(component_0)) > 9.99999968265522539e-21f);
}

fn meets_node_0( node_0 : u32,  origin_0 : vec3<f32>,  inverse_0 : vec3<f32>,  nearest_0 : f32,  farthest_0 : f32) -> bool
{
    var _S24 : u32 = u32(6) * (node_0 - u32(1));
    var _S25 : vec3<f32> = (vec3<f32>(scene_number_0(_S24), scene_number_0(_S24 + u32(1)), scene_number_0(_S24 + u32(2))) - origin_0) * inverse_0;
    var _S26 : vec3<f32> = (vec3<f32>(scene_number_0(_S24 + u32(3)), scene_number_0(_S24 + u32(4)), scene_number_0(_S24 + u32(5))) - origin_0) * inverse_0;
    var _S27 : vec3<f32> = min(_S25, _S26);
    var _S28 : vec3<f32> = max(_S25, _S26) * vec3<f32>(1.0000004768371582f);
    return (max(max(_S27.x, _S27.y), max(_S27.z, nearest_0))) <= (min(min(_S28.x, _S28.y), min(_S28.z, farthest_0)));
}

fn following_node_0( node_1 : u32) -> u32
{
    var _S29 : u32 = node_1 + u32(1);
    var _S30 : u32 = (_S29 >> ((firstbitlow_0(_S29))));
    return select(_S30, u32(0), _S30 == u32(1));
}

struct Hit_0
{
     face_2 : u32,
     distance_0 : f32,
     weight_b_0 : f32,
     weight_c_0 : f32,
};

fn meet_face_0( face_3 : u32,  origin_1 : vec3<f32>,  direction_0 : vec3<f32>) -> Hit_0
{
    var _S31 : u32 = u32(3) * face_3;
    var _S32 : vec3<f32> = position_of_0(vertex_at_0(_S31));
    var _S33 : vec3<f32> = position_of_0(vertex_at_0(_S31 + u32(1))) - _S32;
    var _S34 : vec3<f32> = position_of_0(vertex_at_0(_S31 + u32(2))) - _S32;
    var _S35 : vec3<f32> = cross(direction_0, _S34);
    var _S36 : f32 = dot(_S33, _S35);
    var _S37 : bool = (abs(_S36)) > 1.00000000317107685e-30f;
    var _S38 : f32 = 1.0f / select(1.00000000317107685e-30f, _S36, _S37);
    var _S39 : vec3<f32> = origin_1 - _S32;
    var _S40 : vec3<f32> = cross(_S39, _S33);
    var hit_0 : Hit_0;
    var _S41 : f32 = dot(_S39, _S35) * _S38;
    hit_0.weight_b_0 = _S41;
    var _S42 : f32 = dot(direction_0, _S40) * _S38;
    hit_0.weight_c_0 = _S42;
    hit_0.distance_0 = dot(_S34, _S40) * _S38;
    hit_0.face_2 = select(u32(4294967295), face_3, ((((((_S41 >= 0.0f) & ((_S42 >= 0.0f)))) & (((_S41 + _S42) <= 1.0f)))) & (_S37)));
    return hit_0;
}

struct VisiblePoint_0
{
     position_0 : vec3<f32>,
     view_0 : vec3<f32>,
     axis_x_0 : vec3<f32>,
     axis_y_0 : vec3<f32>,
     normal_0 : vec3<f32>,
     face_normal_0 : vec3<f32>,
     uv_0 : vec2<f32>,
     draft_per_uv_0 : vec2<f32>,
     draft_0 : vec2<f32>,
     draft_dx_0 : vec2<f32>,
     draft_dy_0 : vec2<f32>,
};

fn to_local_0( point_0 : VisiblePoint_0,  direction_1 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(dot(direction_1, point_0.axis_x_0), dot(direction_1, point_0.axis_y_0), dot(direction_1, point_0.normal_0));
}

fn to_face_frame_0( direction_2 : vec3<f32>,  back_2 : bool) -> vec3<f32>
{
    var _S43 : f32 = direction_2.z;
    return vec3<f32>(direction_2.xy, select(_S43, - _S43, back_2));
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

fn turns_and_remainder_0( family_1 : u32,  index_3 : f32) -> vec2<f32>
{
    var _S44 : f32 = floor(fma(index_3, families_0[family_1].inverse_count_0, families_0[family_1].half_inverse_count_0));
    return vec2<f32>(_S44, fma(- _S44, families_0[family_1].count_0, index_3));
}

struct Cell_0
{
     thread_2 : u32,
     across_0 : f32,
     half_width_1 : f32,
     below_0 : f32,
     above_0 : f32,
};

fn locate_alike_0( family_2 : u32,  position_1 : f32) -> Cell_0
{
    var _S45 : f32 = floor(position_1 * families_0[family_2].inverse_size_0);
    var cell_3 : Cell_0;
    var _S46 : f32 = fma(- _S45, families_0[family_2].size_0, position_1);
    cell_3.below_0 = _S46;
    cell_3.above_0 = families_0[family_2].size_0 - _S46;
    cell_3.across_0 = _S46 - 0.5f * families_0[family_2].size_0;
    cell_3.half_width_1 = families_0[family_2].half_width_0;
    cell_3.thread_2 = u32(clamp(turns_and_remainder_0(family_2, _S45).y, 0.0f, families_0[family_2].count_0 - 1.0f));
    return cell_3;
}

fn table_number_0( index_4 : u32) -> f32
{
    return (bitcast<f32>((words_0[index_4])));
}

fn locate_varied_0( family_3 : u32,  position_2 : f32) -> Cell_0
{
    var turns_0 : f32 = (position_2 - families_0[family_3].start_0) * families_0[family_3].inverse_period_0;
    var turns_1 : f32 = turns_0 - floor(turns_0);
    var _S47 : f32 = turns_1 * families_0[family_3].period_0;
    var thread_3 : u32 = words_0[families_0[family_3].first_thread_table_0 + u32(clamp(turns_1 * families_0[family_3].bins_0, 0.0f, families_0[family_3].bins_0 - 1.0f))];
    var _S48 : u32 = min(thread_3 + select(u32(0), u32(1), _S47 >= (table_number_0(families_0[family_3].place_table_0 + thread_3 * u32(4) + u32(1)))), u32(families_0[family_3].count_0) - u32(1));
    var _S49 : u32 = families_0[family_3].place_table_0 + _S48 * u32(4);
    var cell_4 : Cell_0;
    cell_4.thread_2 = _S48;
    cell_4.below_0 = _S47 - table_number_0(_S49);
    cell_4.above_0 = table_number_0(_S49 + u32(1)) - _S47;
    cell_4.across_0 = _S47 - table_number_0(_S49 + u32(2));
    cell_4.half_width_1 = table_number_0(_S49 + u32(3));
    return cell_4;
}

fn locate_0( family_4 : u32,  position_3 : f32) -> Cell_0
{
    if((families_0[family_4].is_alike_0) != u32(0))
    {
        return locate_alike_0(family_4, position_3);
    }
    return locate_varied_0(family_4, position_3);
}

fn irregular_thread_0( family_5 : u32,  position_4 : f32,  cell_5 : Cell_0) -> f32
{
    return floor((position_4 - cell_5.across_0) / families_0[family_5].period_0) * families_0[family_5].count_0 + f32(cell_5.thread_2);
}

fn irregular_entry_0( row_0 : u32,  column_0 : f32) -> vec4<u32>
{
    var _S50 : u32 = row_0 + u32(4) * ((u32(i32(column_0)) & (u32(1023))));
    return vec4<u32>(words_0[_S50], words_0[_S50 + u32(1)], words_0[_S50 + u32(2)], words_0[_S50 + u32(3)]);
}

fn irregular_integral_0( family_6 : u32,  threads_0 : u32,  begin_0 : f32,  steps_0 : f32) -> vec4<f32>
{
    var _S51 : u32 = families_0[family_6].irregular_table_0 + threads_0 * u32(4096);
    var _S52 : f32 = begin_0 + steps_0;
    var _S53 : f32 = floor(begin_0);
    var _S54 : vec4<u32> = irregular_entry_0(_S51, _S53);
    var _S55 : f32 = floor(_S52);
    var _S56 : vec4<u32> = irregular_entry_0(_S51, _S55);
    return vec4<f32>(vec4<i32>(_S56 - _S54)) + (vec4<f32>(vec4<i32>(irregular_entry_0(_S51, _S55 + 1.0f) - _S56)) * vec4<f32>((_S52 - _S55)) - vec4<f32>(vec4<i32>(irregular_entry_0(_S51, _S53 + 1.0f) - _S54)) * vec4<f32>((begin_0 - _S53)));
}

fn irregular_units_0( family_7 : u32) -> vec4<f32>
{
    return vec4<f32>(families_0[family_7].irregular_thickness_0, families_0[family_7].irregular_cover_0, families_0[family_7].irregular_tone_0, families_0[family_7].irregular_nep_0);
}

fn irregular_at_0( family_8 : u32,  key_3 : u32,  number_1 : f32,  along_0 : f32) -> vec4<f32>
{
    var _S57 : f32 = floor(number_1 / 64.0f);
    var _S58 : u32 = hash_bits_0(key_3, u32(i32(_S57)));
    var _S59 : u32 = ((_S58 & (u32(127)))) + u32(number_1 - 64.0f * _S57);
    var _S60 : f32 = along_0 / 2.0f - 0.5f + f32((_S58 >> (u32(22))));
    var sums_1 : vec4<f32> = vec4<f32>(0.0f);
    var side_0 : u32 = u32(0);
    for(;;)
    {
        if(side_0 < u32(2))
        {
        }
        else
        {
            break;
        }
        var _S61 : vec4<f32> = irregular_integral_0(family_8, _S59 + side_0, _S60, 1.0f) - sums_1;
        var _S62 : u32 = side_0 + u32(1);
        sums_1 = _S61;
        side_0 = _S62;
    }
    return sums_1 * irregular_units_0(family_8);
}

struct Footprint_0
{
     centre_0 : vec2<f32>,
     dx_0 : vec2<f32>,
     dy_0 : vec2<f32>,
};

fn Footprint_spread_side_0( this_0 : Footprint_0) -> f32
{
    var _S63 : vec2<f32> = this_0.dx_0;
    var _S64 : vec2<f32> = this_0.dy_0;
    return sqrt(0.5f * (dot(_S63, _S63) + dot(_S64, _S64)));
}

fn natural_logarithm_0( x_4 : f32) -> f32
{
    var _S65 : u32 = (bitcast<u32>((x_4)));
    var m_0 : f32 = (bitcast<f32>(((((_S65 & (u32(8388607)))) | (u32(1056964608))))));
    var _S66 : bool = m_0 < 0.70710676908493042f;
    var exponent_0 : f32 = f32(i32((_S65 >> (u32(23)))) - i32(126)) - select(0.0f, 1.0f, _S66);
    var m_1 : f32 = select(m_0, m_0 + m_0, _S66) - 1.0f;
    var _S67 : f32 = m_1 * m_1;
    return m_1 + (((((((((0.07037683576345444f * m_1 - 0.11514610052108765f) * m_1 + 0.11676998436450958f) * m_1 - 0.12420140951871872f) * m_1 + 0.14249323308467865f) * m_1 - 0.16668057441711426f) * m_1 + 0.20000714063644409f) * m_1 - 0.24999994039535522f) * m_1 + 0.33333331346511841f) * m_1 * _S67 - exponent_0 * 0.00021219444170129f - 0.5f * _S67) + exponent_0 * 0.693359375f;
}

fn binary_logarithm_0( x_5 : f32) -> f32
{
    return natural_logarithm_0(x_5) * 1.4426950216293335f;
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

fn plane_at_0( first_2 : u32) -> Plane_0
{
    var record_2 : Plane_0;
    record_2.warp_1 = words_0[first_2];
    record_2.weft_1 = words_0[first_2 + u32(1)];
    record_2.run_words_1 = words_0[first_2 + u32(2)];
    record_2.ends_2 = words_0[first_2 + u32(3)];
    record_2.end_numbers_0 = words_0[first_2 + u32(4)];
    record_2.pick_numbers_0 = words_0[first_2 + u32(5)];
    record_2.max_heights_1 = words_0[first_2 + u32(6)];
    record_2.max_height_columns_1 = words_0[first_2 + u32(7)];
    record_2.height_low_1 = (bitcast<f32>((words_0[first_2 + u32(8)])));
    record_2.height_high_1 = (bitcast<f32>((words_0[first_2 + u32(9)])));
    record_2.front_level_0 = (bitcast<f32>((words_0[first_2 + u32(10)])));
    record_2.back_level_0 = (bitcast<f32>((words_0[first_2 + u32(11)])));
    record_2.start_x_0 = (bitcast<f32>((words_0[first_2 + u32(12)])));
    record_2.start_y_0 = (bitcast<f32>((words_0[first_2 + u32(13)])));
    record_2.fine_x_0 = (bitcast<f32>((words_0[first_2 + u32(14)])));
    record_2.fine_y_0 = (bitcast<f32>((words_0[first_2 + u32(15)])));
    return record_2;
}

struct Crossing_0
{
     warp_2 : Cell_0,
     weft_2 : Cell_0,
     warp_word_0 : u32,
     weft_word_0 : u32,
     warp_above_0 : bool,
};

fn crossing_at_0( plane_0 : Plane_0,  x_6 : f32,  y_2 : f32,  back_3 : bool) -> Crossing_0
{
    var crossing_0 : Crossing_0;
    crossing_0.warp_2 = locate_0(plane_0.warp_1, x_6 - plane_0.start_x_0);
    crossing_0.weft_2 = locate_0(plane_0.weft_1, y_2 - plane_0.start_y_0);
    var _S68 : u32 = plane_0.run_words_1 + u32(2) * (crossing_0.weft_2.thread_2 * plane_0.ends_2 + crossing_0.warp_2.thread_2);
    var _S69 : u32 = words_0[_S68];
    crossing_0.warp_word_0 = _S69;
    crossing_0.weft_word_0 = words_0[_S68 + u32(1)];
    crossing_0.warp_above_0 = (((_S69 & (u32(1)))) == u32(1)) != back_3;
    return crossing_0;
}

fn cell_maximum_0( plane_1 : Plane_0,  crossing_1 : Crossing_0) -> f32
{
    var _S70 : u32 = select(plane_1.weft_1, plane_1.warp_1, crossing_1.warp_above_0);
    return f32((select(crossing_1.weft_word_0, crossing_1.warp_word_0, crossing_1.warp_above_0) >> (u32(28)))) * families_0[_S70].height_scale_0 * families_0[_S70].level_0;
}

fn bounds_in_0( plane_2 : Plane_0,  x_7 : f32,  y_3 : f32,  back_4 : bool,  right_0 : bool,  up_0 : bool) -> vec3<f32>
{
    var _S71 : Crossing_0 = crossing_at_0(plane_2, x_7, y_3, back_4);
    return vec3<f32>(cell_maximum_0(plane_2, _S71), select(_S71.warp_2.below_0, _S71.warp_2.above_0, right_0), select(_S71.weft_2.below_0, _S71.weft_2.above_0, up_0));
}

fn hole_edge_0( cell_6 : Cell_0,  forwards_0 : bool) -> f32
{
    var _S72 : f32 = select(- cell_6.across_0, cell_6.across_0, forwards_0);
    var _S73 : f32 = - cell_6.half_width_1;
    return select(select(cell_6.half_width_1, _S73, _S72 < _S73) - _S72, 2.0f * select(cell_6.below_0, cell_6.above_0, forwards_0) + _S72 - cell_6.half_width_1, _S72 >= (cell_6.half_width_1));
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
    var _S74 : bool = (abs(crossing_2.warp_2.across_0)) < (crossing_2.warp_2.half_width_1);
    var shown_0 : Shown_0;
    var _S75 : bool = !((abs(crossing_2.weft_2.across_0)) < (crossing_2.weft_2.half_width_1));
    var _S76 : bool = (_S74 & (((_S75 | ((crossing_2.warp_above_0))))));
    shown_0.is_warp_0 = _S76;
    shown_0.hole_0 = ((!_S74) & (_S75));
    var _S77 : u32 = select(crossing_2.weft_word_0, crossing_2.warp_word_0, _S76);
    shown_0.word_0 = _S77;
    shown_0.on_top_0 = (((_S77 & (u32(1)))) == u32(1)) != back_5;
    return shown_0;
}

fn select_cell_0( is_first_0 : bool,  first_3 : Cell_0,  second_0 : Cell_0) -> Cell_0
{
    var cell_7 : Cell_0;
    cell_7.thread_2 = select(second_0.thread_2, first_3.thread_2, is_first_0);
    cell_7.across_0 = select(second_0.across_0, first_3.across_0, is_first_0);
    cell_7.half_width_1 = select(second_0.half_width_1, first_3.half_width_1, is_first_0);
    cell_7.below_0 = select(second_0.below_0, first_3.below_0, is_first_0);
    cell_7.above_0 = select(second_0.above_0, first_3.above_0, is_first_0);
    return cell_7;
}

fn boundary_0( family_9 : u32,  thread_4 : u32,  step_0 : i32) -> f32
{
    var _S78 : vec2<f32> = turns_and_remainder_0(family_9, f32(i32(thread_4) + step_0));
    return fma(_S78.x, families_0[family_9].period_0, table_number_0(families_0[family_9].place_table_0 + u32(_S78.y) * u32(4)));
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
    var _S79 : u32 = families_0[family_11].bend_table_0 + select(thread_6 * u32(4), u32(0), (families_0[family_11].is_alike_0) != u32(0));
    var bend_0 : Bend_0;
    bend_0.sine_0 = table_number_0(_S79);
    bend_0.half_tangent_0 = table_number_0(_S79 + u32(1));
    bend_0.arc_0 = table_number_0(_S79 + u32(2));
    return bend_0;
}

struct Run_0
{
     distance_1 : f32,
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
    var _S80 : i32 = i32((((word_1 >> (u32(1)))) & (u32(127))));
    var _S81 : i32 = i32((((word_1 >> (u32(8)))) & (u32(127))));
    var _S82 : i32 = i32((((word_1 >> (u32(15)))) & (u32(63))));
    var _S83 : i32 = i32((((word_1 >> (u32(21)))) & (u32(63))));
    var run_0 : Run_0;
    var _S84 : bool = ((((word_1 >> (u32(27)))) & (u32(1)))) == u32(1);
    run_0.straight_0 = _S84;
    var _S85 : i32 = - _S80;
    var _S86 : f32 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_2, _S85, i32(0));
    run_0.from_start_0 = _S86;
    var _S87 : i32 = _S81 + i32(1);
    var _S88 : f32 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_2, i32(1), _S87);
    run_0.to_end_0 = _S88;
    var _S89 : bool = _S86 < _S88;
    run_0.near_start_0 = _S89;
    var _S90 : i32 = select(_S87, _S85 - _S82, _S89);
    var _S91 : i32 = select(_S87 + _S83, _S85, _S89);
    run_0.bend_1 = bend_of_0(own_0, thread_7);
    run_0.distance_1 = select(min(_S86, _S88), 1.0e+06f, _S84);
    run_0.reach_0 = min(0.5f * (_S86 + _S88), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_2, _S90, _S91), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S80 == i32(0);
    run_0.last_crossing_0 = _S81 == i32(0);
    return run_0;
}

fn square_1( x_8 : f32) -> f32
{
    return x_8 * x_8;
}

struct Section_0
{
     across_1 : f32,
     drop_0 : f32,
     slope_0 : f32,
};

fn section_at_0( cell_8 : Cell_0) -> Section_0
{
    var _S92 : f32 = cell_8.half_width_1 * 1.0154266357421875f;
    var section_0 : Section_0;
    var _S93 : f32 = clamp(cell_8.across_0, - cell_8.half_width_1, cell_8.half_width_1);
    section_0.across_1 = _S93;
    var _S94 : f32 = _S92 * _S92 - square_1(_S93);
    var _S95 : f32 = rsqrt_0(_S94);
    section_0.drop_0 = _S92 - _S94 * _S95;
    section_0.slope_0 = - _S93 * _S95;
    return section_0;
}

fn edge_drop_0( family_12 : u32,  thread_8 : u32,  step_1 : i32) -> f32
{
    return table_number_0(families_0[family_12].bend_table_0 + select(u32(turns_and_remainder_0(family_12, f32(i32(thread_8) + step_1)).y) * u32(4), u32(0), (families_0[family_12].is_alike_0) != u32(0)) + u32(3));
}

fn dive_0( other_1 : u32,  shown_1 : Shown_0,  run_1 : Run_0,  crossed_1 : Cell_0) -> vec3<f32>
{
    var _S96 : bool = (crossed_1.below_0) < (crossed_1.above_0);
    var _S97 : f32 = min(crossed_1.below_0, crossed_1.above_0);
    var _S98 : f32 = select(crossed_1.above_0 + crossed_1.across_0, crossed_1.below_0 - crossed_1.across_0, _S96) - crossed_1.half_width_1;
    var _S99 : bool = select(run_1.last_crossing_0, run_1.first_crossing_0, _S96);
    var _S100 : f32;
    if(shown_1.on_top_0)
    {
        _S100 = 0.0f;
    }
    else
    {
        _S100 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_2, i32(0));
    }
    var _S101 : f32;
    if((shown_1.on_top_0) != _S99)
    {
        _S101 = 0.0f;
    }
    else
    {
        _S101 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_2, select(i32(1), i32(-1), _S96));
    }
    var _S102 : f32 = 2.0f * _S98;
    var _S103 : f32 = 1.0f / max(_S102, 9.999999960041972e-13f);
    var _S104 : f32 = clamp((_S98 - _S97) * _S103, 0.0f, 1.0f);
    var _S105 : f32 = clamp((0.44999998807907104f - _S102 / crossed_1.half_width_1) * 4.0000004768371582f, 0.0f, 1.0f);
    return vec3<f32>(_S100 + (_S101 - _S100) * (_S104 * _S104 * (3.0f - 2.0f * _S104)), (_S100 - _S101) * (6.0f * _S104 * (1.0f - _S104) * _S103) * select(-1.0f, 1.0f, _S96), _S105 * _S105 * (3.0f - 2.0f * _S105));
}

struct PlaneHere_0
{
     plane_3 : Plane_0,
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
     height_2 : f32,
     slope_across_0 : f32,
     slope_along_0 : f32,
     dive_1 : vec3<f32>,
     slope_x_0 : f32,
     slope_y_0 : f32,
};

fn sample_in_0( here_1 : PlaneHere_0,  x_9 : f32,  y_4 : f32,  back_6 : bool) -> Sample_0
{
    var sample_0 : Sample_0;
    sample_0.here_0 = here_1;
    var _S106 : Crossing_0 = crossing_at_0(here_1.plane_3, x_9, y_4, back_6);
    sample_0.crossing_3 = _S106;
    var _S107 : Shown_0 = shown_at_0(_S106, back_6);
    sample_0.shown_2 = _S107;
    var _S108 : u32 = select(here_1.plane_3.weft_1, here_1.plane_3.warp_1, _S107.is_warp_0);
    var _S109 : u32 = select(here_1.plane_3.warp_1, here_1.plane_3.weft_1, _S107.is_warp_0);
    var _S110 : Cell_0 = select_cell_0(_S107.is_warp_0, sample_0.crossing_3.warp_2, sample_0.crossing_3.weft_2);
    var _S111 : Cell_0 = select_cell_0(_S107.is_warp_0, sample_0.crossing_3.weft_2, sample_0.crossing_3.warp_2);
    var _S112 : Run_0 = unpack_0(_S108, _S109, _S110.thread_2, _S111, _S107.word_0);
    var _S113 : Section_0 = section_at_0(_S110);
    var _S114 : bool = ((_S107.on_top_0) & (((_S112.distance_1) < (_S113.drop_0 * _S112.bend_1.sine_0))));
    var _S115 : f32 = select(-1.0f, 1.0f, ((_S107.on_top_0) & ((!_S114))));
    var _S116 : f32 = select(_S112.reach_0, _S112.other_reach_0, _S114);
    var _S117 : f32 = select(max(_S116 - _S112.distance_1, 0.0f), _S116 + _S112.distance_1, _S114);
    var _S118 : f32 = _S116 / _S112.bend_1.sine_0 - _S115 * _S113.drop_0;
    var _S119 : f32 = _S117 * _S117;
    var _S120 : f32 = max(_S118 * _S118 - _S119, 9.99999968265522539e-21f);
    var _S121 : f32 = rsqrt_0(_S120);
    var _S122 : f32 = _S119 / (_S120 * _S121 + _S118);
    var _S123 : bool = _S117 > 0.0f;
    var _S124 : f32 = select(-1.0f, 1.0f, _S107.on_top_0) * select(-1.0f, 1.0f, _S112.near_start_0);
    var _S125 : f32 = _S113.slope_0 * select(1.0f, _S118 * _S121, _S123);
    sample_0.slope_across_0 = _S125;
    var _S126 : f32 = select(0.0f, _S124 * _S117 * _S121, _S123);
    sample_0.slope_along_0 = _S126;
    var _S127 : vec3<f32> = dive_0(_S109, _S107, _S112, _S111);
    sample_0.dive_1 = _S127;
    sample_0.height_2 = select(families_0[_S108].height_scale_0 * _S115, 0.0f, _S112.straight_0) * (_S116 * _S112.bend_1.half_tangent_0 - _S122) - families_0[_S108].height_scale_0 * _S113.drop_0 - _S127.x + here_1.level_1;
    var _S128 : f32 = families_0[_S108].height_scale_0 * _S125;
    var _S129 : f32 = families_0[_S108].height_scale_0 * _S126 - _S127.y;
    sample_0.slope_x_0 = select(_S129, _S128, _S107.is_warp_0);
    sample_0.slope_y_0 = select(_S128, _S129, _S107.is_warp_0);
    sample_0.run_2 = _S112;
    sample_0.section_1 = _S113;
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

fn step_control_0( direction_3 : vec2<f32>,  step_3 : f32) -> StepControl_0
{
    var control_0 : StepControl_0;
    control_0.step_2 = step_3;
    control_0.epsilon_0 = 0.00499999988824129f * step_3;
    var _S130 : f32 = direction_3.x;
    control_0.per_x_0 = 1.0f / max(abs(_S130), 9.99999971718068537e-10f);
    var _S131 : f32 = direction_3.y;
    control_0.per_y_0 = 1.0f / max(abs(_S131), 9.99999971718068537e-10f);
    control_0.right_1 = _S130 > 0.0f;
    control_0.up_1 = _S131 > 0.0f;
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
    var _S132 : f32 = select(- cell_9.across_0, cell_9.across_0, forwards_1);
    var _S133 : f32 = select(cell_9.below_0, cell_9.above_0, forwards_1);
    var _S134 : f32 = - cell_9.half_width_1;
    var _S135 : bool = _S132 < _S134;
    var _S136 : bool = _S132 >= (cell_9.half_width_1);
    var _S137 : bool = (((lengthwise_0 & ((!select(run_3.first_crossing_0, run_3.last_crossing_0, forwards_1))))) & ((!shown_3.hole_0)));
    var _S138 : f32 = select(cell_9.half_width_1, _S134, _S135) - _S132;
    var _S139 : f32 = select(_S133, 2.0f * _S133 + _S132 - cell_9.half_width_1, ((shown_3.hole_0) | (((_S137 & ((!shown_3.on_top_0)))))));
    if((((_S137 & ((shown_3.on_top_0)))) & ((!((select(run_3.last_crossing_0, run_3.first_crossing_0, forwards_1) & (_S135)))))))
    {
        return select(run_3.from_start_0, run_3.to_end_0, forwards_1);
    }
    return select(_S138, _S139, _S136);
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
    var _S140 : f32 = previous_1.rate_0 * step_4;
    var _S141 : f32 = rate_1 * step_4;
    if(((((((((!previous_1.known_0) | ((here_2.hole_1)))) | (((previous_1.yarn_0) != (here_2.yarn_1))))) | (((previous_1.rate_0) >= 0.0f)))) | ((rate_1 <= 0.0f))))
    {
        return -1.0f;
    }
    if((((3.0f * previous_1.clearance_0 + _S140) >= 0.0f) & (((3.0f * clearance_1 - _S141) >= 0.0f))))
    {
        return -1.0f;
    }
    var _S142 : f32 = clearance_1 - previous_1.clearance_0;
    var _S143 : f32 = 6.0f * _S142 - 4.0f * _S140 - 2.0f * _S141;
    var _S144 : f32 = -2.0f * _S140 / max(_S143 + sqrt(max(_S143 * _S143 - 4.0f * (3.0f * (_S140 + _S141 - 2.0f * _S142)) * _S140, 0.0f)), 9.99999968265522539e-21f);
    var _S145 : f32 = 1.0f - _S144;
    return select(-1.0f, _S145 * step_4, ((((_S144 > 0.01999999955296516f) & ((_S145 > 0.01999999955296516f)))) & ((((previous_1.clearance_0 * (2.0f * _S144 + 1.0f) + _S140 * _S144) * _S145 * _S145 + (clearance_1 * (2.0f * _S145 + 1.0f) - _S141 * _S145) * _S144 * _S144) < 0.0f))));
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

fn StepControl_to_cell_exit_0( this_1 : StepControl_0,  side_x_1 : f32,  side_y_1 : f32) -> f32
{
    return max(min(side_x_1 * this_1.per_x_0, side_y_1 * this_1.per_y_0), 0.0f) + this_1.epsilon_0;
}

fn StepControl_to_next_sample_0( this_2 : StepControl_0,  here_4 : Probe_0,  clearance_3 : f32,  rate_3 : f32) -> f32
{
    var _S146 : f32 = min(here_4.edge_x_1 * this_2.per_x_0, here_4.edge_y_1 * this_2.per_y_0);
    return min(this_2.step_2, select(max(_S146, 0.0f) + this_2.epsilon_0, _S146 - this_2.epsilon_0, ((((!here_4.hole_1) & (((rate_3 * _S146 + clearance_3) < 0.0f)))) & ((_S146 > (2.0f * this_2.epsilon_0))))));
}

struct ViewRay_0
{
     origin_2 : vec2<f32>,
     slope_1 : vec2<f32>,
};

fn ViewRay_at_0( this_3 : ViewRay_0,  height_4 : f32) -> vec2<f32>
{
    return this_3.origin_2 + this_3.slope_1 * vec2<f32>(height_4);
}

fn ViewRay_rate_0( this_4 : ViewRay_0,  here_5 : Probe_0) -> f32
{
    return here_5.slope_x_1 * this_4.slope_1.x + here_5.slope_y_1 * this_4.slope_1.y - 1.0f;
}

fn cubic_root_0( start_1 : f32,  end_0 : f32,  start_rate_0 : f32,  end_rate_0 : f32) -> f32
{
    var _S147 : f32 = end_0 - start_1;
    var _S148 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S147;
    var _S149 : f32 = 3.0f * _S147 - 2.0f * start_rate_0 - end_rate_0;
    var share_1 : f32 = start_1 / max(- _S147, 9.99999968265522539e-21f);
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
        var _S150 : f32 = clamp(share_1 - (((_S148 * share_1 + _S149) * share_1 + start_rate_0) * share_1 + start_1) / min((3.0f * _S148 * share_1 + 2.0f * _S149) * share_1 + start_rate_0, 0.10000000149011612f * _S147 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S151 : i32 = i_0 + i32(1);
        share_1 = _S150;
        i_0 = _S151;
    }
    return share_1;
}

fn between_0( above_1 : f32,  under_0 : f32,  above_gap_0 : f32,  under_gap_0 : f32) -> f32
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

fn arc_tangent_quotient_0( x_10 : f32,  y_5 : f32) -> f32
{
    return ((((((0.0f * x_10 + 0.00809729471802711f) * x_10 + -0.0377517081797123f) * x_10 + 0.08475969731807709f) * x_10 + -0.13537675142288208f) * x_10 + 0.19895026087760925f) * x_10 + -0.33327975869178772f) * x_10 + 0.99999970197677612f;
}

fn arc_tangent_of_ratio_0( ratio_0 : f32) -> f32
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0f);
}

fn arc_tangent_0( y_6 : f32,  x_11 : f32) -> f32
{
    var _S152 : f32 = abs(x_11);
    var _S153 : f32 = abs(y_6);
    var angle_0 : f32 = arc_tangent_of_ratio_0(min(_S152, _S153) / max(max(_S152, _S153), 1.00000000317107685e-30f));
    var angle_1 : f32 = select(angle_0, 1.57079637050628662f - angle_0, _S153 > _S152);
    var angle_2 : f32 = select(angle_1, 3.14159274101257324f - angle_1, x_11 < 0.0f);
    return select(angle_2, - angle_2, y_6 < 0.0f);
}

struct NodeTaps_0
{
     nodes_0 : vec4<u32>,
     weights_0 : vec4<u32>,
     inverse_sum_0 : f32,
};

fn node_taps_of_0( direction_4 : vec3<f32>,  azimuths_0 : u32) -> NodeTaps_0
{
    var _S154 : f32 = arc_tangent_0(direction_4.y, direction_4.x) * (0.5f * f32(azimuths_0) * 0.31830987334251404f);
    var _S155 : f32 = floor(_S154);
    var _S156 : f32 = _S154 - _S155;
    var _S157 : f32 = sqrt(clamp((1.0f - abs(direction_4.z)) / 0.97000002861022949f, 0.0f, 1.0f));
    var _S158 : f32 = 7.0f * _S157 * sqrt(_S157);
    var _S159 : f32 = min(floor(_S158), 6.0f);
    var _S160 : f32 = _S158 - _S159;
    var _S161 : u32 = u32(i32(_S155) + i32(azimuths_0)) % azimuths_0;
    var _S162 : u32 = u32(_S159);
    var _S163 : u32 = _S161 * u32(8) + _S162;
    var _S164 : u32 = (_S161 + u32(1)) % azimuths_0;
    var _S165 : u32 = _S164 * u32(8) + _S162;
    var taps_0 : NodeTaps_0;
    taps_0.nodes_0 = vec4<u32>(_S163, _S163 + u32(1), _S165, _S165 + u32(1));
    var _S166 : f32 = 1.0f - _S156;
    var _S167 : f32 = 1.0f - _S160;
    var _S168 : vec4<u32> = vec4<u32>(vec4<f32>(_S166 * _S167, _S166 * _S160, _S156 * _S167, _S156 * _S160) * vec4<f32>(252.0f) + vec4<f32>(0.5f));
    taps_0.weights_0 = _S168;
    taps_0.inverse_sum_0 = 1.0f / f32(_S168.x + _S168.y + _S168.z + _S168.w);
    return taps_0;
}

fn node_taps_0( direction_5 : vec3<f32>) -> NodeTaps_0
{
    var _S169 : NodeTaps_0 = node_taps_of_0(direction_5, u32(32));
    return _S169;
}

fn wrapped_cell_0( position_5 : f32,  count_2 : f32) -> f32
{
    return min(floor((position_5 - floor(position_5)) * count_2), count_2 - 1.0f);
}

fn bytes_of_sums_0( even_0 : u32,  odd_0 : u32) -> vec4<f32>
{
    return vec4<f32>(f32((even_0 & (u32(65535)))), f32((odd_0 & (u32(65535)))), f32((even_0 >> (u32(16)))), f32((odd_0 >> (u32(16)))));
}

fn interpolate_0( taps_1 : NodeTaps_0,  packs_1 : vec4<u32>) -> vec4<f32>
{
    var _S170 : vec4<u32> = vec4<u32>(u32(16711935));
    var _S171 : vec4<u32> = ((packs_1 & (_S170))) * taps_1.weights_0;
    var _S172 : vec4<u32> = ((((packs_1 >> (vec4<u32>(u32(8))))) & (_S170))) * taps_1.weights_0;
    return bytes_of_sums_0(_S171.x + _S171.y + _S171.z + _S171.w, _S172.x + _S172.y + _S172.z + _S172.w) * vec4<f32>(taps_1.inverse_sum_0);
}

fn interpolate_table_0( taps_2 : NodeTaps_0,  table_1 : u32,  stride_0 : u32) -> vec4<f32>
{
    var _S173 : vec4<u32> = vec4<u32>(table_1) + taps_2.nodes_0 * vec4<u32>(stride_0);
    return interpolate_0(taps_2, vec4<u32>(words_0[_S173.x], words_0[_S173.y], words_0[_S173.z], words_0[_S173.w]));
}

struct Yarns_0
{
     warp_3 : vec4<f32>,
     weft_3 : vec4<f32>,
     shares_0 : vec3<f32>,
};

fn Yarns_x24init_0( warp_4 : vec4<f32>,  weft_4 : vec4<f32>,  shares_1 : vec3<f32>) -> Yarns_0
{
    var _S174 : Yarns_0;
    _S174.warp_3 = warp_4;
    _S174.weft_3 = weft_4;
    _S174.shares_0 = shares_1;
    return _S174;
}

fn irregular_over_0( family_13 : u32,  key_4 : u32,  place_1 : f32,  width_2 : f32,  along_1 : f32,  length_0 : f32) -> vec4<f32>
{
    var _S175 : f32 = max(width_2, 0.0625f);
    var _S176 : f32 = min(_S175, 64.0f);
    var _S177 : f32 = max(length_0 / 2.0f, 1.0f);
    var _S178 : f32 = along_1 / 2.0f - 0.5f * _S177;
    var _S179 : f32 = 0.5f * _S176;
    var _S180 : vec2<f32> = floor(vec2<f32>(place_1 - _S179, place_1 + _S179) / vec2<f32>(64.0f));
    var _S181 : vec4<f32> = vec4<f32>(0.0f);
    var number_3 : u32 = u32(0);
    var sums_2 : vec4<f32> = _S181;
    for(;;)
    {
        if(number_3 < u32(6))
        {
        }
        else
        {
            break;
        }
        var _S182 : bool = number_3 >= u32(3);
        var _S183 : u32 = select(number_3, number_3 - u32(3), _S182);
        var _S184 : f32 = select(-1.0f, 1.0f, _S182);
        var _S185 : f32 = _S180.y;
        var _S186 : f32 = _S180.x;
        var _S187 : f32 = select(_S186, _S185, _S182);
        var _S188 : f32 = place_1 + _S184 * 0.5f * _S176 - 64.0f * _S187;
        var _S189 : f32 = clamp(floor(_S188), 0.0f, 63.0f);
        var _S190 : f32 = _S188 - _S189;
        var _S191 : f32 = select(select(64.0f, 0.0f, _S182), _S189 + f32(_S183), _S183 < u32(2));
        var _S192 : f32 = _S184 * select(select(select(0.0f, -1.0f, _S186 != _S185), _S190, _S183 == u32(1)), 1.0f - _S190, _S183 == u32(0));
        if(_S192 == 0.0f)
        {
            number_3 = number_3 + u32(1);
            continue;
        }
        var _S193 : u32 = hash_bits_0(key_4, u32(i32(_S187)));
        sums_2 = sums_2 + vec4<f32>(_S192) * irregular_integral_0(family_13, ((_S193 & (u32(127)))) + u32(_S191), _S178 + f32((_S193 >> (u32(22)))), _S177);
        number_3 = number_3 + u32(1);
    }
    return sums_2 * irregular_units_0(family_13) * vec4<f32>((sqrt(_S176 / _S175) / (_S176 * _S177)));
}

fn shown_of_covers_0( covers_0 : vec2<f32>,  warp_on_top_1 : f32) -> vec3<f32>
{
    var _S194 : f32 = covers_0.x;
    var _S195 : f32 = covers_0.y;
    return vec3<f32>(_S194 * (1.0f - _S195 * (1.0f - warp_on_top_1)), _S195 * (1.0f - _S194 * warp_on_top_1), (1.0f - _S194) * (1.0f - _S195));
}

fn sheen_scale_0( x_12 : f32,  y_7 : f32) -> f32
{
    return (((((0.0f * x_12 + (((((-1.1402510404586792f * y_7 + 0.40672621130943298f) * y_7 + 1.65398800373077393f) * y_7 + -1.29730904102325439f) * y_7 + 0.30570998787879944f) * y_7 + -0.0220868494361639f)) * x_12 + (((((-0.21142719686031342f * y_7 + 1.05947399139404297f) * y_7 + -0.41116121411323547f) * y_7 + -0.93859231472015381f) * y_7 + 0.51606941223144531f) * y_7 + 0.05409301072359085f)) * x_12 + (((((1.22944498062133789f * y_7 + -0.45962560176849365f) * y_7 + -1.63861405849456787f) * y_7 + 1.33565104007720947f) * y_7 + -0.45725581049919128f) * y_7 + 0.08243165910243988f)) * x_12 + (((((0.39779931306838989f * y_7 + -1.18879103660583496f) * y_7 + 0.28251591324806213f) * y_7 + 1.168984055519104f) * y_7 + -0.76864629983901978f) * y_7 + 0.0091691892594099f)) * x_12 + (((((-0.26563560962677002f * y_7 + -0.19379159808158875f) * y_7 + 0.2677634060382843f) * y_7 + 0.00270519289188087f) * y_7 + 0.14349560439586639f) * y_7 + 0.10290180146694183f)) * x_12 + (((((-0.20701569318771362f * y_7 + 0.24526430666446686f) * y_7 + 0.19551840424537659f) * y_7 + 0.07586126774549484f) * y_7 + 0.38894739747047424f) * y_7 + 0.15043120086193085f);
}

fn sheen_shear_0( x_13 : f32,  y_8 : f32) -> f32
{
    return ((((0.0f * x_13 + (((((-0.10608240216970444f * y_8 + 1.99214303493499756f) * y_8 + -1.42255294322967529f) * y_8 + -1.09495604038238525f) * y_8 + 0.59180057048797607f) * y_8 + 0.06902855634689331f)) * x_13 + (((((-0.46220690011978149f * y_8 + -0.29113379120826721f) * y_8 + 1.39025199413299561f) * y_8 + 0.35589990019798279f) * y_8 + -1.17120099067687988f) * y_8 + 0.15940259397029877f)) * x_13 + (((((2.26068711280822754f * y_8 + -3.64728999137878418f) * y_8 + -0.72173482179641724f) * y_8 + 3.07659196853637695f) * y_8 + -0.6827620267868042f) * y_8 + -0.3039557933807373f)) * x_13 + (((((0.81201767921447754f * y_8 + 0.36014080047607422f) * y_8 + -1.72646903991699219f) * y_8 + -0.22630110383033752f) * y_8 + 0.89514690637588501f) * y_8 + -0.10397960245609283f)) * x_13 + (((((-0.37648698687553406f * y_8 + 1.10974001884460449f) * y_8 + 0.17824520170688629f) * y_8 + -1.04968702793121338f) * y_8 + 0.1461234986782074f) * y_8 + -0.00475129019469023f);
}

fn sheen_reflectance_0( x_14 : f32,  y_9 : f32) -> f32
{
    return ((((0.0f * x_14 + (((((12.95646953582763672f * y_9 + -21.38032913208007812f) * y_9 + -7.37853097915649414f) * y_9 + 34.55607986450195312f) * y_9 + -23.61347007751464844f) * y_9 + 5.00126314163208008f)) * x_14 + (((((10.91487026214599609f * y_9 + -6.08202791213989258f) * y_9 + -38.2036285400390625f) * y_9 + 53.3440399169921875f) * y_9 + -21.91996002197265625f) * y_9 + 2.01606011390686035f)) * x_14 + (((((-14.52206039428710938f * y_9 + 36.803619384765625f) * y_9 + -22.94047927856445312f) * y_9 + -10.07973003387451172f) * y_9 + 15.77003955841064453f) * y_9 + -4.92722177505493164f)) * x_14 + (((((-7.62505722045898438f * y_9 + 1.27310299873352051f) * y_9 + 31.19523048400878906f) * y_9 + -44.39989852905273438f) * y_9 + 26.44947052001953125f) * y_9 + -8.73507976531982422f)) * x_14 + (((((5.65633487701416016f * y_9 + -17.66820907592773438f) * y_9 + 24.65356063842773438f) * y_9 + -19.38941001892089844f) * y_9 + 11.06159019470214844f) * y_9 + -3.06573700904846191f);
}

fn exponential_0( x_15 : f32) -> f32
{
    var _S196 : f32 = clamp(x_15, -87.0f, 88.0f);
    var _S197 : f32 = floor(_S196 * 1.4426950216293335f + 0.5f);
    var _S198 : f32 = _S196 - _S197 * 0.693359375f + _S197 * 0.00021219444170129f;
    return select(((((((0.00019875691214111f * _S198 + 0.00139819993637502f) * _S198 + 0.00833345204591751f) * _S198 + 0.04166579619050026f) * _S198 + 0.1666666567325592f) * _S198 + 0.5f) * _S198 * _S198 + _S198 + 1.0f) * (bitcast<f32>(((u32(i32(_S197) + i32(127)) << (u32(23)))))), 0.0f, x_15 < -87.0f);
}

fn sheen_lobe_0( cos_view_0 : f32,  roughness_1 : f32) -> vec3<f32>
{
    var _S199 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S200 : f32 = 2.0f * sqrt(_S199) - 1.0f;
    var _S201 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_1, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S200, _S201), 0.00999999977648258f, 1.0f), clamp((1.0f - _S199) * sheen_shear_0(_S200, _S201), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S200, _S201), -60.0f, 60.0f))));
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

fn uneven_shift_0( _S202 : u32,  _S203 : u32,  _S204 : u32,  _S205 : vec2<f32>) -> f32
{
    var _S206 : f32 = families_0[_S204].period_0 / families_0[_S204].count_0;
    var _S207 : u32 = hash_key_0(_S203, ((fabrics_0[_S202].seed_0) ^ (u32(625341585))));
    var _S208 : vec2<f32> = vec2<f32>(_S205.x, _S205.y / 4.0f) / vec2<f32>(_S206);
    return 0.20000000298023224f * sqrt(families_0[_S204].slub_0) * _S206 * (uneven_octave_0(_S207, _S208) * 0.66666668653488159f + uneven_octave_0(_S207 + u32(1), vec2<f32>(2.0f) * _S208 + vec2<f32>(0.5f, 0.0f)) / 3.0f);
}

fn uneven_place_0( _S209 : u32,  _S210 : vec2<f32>) -> vec2<f32>
{
    return select_vector_1((fabrics_0[_S209].has_detail_0) == u32(0), _S210, _S210 + vec2<f32>(uneven_shift_0(_S209, u32(0), fabrics_0[_S209].warp_0, _S210), uneven_shift_0(_S209, u32(1), fabrics_0[_S209].weft_0, _S210.yx)));
}

fn face_point_0( _S211 : u32,  _S212 : u32,  _S213 : f32,  _S214 : f32) -> VisiblePoint_0
{
    var _S215 : u32 = u32(3) * _S212;
    var _S216 : Vertex_0 = vertex_at_0(_S215);
    var _S217 : Vertex_0 = vertex_at_0(_S215 + u32(1));
    var _S218 : Vertex_0 = vertex_at_0(_S215 + u32(2));
    var _S219 : vec3<f32> = position_of_0(_S216);
    var _S220 : vec3<f32> = position_of_0(_S217) - _S219;
    var _S221 : vec3<f32> = position_of_0(_S218) - _S219;
    var _S222 : f32 = _S217.u_0 - _S216.u_0;
    var _S223 : f32 = _S217.v_0 - _S216.v_0;
    var _S224 : vec2<f32> = vec2<f32>(_S222, _S223);
    var _S225 : f32 = _S218.u_0 - _S216.u_0;
    var _S226 : f32 = _S218.v_0 - _S216.v_0;
    var _S227 : vec2<f32> = vec2<f32>(_S225, _S226);
    var _S228 : vec3<f32> = vec3<f32>(select(1.0f, -1.0f, (_S222 * _S226 - _S223 * _S225) < 0.0f));
    var _S229 : vec3<f32> = _S228 * (vec3<f32>(_S226) * _S220 - vec3<f32>(_S223) * _S221);
    var _S230 : vec3<f32> = _S228 * (vec3<f32>(_S222) * _S221 - vec3<f32>(_S225) * _S220);
    var point_1 : VisiblePoint_0;
    var _S231 : vec3<f32> = vec3<f32>(_S213);
    var _S232 : vec3<f32> = vec3<f32>(_S214);
    var _S233 : vec3<f32> = normalize(vec3<f32>((1.0f - _S213 - _S214)) * normal_of_0(_S216) + _S231 * normal_of_0(_S217) + _S232 * normal_of_0(_S218));
    point_1.normal_0 = _S233;
    var _S234 : vec3<f32> = normalize(_S229 - _S233 * vec3<f32>(dot(_S233, _S229)));
    point_1.axis_x_0 = _S234;
    point_1.axis_y_0 = cross(_S233, _S234);
    var _S235 : vec3<f32> = normalize(cross(_S220, _S221));
    point_1.face_normal_0 = select_vector_0((dot(_S235, _S233)) < 0.0f, (vec3<f32>(0) - _S235), _S235);
    point_1.position_0 = _S219 + _S231 * _S220 + _S232 * _S221;
    point_1.view_0 = _S233;
    var _S236 : vec2<f32> = vec2<f32>(_S216.u_0, _S216.v_0) + vec2<f32>(_S213) * _S224 + vec2<f32>(_S214) * _S227;
    point_1.uv_0 = _S236;
    var _S237 : bool = (dot(cross(_S229, _S230), _S233)) < 0.0f;
    var _S238 : vec2<f32> = vec2<f32>(fabrics_0[_S211].uv_width_0, select(fabrics_0[_S211].uv_height_0, - fabrics_0[_S211].uv_height_0, _S237));
    point_1.draft_per_uv_0 = _S238;
    point_1.draft_0 = uneven_place_0(_S211, _S236 * _S238 + vec2<f32>(0.0f, select(0.0f, fabrics_0[_S211].uv_height_0, _S237)));
    var _S239 : vec2<f32> = vec2<f32>(0.0f);
    point_1.draft_dx_0 = _S239;
    point_1.draft_dy_0 = _S239;
    return point_1;
}

fn visible_point_0( _S240 : u32,  _S241 : u32,  _S242 : vec2<u32>) -> VisiblePoint_0
{
    var _S243 : u32 = u32(3) * _S241;
    var _S244 : Vertex_0 = vertex_at_0(_S243);
    var _S245 : Vertex_0 = vertex_at_0(_S243 + u32(1));
    var _S246 : Vertex_0 = vertex_at_0(_S243 + u32(2));
    var _S247 : vec3<f32> = position_of_0(_S244);
    var _S248 : vec3<f32> = position_of_0(_S245) - _S247;
    var _S249 : vec3<f32> = position_of_0(_S246) - _S247;
    var _S250 : vec3<f32> = cross(_S248, _S249);
    var _S251 : f32 = f32(frame_record_0.width_0);
    var _S252 : vec3<f32> = camera_right_0() * vec3<f32>((2.0f / _S251));
    var _S253 : f32 = f32(frame_record_0.height_0);
    var _S254 : vec3<f32> = camera_up_0() * vec3<f32>((-2.0f / _S253));
    var _S255 : vec3<f32> = camera_forward_0() + vec3<f32>((f32(_S242.x) + 0.5f - 0.5f * _S251)) * _S252 + vec3<f32>((f32(_S242.y) + 0.5f - 0.5f * _S253)) * _S254;
    var _S256 : f32 = dot(_S255, _S250);
    var _S257 : f32 = 1.0f / select(1.00000000317107685e-30f, _S256, (abs(_S256)) > 1.00000000317107685e-30f);
    var _S258 : vec3<f32> = _S247 - camera_origin_0();
    var _S259 : vec3<f32> = vec3<f32>((dot(_S258, _S250) * _S257));
    var _S260 : vec3<f32> = _S255 * _S259 - _S258;
    var _S261 : vec3<f32> = _S259 * (_S252 - _S255 * vec3<f32>((dot(_S252, _S250) * _S257)));
    var _S262 : vec3<f32> = _S259 * (_S254 - _S255 * vec3<f32>((dot(_S254, _S250) * _S257)));
    var _S263 : vec3<f32> = vec3<f32>((1.0f / max(square_0(_S250), 1.00000000317107685e-30f)));
    var _S264 : vec3<f32> = cross(_S249, _S250) * _S263;
    var _S265 : vec3<f32> = cross(_S250, _S248) * _S263;
    var _S266 : vec2<f32> = vec2<f32>(_S245.u_0 - _S244.u_0, _S245.v_0 - _S244.v_0);
    var _S267 : vec2<f32> = vec2<f32>(_S246.u_0 - _S244.u_0, _S246.v_0 - _S244.v_0);
    var point_2 : VisiblePoint_0 = face_point_0(_S240, _S241, dot(_S260, _S264), dot(_S260, _S265));
    point_2.position_0 = _S247 + _S260;
    point_2.view_0 = (vec3<f32>(0) - normalize(_S255));
    point_2.draft_dx_0 = (vec2<f32>(dot(_S261, _S264)) * _S266 + vec2<f32>(dot(_S261, _S265)) * _S267) * point_2.draft_per_uv_0;
    point_2.draft_dy_0 = (vec2<f32>(dot(_S262, _S264)) * _S266 + vec2<f32>(dot(_S262, _S265)) * _S267) * point_2.draft_per_uv_0;
    return point_2;
}

fn light_sample_count_0() -> u32
{
    return frame_record_0.lights_0 + frame_record_0.environment_samples_0;
}

struct LightSample_0
{
     towards_0 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_2 : f32,
};

fn environment_texel_0( _S268 : u32,  _S269 : u32) -> vec3<f32>
{
    var _S270 : u32 = frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + frame_record_0.environment_rows_0 * (frame_record_0.environment_columns_0 + u32(1)) + u32(3) * (_S268 * frame_record_0.environment_columns_0 + _S269);
    return vec3<f32>(scene_number_0(_S270), scene_number_0(_S270 + u32(1)), scene_number_0(_S270 + u32(2)));
}

fn sample_environment_0( _S271 : vec2<f32>,  _S272 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S273 : u32 = frame_record_0.environment_rows_0;
    var _S274 : Choice_0 = choose_0(frame_record_0.environment_table_0, frame_record_0.environment_rows_0, _S271.y);
    var _S275 : u32 = frame_record_0.environment_columns_0;
    var _S276 : Choice_0 = choose_0(frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + _S274.index_2 * (frame_record_0.environment_columns_0 + u32(1)), frame_record_0.environment_columns_0, _S271.x);
    var _S277 : vec3<f32> = environment_texel_0(_S274.index_2, _S276.index_2);
    (*_S272) = _S277 * vec3<f32>((frame_record_0.environment_total_0 / max(mean_0(_S277), 9.99999968265522539e-21f)));
    var _S278 : f32 = 3.14159274101257324f / f32(_S273);
    var _S279 : f32 = mix(sine_cosine_0(f32(_S274.index_2) * _S278).y, sine_cosine_0(f32(_S274.index_2 + u32(1)) * _S278).y, _S274.remainder_0);
    var _S280 : f32 = sqrt(max(1.0f - _S279 * _S279, 0.0f));
    var _S281 : vec2<f32> = sine_cosine_0((f32(_S276.index_2) + _S276.remainder_0) * (6.28318548202514648f / f32(_S275)));
    var _S282 : f32 = _S280 * _S281.x;
    var _S283 : f32 = - _S280 * _S281.y;
    return vec3<f32>(frame_record_0.environment_cosine_0 * _S282 + frame_record_0.environment_sine_0 * _S283, _S279, frame_record_0.environment_cosine_0 * _S283 - frame_record_0.environment_sine_0 * _S282);
}

fn light_sample_0( _S284 : u32,  _S285 : vec2<u32>,  _S286 : vec3<f32>) -> LightSample_0
{
    var sample_1 : LightSample_0;
    sample_1.distance_2 = 1.00000001504746622e+30f;
    var _S287 : u32 = frame_record_0.lights_0;
    if(_S284 >= (frame_record_0.lights_0))
    {
        var weight_0 : vec3<f32>;
        var _S288 : vec3<f32> = sample_environment_0(pixel_sequence_0(_S285, frame_record_0.pass_number_0 * frame_record_0.environment_samples_0 + (_S284 - _S287), u32(3)), &(weight_0));
        sample_1.towards_0 = _S288;
        sample_1.irradiance_1 = weight_0 / vec3<f32>(f32(frame_record_0.environment_samples_0));
        return sample_1;
    }
    var _S289 : Light_0 = scene_light_0(frame_record_0.light_records_0 + u32(7) * _S284);
    sample_1.irradiance_1 = vec3<f32>(_S289.red_0, _S289.green_0, _S289.blue_0);
    sample_1.towards_0 = vec3<f32>(_S289.x_3, _S289.y_1, _S289.z_1);
    if((_S289.is_point_0) != u32(0))
    {
        var _S290 : vec3<f32> = sample_1.towards_0 - _S286;
        var _S291 : f32 = max(square_0(_S290), 9.999999960041972e-13f);
        sample_1.distance_2 = sqrt(_S291);
        sample_1.irradiance_1 = sample_1.irradiance_1 / vec3<f32>(_S291);
        sample_1.towards_0 = normalize(_S290);
    }
    return sample_1;
}

fn seen_position_0( _S292 : u32,  _S293 : vec2<u32>) -> vec3<f32>
{
    var _S294 : u32 = u32(3) * _S292;
    var _S295 : vec3<f32> = position_of_0(vertex_at_0(_S294));
    var _S296 : vec3<f32> = position_of_0(vertex_at_0(_S294 + u32(1))) - _S295;
    var _S297 : vec3<f32> = position_of_0(vertex_at_0(_S294 + u32(2))) - _S295;
    var _S298 : vec3<f32> = cross(_S296, _S297);
    var _S299 : f32 = 1.0f / max(square_0(_S298), 1.00000000317107685e-30f);
    var _S300 : f32 = f32(frame_record_0.width_0);
    var _S301 : f32 = f32(frame_record_0.height_0);
    var _S302 : vec3<f32> = camera_forward_0() + camera_right_0() * vec3<f32>((2.0f * (f32(_S293.x) + 0.5f + frame_record_0.jitter_x_0 - 0.5f * _S300) / _S300)) - camera_up_0() * vec3<f32>((2.0f * (f32(_S293.y) + 0.5f + frame_record_0.jitter_y_0 - 0.5f * _S301) / _S301));
    var _S303 : f32 = dot(_S302, _S298);
    var _S304 : vec3<f32> = _S295 - camera_origin_0();
    var _S305 : vec3<f32> = _S302 * vec3<f32>((dot(_S304, _S298) / select(1.00000000317107685e-30f, _S303, (abs(_S303)) > 1.00000000317107685e-30f))) - _S304;
    var _S306 : f32 = clamp(dot(_S305, cross(_S297, _S298)) * _S299, 0.0f, 1.0f);
    return _S295 + vec3<f32>(_S306) * _S296 + vec3<f32>(clamp(dot(_S305, cross(_S298, _S296)) * _S299, 0.0f, 1.0f - _S306)) * _S297;
}

fn nearest_hit_0( _S307 : vec3<f32>,  _S308 : vec3<f32>,  _S309 : f32,  _S310 : f32,  _S311 : u32,  _S312 : bool) -> Hit_0
{
    var _S313 : vec3<f32> = vec3<f32>(inverse_of_0(_S308.x), inverse_of_0(_S308.y), inverse_of_0(_S308.z));
    var found_0 : Hit_0;
    found_0.face_2 = u32(4294967295);
    found_0.distance_0 = _S310;
    found_0.weight_b_0 = 0.0f;
    found_0.weight_c_0 = 0.0f;
    var node_2 : u32 = u32(1);
    for(;;)
    {
        if(node_2 != u32(0))
        {
        }
        else
        {
            break;
        }
        var node_3 : u32;
        if(!meets_node_0(node_2, _S307, _S313, _S309, found_0.distance_0))
        {
            node_3 = following_node_0(node_2);
        }
        else
        {
            var _S314 : u32 = frame_record_0.leaves_0;
            if(node_2 < (frame_record_0.leaves_0))
            {
                node_3 = node_2 * u32(2);
            }
            else
            {
                var _S315 : u32 = frame_record_0.leaf_faces_0 + u32(4) * (node_2 - _S314);
                var _S316 : u32 = following_node_0(node_2);
                var number_4 : u32 = u32(0);
                node_3 = _S316;
                for(;;)
                {
                    if(number_4 < u32(4))
                    {
                    }
                    else
                    {
                        break;
                    }
                    var _S317 : u32 = scene_words_0[_S315 + number_4];
                    if(((_S317 == u32(4294967295)) | ((_S317 == _S311))))
                    {
                        number_4 = number_4 + u32(1);
                        continue;
                    }
                    var _S318 : Hit_0 = meet_face_0(_S317, _S307, _S308);
                    if((((((_S318.face_2) == u32(4294967295)) | (((_S318.distance_0) <= _S309)))) | (((_S318.distance_0) >= (found_0.distance_0)))))
                    {
                        number_4 = number_4 + u32(1);
                        continue;
                    }
                    found_0 = _S318;
                    var _S319 : bool;
                    if(_S312)
                    {
                        _S319 = (fabrics_0[fabric_of_0(_S317)].is_open_0) == u32(0);
                    }
                    else
                    {
                        _S319 = false;
                    }
                    var node_4 : u32;
                    if(_S319)
                    {
                        node_4 = u32(0);
                    }
                    else
                    {
                        node_4 = node_3;
                    }
                    node_3 = node_4;
                    number_4 = number_4 + u32(1);
                }
            }
        }
        node_2 = node_3;
    }
    return found_0;
}

fn is_layered_0( _S320 : u32) -> bool
{
    return (HAS_LAYERS_0 & (((fabrics_0[_S320].planes_0) != u32(0))));
}

fn irregular_key_0( _S321 : u32,  _S322 : u32) -> u32
{
    return hash_key_0(_S322, ((fabrics_0[_S321].seed_0) ^ (u32(1821285621))));
}

fn irregular_place_0( _S323 : u32,  _S324 : vec2<f32>,  _S325 : f32) -> vec2<f32>
{
    var _S326 : u32 = fabrics_0[_S323].warp_0;
    var _S327 : u32 = fabrics_0[_S323].weft_0;
    var _S328 : bool = (((((fabrics_0[_S323].is_irregular_0) != u32(0)) & ((!is_layered_0(_S323))))) & (((max(moved_share_0(fabrics_0[_S323].warp_0, _S325), moved_share_0(fabrics_0[_S323].weft_0, _S325))) > 0.0f)));
    var number_5 : u32 = u32(0);
    var moved_0 : vec2<f32> = _S324;
    for(;;)
    {
        if(number_5 < select(u32(0), u32(2), _S328))
        {
        }
        else
        {
            break;
        }
        var _S329 : bool = number_5 == u32(0);
        var _S330 : u32 = select(_S327, _S326, _S329);
        var _S331 : vec2<f32> = select_vector_1(_S329, _S324, _S324.yx);
        var _S332 : u32 = irregular_key_0(_S323, number_5);
        var _S333 : f32 = _S331.x;
        var _S334 : Cell_0 = locate_0(_S330, _S333);
        var _S335 : f32 = irregular_thread_0(_S330, _S333, _S334);
        var _S336 : f32 = select(1.0f, -1.0f, (_S334.across_0) < 0.0f);
        var _S337 : vec2<f32> = vec2<f32>(0.0f);
        var other_2 : vec2<f32> = _S337;
        var own_1 : vec2<f32> = _S337;
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
            var _S338 : vec2<f32> = irregular_at_0(_S330, _S332, _S335 + _S336 * f32(neighbour_0), _S331.y).xy;
            var _S339 : u32 = neighbour_0 + u32(1);
            own_1 = other_2;
            other_2 = _S338;
            neighbour_0 = _S339;
        }
        var _S340 : f32 = _S334.below_0 + _S334.above_0;
        var _S341 : f32 = min(_S334.half_width_1 / _S340, 0.5f);
        var _S342 : f32 = min(_S341 * (2.0f + own_1.y + other_2.y), 1.0f);
        var _S343 : vec2<f32> = sqrt(max(vec2<f32>(1.0f) + vec2<f32>(own_1.x, other_2.x), vec2<f32>(0.25f)));
        var _S344 : f32 = _S343.x;
        var _S345 : f32 = _S342 * _S344 / (_S344 + _S343.y);
        var _S346 : f32 = abs(_S334.across_0) / _S340;
        var _S347 : f32 = 1.0f - _S342;
        var _S348 : f32 = _S346 - _S345;
        var _S349 : f32 = moved_share_0(_S330, _S325) * _S336 * _S340 * (select(select((_S348 - _S347) / max(_S342 - _S345, 9.99999997475242708e-07f) * _S341 + (1.0f - _S341), _S348 / max(_S347, 9.99999997475242708e-07f) * (1.0f - 2.0f * _S341) + _S341, _S348 < _S347), _S346 * _S341 / _S345, _S348 < 0.0f) - _S346);
        var moved_1 : vec2<f32> = moved_0 + select_vector_1(_S329, vec2<f32>(_S349, 0.0f), vec2<f32>(0.0f, _S349));
        number_5 = number_5 + u32(1);
        moved_0 = moved_1;
    }
    return moved_0;
}

struct Regime_0
{
     prefiltered_0 : f32,
     threads_1 : f32,
     points_0 : f32,
};

fn regime_of_0( _S350 : u32,  _S351 : Footprint_0,  _S352 : f32) -> Regime_0
{
    var _S353 : f32 = Footprint_spread_side_0(_S351);
    var _S354 : f32 = clamp((binary_logarithm_0(max(_S353, 9.99999971718068537e-10f)) - fabrics_0[_S350].lobes_0.unit_level_0 - -0.51457315683364868f) / 1.51457309722900391f, 0.0f, 1.0f);
    var regime_0 : Regime_0;
    var _S355 : f32 = _S354 * _S354 * (3.0f - 2.0f * _S354);
    regime_0.prefiltered_0 = _S355;
    var _S356 : f32 = _S353 * fabrics_0[_S350].lobes_0.threads_per_mm_0;
    regime_0.threads_1 = _S356;
    regime_0.points_0 = select(0.0f, clamp(_S356 * 12.0f, 1.0f, max(mix(8.0f, 4.0f, _S355) / _S352, 1.0f)), _S355 < 1.0f);
    return regime_0;
}

struct Hit_1
{
     x_16 : f32,
     y_10 : f32,
     hole_2 : bool,
     height_5 : f32,
};

fn whole_plane_0( _S357 : u32) -> Plane_0
{
    var plane_4 : Plane_0;
    plane_4.warp_1 = fabrics_0[_S357].warp_0;
    plane_4.weft_1 = fabrics_0[_S357].weft_0;
    plane_4.run_words_1 = fabrics_0[_S357].run_words_0;
    plane_4.ends_2 = fabrics_0[_S357].ends_1;
    plane_4.end_numbers_0 = u32(0);
    plane_4.pick_numbers_0 = u32(0);
    plane_4.max_heights_1 = fabrics_0[_S357].max_heights_0;
    plane_4.max_height_columns_1 = fabrics_0[_S357].max_height_columns_0;
    plane_4.height_low_1 = fabrics_0[_S357].height_low_0;
    plane_4.height_high_1 = fabrics_0[_S357].height_high_0;
    plane_4.front_level_0 = 0.0f;
    plane_4.back_level_0 = 0.0f;
    plane_4.start_x_0 = 0.0f;
    plane_4.start_y_0 = 0.0f;
    plane_4.fine_x_0 = 0.0f;
    plane_4.fine_y_0 = 0.0f;
    return plane_4;
}

fn plane_order_0( _S358 : u32,  _S359 : f32,  _S360 : f32,  _S361 : bool) -> u32
{
    var _S362 : u32 = select(u32(0), locate_varied_0(fabrics_0[_S358].plane_axes_0 + u32(1), _S360).thread_2 * fabrics_0[_S358].ends_1 + locate_varied_0(fabrics_0[_S358].plane_axes_0, _S359).thread_2, (fabrics_0[_S358].stacks_0) > u32(1));
    return fabrics_0[_S358].plane_orders_0 + u32(2) * fabrics_0[_S358].planes_0 * (u32(2) * ((((words_0[fabrics_0[_S358].regions_0 + _S362 / u32(4)] >> ((u32(8) * (_S362 % u32(4)))))) & (u32(255)))) + select(u32(0), u32(1), _S361));
}

fn first_bounds_0( _S363 : u32,  _S364 : u32,  _S365 : f32,  _S366 : f32,  _S367 : bool,  _S368 : bool,  _S369 : bool) -> vec3<f32>
{
    var _S370 : vec3<f32> = bounds_in_0(plane_at_0(fabrics_0[_S363].plane_records_0 + words_0[_S364] * u32(16)), _S365, _S366, _S367, _S368, _S369);
    var _S371 : Cell_0 = locate_varied_0(fabrics_0[_S363].plane_axes_0, _S365);
    var _S372 : Cell_0 = locate_varied_0(fabrics_0[_S363].plane_axes_0 + u32(1), _S366);
    var _S373 : bool = (fabrics_0[_S363].stacks_0) == u32(1);
    return vec3<f32>(_S370.x + table_number_0(_S364 + u32(1)), min(_S370.y, select(select(_S371.below_0, _S371.above_0, _S368), 1.0e+06f, _S373)), min(_S370.z, select(select(_S372.below_0, _S372.above_0, _S369), 1.0e+06f, _S373)));
}

fn plane_shown_0( _S374 : u32,  _S375 : f32,  _S376 : f32,  _S377 : bool,  _S378 : bool,  _S379 : bool) -> PlaneHere_0
{
    var here_6 : PlaneHere_0;
    here_6.plane_3 = whole_plane_0(_S374);
    here_6.number_2 = u32(0);
    here_6.level_1 = 0.0f;
    here_6.edge_x_0 = 1.0e+06f;
    here_6.edge_y_0 = 1.0e+06f;
    here_6.bounds_0 = vec3<f32>(0.0f);
    if(!is_layered_0(_S374))
    {
        return here_6;
    }
    var _S380 : u32 = plane_order_0(_S374, _S375, _S376, _S377);
    var _S381 : vec3<f32> = first_bounds_0(_S374, _S380, _S375, _S376, _S377, _S378, _S379);
    here_6.bounds_0 = _S381;
    var _S382 : bool = (fabrics_0[_S374].stacks_0) == u32(1);
    here_6.edge_x_0 = select(_S381.y, 1.0e+06f, _S382);
    here_6.edge_y_0 = select(_S381.z, 1.0e+06f, _S382);
    var is_hole_0 : bool = true;
    var rank_1 : u32 = u32(0);
    for(;;)
    {
        if(((rank_1 < (fabrics_0[_S374].planes_0)) & (is_hole_0)))
        {
        }
        else
        {
            break;
        }
        var _S383 : u32 = _S380 + u32(2) * rank_1;
        var _S384 : u32 = words_0[_S383];
        here_6.number_2 = _S384;
        here_6.level_1 = table_number_0(_S383 + u32(1));
        here_6.plane_3 = plane_at_0(fabrics_0[_S374].plane_records_0 + _S384 * u32(16));
        var _S385 : Cell_0 = locate_varied_0(here_6.plane_3.warp_1, _S375 - here_6.plane_3.start_x_0);
        var _S386 : Cell_0 = locate_varied_0(here_6.plane_3.weft_1, _S376 - here_6.plane_3.start_y_0);
        var is_hole_1 : bool = !((((abs(_S385.across_0)) < (_S385.half_width_1)) | (((abs(_S386.across_0)) < (_S386.half_width_1)))));
        here_6.edge_x_0 = min(here_6.edge_x_0, select(1.0e+06f, hole_edge_0(_S385, _S378), is_hole_1));
        here_6.edge_y_0 = min(here_6.edge_y_0, select(1.0e+06f, hole_edge_0(_S386, _S379), is_hole_1));
        var _S387 : u32 = rank_1 + u32(1);
        is_hole_0 = is_hole_1;
        rank_1 = _S387;
    }
    return here_6;
}

fn sample_at_0( _S388 : u32,  _S389 : f32,  _S390 : f32,  _S391 : bool) -> Sample_0
{
    return sample_in_0(plane_shown_0(_S388, _S389, _S390, _S391, true, true), _S389, _S390, _S391);
}

fn steps_per_length_0( _S392 : u32,  _S393 : SearchQuality_0,  _S394 : vec3<f32>) -> f32
{
    return max(max(abs(_S394.x) * fabrics_0[_S392].threads_per_x_0, abs(_S394.y) * fabrics_0[_S392].threads_per_y_0) * _S393.steps_per_thread_0, abs(_S394.z) * fabrics_0[_S392].per_relief_0 * _S393.steps_per_relief_0);
}

fn plane_count_0( _S395 : u32) -> u32
{
    return select(u32(1), fabrics_0[_S395].planes_0, is_layered_0(_S395));
}

fn probe_0( _S396 : u32,  _S397 : f32,  _S398 : f32,  _S399 : bool,  _S400 : bool,  _S401 : bool) -> Probe_0
{
    var _S402 : PlaneHere_0 = plane_shown_0(_S396, _S397, _S398, _S399, _S400, _S401);
    var _S403 : Sample_0 = sample_in_0(_S402, _S397, _S398, _S399);
    var probe_1 : Probe_0;
    probe_1.height_3 = _S403.height_2;
    probe_1.hole_1 = _S403.shown_2.hole_0;
    probe_1.slope_x_1 = _S403.slope_x_0;
    probe_1.slope_y_1 = _S403.slope_y_0;
    var _S404 : bool = !is_layered_0(_S396);
    probe_1.yarn_1 = select(_S403.crossing_3.weft_2.thread_2 * u32(2), _S403.crossing_3.warp_2.thread_2 * u32(2) + u32(1), _S403.shown_2.is_warp_0) * plane_count_0(_S396) + _S402.number_2;
    probe_1.cell_max_0 = select(_S402.bounds_0.x, cell_maximum_0(_S402.plane_3, _S403.crossing_3), _S404);
    probe_1.side_x_0 = select(_S402.bounds_0.y, select(_S403.crossing_3.warp_2.below_0, _S403.crossing_3.warp_2.above_0, _S400), _S404);
    probe_1.side_y_0 = select(_S402.bounds_0.z, select(_S403.crossing_3.weft_2.below_0, _S403.crossing_3.weft_2.above_0, _S401), _S404);
    probe_1.edge_x_1 = min(_S402.edge_x_0, outline_distance_0(_S403.crossing_3.warp_2, _S403.shown_2, _S403.run_2, !_S403.shown_2.is_warp_0, _S400));
    probe_1.edge_y_1 = min(_S402.edge_y_0, outline_distance_0(_S403.crossing_3.weft_2, _S403.shown_2, _S403.run_2, _S403.shown_2.is_warp_0, _S401));
    return probe_1;
}

fn is_free_0( _S405 : u32,  _S406 : SearchQuality_0,  _S407 : vec3<f32>,  _S408 : vec3<f32>,  _S409 : bool,  _S410 : f32) -> bool
{
    var _S411 : f32 = _S408.z;
    if(_S411 <= 0.0f)
    {
        return false;
    }
    var _S412 : f32 = 1.0f / max(_S406.shadow_share_0 * steps_per_length_0(_S405, _S406, _S408), 9.99999971718068537e-10f);
    var _S413 : StepControl_0 = step_control_0(_S408.xy, _S412);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_3 : u32 = u32(0);
    var distance_3 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        if(((count_3 < u32(1024)) & (((_S407.z + _S411 * distance_3) < _S410))))
        {
        }
        else
        {
            break;
        }
        var _S414 : vec3<f32> = _S407 + _S408 * vec3<f32>(distance_3);
        var _S415 : Probe_0 = probe_0(_S405, _S414.x, _S414.y, _S409, _S413.right_1, _S413.up_1);
        var _S416 : f32 = _S414.z;
        var _S417 : f32 = _S416 - _S415.height_3;
        var _S418 : f32 = _S411 - _S415.slope_x_1 * _S408.x - _S415.slope_y_1 * _S408.y;
        if(((!_S415.hole_1) & ((_S417 < 0.0f))))
        {
            return false;
        }
        var _S419 : f32 = way_back_to_dip_0(previous_3, _S417, _S418, last_step_0, _S415);
        if(_S419 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S419;
            distance_3 = distance_3 - _S419;
            last_step_0 = last_step_1;
            count_3 = count_3 + u32(1);
            continue;
        }
        var _S420 : bool = _S416 > (_S415.cell_max_0);
        var last_step_2 : f32 = select(StepControl_to_next_sample_0(_S413, _S415, _S417, _S418), max(StepControl_to_cell_exit_0(_S413, _S415.side_x_0, _S415.side_y_0), _S412), _S420);
        var distance_4 : f32 = distance_3 + last_step_2;
        previous_3 = after_sample_0(_S417, _S418, _S415, _S420);
        distance_3 = distance_4;
        last_step_0 = last_step_2;
        count_3 = count_3 + u32(1);
    }
    return true;
}

fn passes_through_0( _S421 : u32,  _S422 : SearchQuality_0,  _S423 : f32,  _S424 : f32,  _S425 : vec3<f32>,  _S426 : bool) -> bool
{
    if(!sample_at_0(_S421, _S423, _S424, _S426).shown_2.hole_0)
    {
        return false;
    }
    var _S427 : vec3<f32> = vec3<f32>(_S423, _S424, 0.0f);
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
        var _S428 : bool = is_free_0(_S421, _S422, _S427, select_vector_0(side_1 == u32(0), _S425, vec3<f32>(- _S425.x, - _S425.y, _S425.z)), _S426 != (side_1 == u32(1)), fabrics_0[_S421].height_high_0);
        var _S429 : u32 = side_1 + u32(1);
        passes_0 = _S428;
        side_1 = _S429;
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

fn plane_of_0( _S430 : u32,  _S431 : u32) -> Plane_0
{
    if(!is_layered_0(_S430))
    {
        return whole_plane_0(_S430);
    }
    return plane_at_0(fabrics_0[_S430].plane_records_0 + _S431 * u32(16));
}

fn max_height_along_0( _S432 : u32,  _S433 : f32,  _S434 : f32,  _S435 : f32,  _S436 : vec3<f32>,  _S437 : bool) -> f32
{
    var _S438 : f32 = _S436.x;
    var _S439 : f32 = _S436.y;
    var _S440 : u32 = select(u32(0), u32(1), _S438 > 0.0f) + select(u32(0), u32(2), _S439 > 0.0f);
    var _S441 : f32 = max(abs(_S438) * fabrics_0[_S432].threads_per_x_0, abs(_S439) * fabrics_0[_S432].threads_per_y_0) / _S436.z;
    var levels_4 : vec4<f32> = vec4<f32>(-1.00000001504746622e+30f);
    var number_6 : u32 = u32(0);
    for(;;)
    {
        if(number_6 < (plane_count_0(_S432)))
        {
        }
        else
        {
            break;
        }
        var _S442 : Plane_0 = plane_of_0(_S432, number_6);
        var _S443 : u32 = (words_0[_S442.max_heights_1 + u32(4) * (locate_0(_S442.weft_1, _S434 - _S442.start_y_0).thread_2 / u32(2) * _S442.max_height_columns_1 + locate_0(_S442.warp_1, _S433 - _S442.start_x_0).thread_2 / u32(2)) + _S440] >> (u32(select(i32(0), i32(4), _S437))));
        var _S444 : vec4<f32> = max(levels_4, vec4<f32>(f32((_S443 & (u32(15)))), f32((((_S443 >> (u32(8)))) & (u32(15)))), f32((((_S443 >> (u32(16)))) & (u32(15)))), f32((((_S443 >> (u32(24)))) & (u32(15))))) * vec4<f32>(0.06666667014360428f) * vec4<f32>(_S442.height_high_1) + vec4<f32>(select(_S442.front_level_0, _S442.back_level_0, _S437)));
        var _S445 : u32 = number_6 + u32(1);
        levels_4 = _S444;
        number_6 = _S445;
    }
    var max_height_0 : f32 = fabrics_0[_S432].height_high_0;
    var number_7 : i32 = i32(3);
    for(;;)
    {
        if(number_7 >= i32(0))
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S435) * _S441) <= (PYRAMID_RADII_0[number_7]))
        {
            max_height_0 = min(max_height_0, levels_4[number_7]);
        }
        number_7 = number_7 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S446 : u32,  _S447 : f32,  _S448 : f32,  _S449 : bool,  _S450 : bool,  _S451 : bool) -> vec3<f32>
{
    if(is_layered_0(_S446))
    {
        return first_bounds_0(_S446, plane_order_0(_S446, _S447, _S448, _S449), _S447, _S448, _S449, _S450, _S451);
    }
    return bounds_in_0(whole_plane_0(_S446), _S447, _S448, _S449, _S450, _S451);
}

fn first_sample_height_0( _S452 : u32,  _S453 : ViewRay_0,  _S454 : StepControl_0,  _S455 : bool) -> f32
{
    var _S456 : f32 = max_height_along_0(_S452, _S453.origin_2.x, _S453.origin_2.y, 0.0f, vec3<f32>(_S453.slope_1, 1.0f), _S455);
    var count_4 : u32 = u32(0);
    var height_7 : f32 = _S456;
    for(;;)
    {
        if(count_4 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S457 : vec2<f32> = ViewRay_at_0(_S453, height_7);
        var _S458 : vec3<f32> = cell_bounds_0(_S452, _S457.x, _S457.y, _S455, _S454.right_1, _S454.up_1);
        var _S459 : f32 = height_7 - _S458.x;
        var _S460 : f32 = StepControl_to_cell_exit_0(_S454, _S458.y, _S458.z);
        var height_8 : f32 = height_7 - clamp(_S459, 0.0f, _S460);
        if(_S459 <= _S460)
        {
            height_7 = height_8;
            break;
        }
        count_4 = count_4 + u32(1);
        height_7 = height_8;
    }
    return height_7;
}

fn search_down_0( _S461 : u32,  _S462 : ViewRay_0,  _S463 : StepControl_0,  _S464 : bool) -> ViewRayEnd_0
{
    var _S465 : f32 = fabrics_0[_S461].height_low_0 - (fabrics_0[_S461].height_high_0 - fabrics_0[_S461].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_6 = first_sample_height_0(_S461, _S462, _S463, _S464);
    end_1.last_step_3 = _S463.epsilon_0;
    end_1.previous_4 = no_previous_sample_0();
    end_1.depth_0 = 0.0f;
    end_1.rate_4 = 0.0f;
    end_1.smooth_0 = false;
    var count_5 : u32 = u32(0);
    for(;;)
    {
        if(count_5 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S466 : vec2<f32> = ViewRay_at_0(_S462, end_1.height_6);
        var _S467 : Probe_0 = probe_0(_S461, _S466.x, _S466.y, _S464, _S463.right_1, _S463.up_1);
        var _S468 : f32 = end_1.height_6 - _S467.height_3;
        var _S469 : f32 = ViewRay_rate_0(_S462, _S467);
        end_1.depth_0 = - _S468;
        end_1.rate_4 = _S469;
        var _S470 : bool = !_S467.hole_1;
        end_1.smooth_0 = ((((end_1.previous_4.known_0) & (_S470))) & (((end_1.previous_4.yarn_0) == (_S467.yarn_1))));
        if((((_S470 & ((_S468 <= 0.0f)))) | (((end_1.height_6) <= _S465))))
        {
            break;
        }
        var _S471 : f32 = way_back_to_dip_0(end_1.previous_4, _S468, _S469, end_1.last_step_3, _S467);
        if(_S471 >= 0.0f)
        {
            end_1.height_6 = end_1.height_6 + _S471;
            end_1.last_step_3 = end_1.last_step_3 - _S471;
            count_5 = count_5 + u32(1);
            continue;
        }
        var _S472 : f32 = min(StepControl_to_cell_exit_0(_S463, _S467.side_x_0, _S467.side_y_0), end_1.height_6 - _S467.cell_max_0);
        var _S473 : f32 = StepControl_to_next_sample_0(_S463, _S467, _S468, _S469);
        end_1.previous_4 = after_sample_0(_S468, _S469, _S467, _S472 > _S473);
        var _S474 : f32 = max(_S472, _S473);
        end_1.last_step_3 = _S474;
        end_1.height_6 = end_1.height_6 - _S474;
        count_5 = count_5 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S475 : u32,  _S476 : ViewRay_0,  _S477 : StepControl_0,  _S478 : bool,  _S479 : ViewRayEnd_0,  _S480 : u32) -> f32
{
    var _S481 : f32 = fabrics_0[_S475].height_high_0 - fabrics_0[_S475].height_low_0;
    var above_2 : f32 = _S479.height_6 + _S479.last_step_3;
    var above_gap_1 : f32 = clamp(_S479.previous_4.clearance_0, 0.0f, _S481);
    var under_gap_1 : f32 = clamp(_S479.depth_0, 0.0f, _S481);
    var middle_0 : f32 = select(between_0(above_2, _S479.height_6, above_gap_1, under_gap_1), above_2 - cubic_root_0(above_gap_1, - under_gap_1, _S479.previous_4.rate_0 * _S479.last_step_3, _S479.rate_4 * _S479.last_step_3) * _S479.last_step_3, _S479.smooth_0);
    var side_2 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S479.height_6;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < _S480)
        {
        }
        else
        {
            break;
        }
        var _S482 : vec2<f32> = ViewRay_at_0(_S476, middle_0);
        var _S483 : Probe_0 = probe_0(_S475, _S482.x, _S482.y, _S478, _S477.right_1, _S477.up_1);
        var _S484 : f32 = clamp(middle_0 - select(_S483.height_3, -1.0e+09f, _S483.hole_1), - _S481, _S481);
        if(_S484 <= 0.0f)
        {
            var _S485 : f32 = select(above_gap_2, 0.5f * above_gap_2, side_2 > 0.0f);
            var _S486 : f32 = - _S484;
            under_1 = middle_0;
            above_gap_2 = _S485;
            under_gap_2 = _S486;
            side_2 = 1.0f;
        }
        else
        {
            var _S487 : f32 = select(under_gap_2, 0.5f * under_gap_2, side_2 < 0.0f);
            above_3 = middle_0;
            above_gap_2 = _S484;
            under_gap_2 = _S487;
            side_2 = -1.0f;
        }
        var _S488 : f32 = select(between_0(above_3, under_1, above_gap_2, under_gap_2), clamp(middle_0 + _S484 / min(ViewRay_rate_0(_S476, _S483), -9.99999997475242708e-07f), under_1, above_3), _S479.smooth_0);
        var _S489 : u32 = i_1 + u32(1);
        middle_0 = _S488;
        i_1 = _S489;
    }
    return select(under_1, middle_0, _S479.smooth_0);
}

fn first_hit_of_yarn_0( _S490 : u32,  _S491 : SearchQuality_0,  _S492 : f32,  _S493 : f32,  _S494 : vec3<f32>,  _S495 : bool) -> Hit_1
{
    var _S496 : f32 = max(_S494.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_2 = vec2<f32>(_S492, _S493);
    var _S497 : vec2<f32> = _S494.xy / vec2<f32>(_S496);
    ray_0.slope_1 = _S497;
    var _S498 : StepControl_0 = step_control_0((vec2<f32>(0) - _S497), 1.0f / max(steps_per_length_0(_S490, _S491, _S494) / _S496, 9.99999971718068537e-10f));
    var _S499 : ViewRayEnd_0 = search_down_0(_S490, ray_0, _S498, _S495);
    var hit_1 : Hit_1;
    hit_1.hole_2 = false;
    var _S500 : f32 = refined_height_0(_S490, ray_0, _S498, _S495, _S499, _S491.refinements_0);
    hit_1.height_5 = _S500;
    var _S501 : vec2<f32> = ViewRay_at_0(ray_0, _S500);
    hit_1.x_16 = _S501.x;
    hit_1.y_10 = _S501.y;
    return hit_1;
}

fn first_hit_0( _S502 : u32,  _S503 : SearchQuality_0,  _S504 : f32,  _S505 : f32,  _S506 : vec3<f32>,  _S507 : bool) -> Hit_1
{
    if(!passes_through_0(_S502, _S503, _S504, _S505, _S506, _S507))
    {
        return first_hit_of_yarn_0(_S502, _S503, _S504, _S505, _S506, _S507);
    }
    var hit_2 : Hit_1;
    hit_2.x_16 = _S504;
    hit_2.y_10 = _S505;
    hit_2.height_5 = 0.0f;
    hit_2.hole_2 = true;
    return hit_2;
}

struct CoverageTaps_0
{
     nodes_1 : array<u32, i32(9)>,
};

fn pyramid_level_0( _S508 : u32,  _S509 : f32) -> vec3<f32>
{
    var _S510 : u32 = fabrics_0[_S508].lobes_0.levels_0 + u32(4) * u32(min(_S509, fabrics_0[_S508].lobes_0.last_level_0));
    return vec3<f32>(table_number_0(_S510), table_number_0(_S510 + u32(1)), table_number_0(_S510 + u32(2)));
}

fn coverage_taps_0( _S511 : u32,  _S512 : Footprint_0,  _S513 : bool) -> CoverageTaps_0
{
    var _S514 : Lobes_std430_0 = fabrics_0[_S511].lobes_0;
    var _S515 : f32 = Footprint_spread_side_0(_S512) * fabrics_0[_S511].lobes_0.inverse_base_size_0;
    var _S516 : vec3<f32> = pyramid_level_0(_S511, floor(binary_logarithm_0(max(0.68000000715255737f * _S515, 1.0f))));
    var _S517 : f32 = 1.0f / max(_S515, 9.99999997475242708e-07f);
    var _S518 : vec2<f32> = vec2<f32>(families_0[fabrics_0[_S511].warp_0].inverse_period_0, families_0[fabrics_0[_S511].weft_0].inverse_period_0);
    var _S519 : vec2<f32> = _S512.centre_0 * _S518;
    var _S520 : vec2<f32> = vec2<f32>(min(max(sqrt(clamp(1.29999995231628418f * (1.0f - _S517 * _S517), 0.0f, 1.0f)), 0.3333333432674408f * _S517), 1.0f));
    var _S521 : vec2<f32> = _S512.dx_0 * _S518 * _S520;
    var _S522 : vec2<f32> = _S512.dy_0 * _S518 * _S520;
    var taps_3 : CoverageTaps_0;
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
        var _S523 : vec2<f32> = _S519 + vec2<f32>(TAP_OFFSETS_0[number_8].x) * _S521 + vec2<f32>(TAP_OFFSETS_0[number_8].y) * _S522;
        var _S524 : f32 = _S516.y;
        taps_3.nodes_1[number_8] = select(u32(0), _S514.face_nodes_0, _S513) + u32(wrapped_cell_0(_S523.y, _S516.z) * _S524 + wrapped_cell_0(_S523.x, _S524) + _S516.x);
        number_8 = number_8 + u32(1);
    }
    return taps_3;
}

fn coverage_of_holes_0( _S525 : u32,  _S526 : CoverageTaps_0) -> f32
{
    var number_9 : u32 = u32(0);
    var total_0 : u32 = u32(0);
    for(;;)
    {
        if(number_9 < u32(9))
        {
        }
        else
        {
            break;
        }
        var total_1 : u32 = total_0 + ((((words_0[fabrics_0[_S525].lobes_0.coverage_holes_0 + _S526.nodes_1[number_9] / u32(4)] >> ((u32(8) * (_S526.nodes_1[number_9] % u32(4)))))) & (u32(255))));
        number_9 = number_9 + u32(1);
        total_0 = total_1;
    }
    return f32(total_0) / 9.0f;
}

fn prefiltered_hole_0( _S527 : u32,  _S528 : CoverageTaps_0,  _S529 : NodeTaps_0,  _S530 : bool) -> f32
{
    var _S531 : f32 = interpolate_table_0(_S529, fabrics_0[_S527].lobes_0.projected_area_0 + fabrics_0[_S527].lobes_0.packs_0, fabrics_0[_S527].lobes_0.packs_0 + u32(1)).x;
    return min(coverage_of_holes_0(_S527, _S528) * _S531 * _S531 * select(fabrics_0[_S527].lobes_0.front_hole_weight_0, fabrics_0[_S527].lobes_0.back_hole_weight_0, _S530), 1.0f);
}

fn yarns_over_0( _S532 : u32,  _S533 : Footprint_0,  _S534 : bool) -> Yarns_0
{
    var _S535 : vec2<f32> = _S533.dx_0;
    var _S536 : vec2<f32> = _S533.dy_0;
    var _S537 : vec2<f32> = sqrt(_S535 * _S535 + _S536 * _S536);
    var _S538 : f32 = Footprint_spread_side_0(_S533);
    var _S539 : vec4<f32> = vec4<f32>(0.0f);
    var yarns_0 : Yarns_0 = Yarns_x24init_0(_S539, _S539, vec3<f32>(0.0f));
    var _S540 : bool = (fabrics_0[_S532].is_irregular_0) != u32(0);
    var number_10 : u32 = u32(0);
    for(;;)
    {
        if(number_10 < select(u32(0), u32(2), _S540))
        {
        }
        else
        {
            break;
        }
        var _S541 : bool = number_10 == u32(0);
        var _S542 : u32 = select(fabrics_0[_S532].weft_0, fabrics_0[_S532].warp_0, _S541);
        var _S543 : vec2<f32> = select_vector_1(_S541, _S533.centre_0, _S533.centre_0.yx);
        var _S544 : vec2<f32> = select_vector_1(_S541, _S537, _S537.yx);
        var _S545 : f32 = _S543.x;
        var _S546 : Cell_0 = locate_0(_S542, _S545);
        var yarn_2 : vec4<f32> = irregular_over_0(_S542, irregular_key_0(_S532, number_10), irregular_thread_0(_S542, _S545, _S546) + _S546.below_0 / (_S546.below_0 + _S546.above_0), _S544.x * (families_0[_S542].count_0 / families_0[_S542].period_0), _S543.y, _S544.y);
        yarn_2[i32(1)] = yarn_2[i32(1)] * (1.0f - moved_share_0(_S542, _S538));
        yarns_0.warp_3 = yarns_0.weft_3;
        yarns_0.weft_3 = yarn_2;
        number_10 = number_10 + u32(1);
    }
    var _S547 : vec2<f32> = vec2<f32>(families_0[fabrics_0[_S532].warp_0].cover_0, families_0[fabrics_0[_S532].weft_0].cover_0);
    var _S548 : f32 = select(fabrics_0[_S532].warp_on_top_0, 1.0f - fabrics_0[_S532].warp_on_top_0, _S534);
    var _S549 : vec3<f32> = shown_of_covers_0(_S547, _S548);
    var _S550 : vec3<f32> = select_vector_0(_S540, shown_of_covers_0(saturate(_S547 + _S547 * vec2<f32>(yarns_0.warp_3.y, yarns_0.weft_3.y)), _S548) / max(_S549, vec3<f32>(0.00009999999747379f)), vec3<f32>(1.0f));
    yarns_0.shares_0 = _S550;
    yarns_0.shares_0[i32(2)] = select(1.0f, _S550.z, (_S549.z) > 0.00009999999747379f);
    return yarns_0;
}

fn passed_share_0( _S551 : u32,  _S552 : VisiblePoint_0,  _S553 : vec3<f32>,  _S554 : f32,  _S555 : vec2<f32>) -> f32
{
    if((fabrics_0[_S551].has_yarns_0) == u32(0))
    {
        return fabrics_0[_S551].mean_hole_0;
    }
    var _S556 : vec3<f32> = to_local_0(_S552, _S553);
    var _S557 : bool = (_S556.z) < 0.0f;
    var _S558 : vec3<f32> = to_face_frame_0(_S556, _S557);
    var _S559 : bool = (fabrics_0[_S551].lobes_0.is_baked_0) != u32(0);
    var _S560 : vec2<f32> = (_S555 - vec2<f32>(0.5f)) * vec2<f32>(_S554);
    var _S561 : vec2<f32> = vec2<f32>(0.0f);
    var footprint_0 : Footprint_0;
    footprint_0.centre_0 = irregular_place_0(_S551, _S552.draft_0 + select_vector_1(_S559, _S561, _S560), select(0.0f, _S554, _S559));
    footprint_0.dx_0 = vec2<f32>(_S554, 0.0f);
    footprint_0.dy_0 = vec2<f32>(0.0f, _S554);
    var _S562 : f32 = select(0.0f, regime_of_0(_S551, footprint_0, 1.0f).prefiltered_0, _S559);
    var share_2 : f32;
    if(_S562 < 1.0f)
    {
        var _S563 : vec2<f32> = footprint_0.centre_0 + select_vector_1(_S559, _S560, _S561);
        if(first_hit_0(_S551, default_quality_0(), _S563.x, _S563.y, _S558, _S557).hole_2)
        {
            share_2 = 1.0f - _S562;
        }
        else
        {
            share_2 = 0.0f;
        }
    }
    else
    {
        share_2 = 0.0f;
    }
    if(_S562 > 0.0f)
    {
        var _S564 : NodeTaps_0 = node_taps_0(_S558);
        var nodes_2 : NodeTaps_0 = _S564;
        nodes_2.nodes_0 = nodes_2.nodes_0 + vec4<u32>((select(u32(0), u32(1), _S557) * u32(256)));
        share_2 = share_2 + _S562 * prefiltered_hole_0(_S551, coverage_taps_0(_S551, footprint_0, _S557), nodes_2, _S557);
    }
    var _S565 : f32 = min(share_2 * select(1.0f, yarns_over_0(_S551, footprint_0, _S557).shares_0.z, _S559), 1.0f);
    var _S566 : f32 = fabrics_0[_S551].sheen_strength_0;
    if((fabrics_0[_S551].sheen_strength_0) > 0.0f)
    {
        share_2 = _S565 * (1.0f - _S566 * sheen_lobe_0(_S558.z, fabrics_0[_S551].sheen_roughness_0).z);
    }
    else
    {
        share_2 = _S565;
    }
    return share_2;
}

fn visibility_of_0( _S567 : VisiblePoint_0,  _S568 : u32,  _S569 : vec2<u32>,  _S570 : u32) -> f32
{
    var _S571 : bool;
    var _S572 : LightSample_0 = light_sample_0(_S570, _S569, _S567.position_0);
    var _S573 : vec3<f32> = seen_position_0(_S568, _S569) + vec3<f32>((select(1.0f, -1.0f, (dot(_S572.towards_0, _S567.face_normal_0)) < 0.0f) * frame_record_0.ray_offset_0)) * _S567.face_normal_0;
    var _S574 : vec2<f32> = _S567.draft_dx_0;
    var _S575 : vec2<f32> = _S567.draft_dy_0;
    var _S576 : f32 = sqrt(0.5f * (dot(_S574, _S574) + dot(_S575, _S575)));
    var nearest_1 : f32 = 0.0f;
    var without_0 : u32 = _S568;
    var layer_0 : u32 = u32(0);
    var visibility_0 : f32 = 1.0f;
    for(;;)
    {
        var _S577 : bool = layer_0 < u32(8);
        var _S578 : bool = visibility_0 > 0.00100000004749745f;
        _S571 = _S578;
        if((_S577 & (_S578)))
        {
        }
        else
        {
            break;
        }
        var _S579 : Hit_0 = nearest_hit_0(_S573, _S572.towards_0, nearest_1, _S572.distance_2, without_0, true);
        if((_S579.face_2) == u32(4294967295))
        {
            break;
        }
        var _S580 : u32 = fabric_of_0(_S579.face_2);
        var _S581 : VisiblePoint_0 = face_point_0(_S580, _S579.face_2, _S579.weight_b_0, _S579.weight_c_0);
        var _S582 : vec2<f32> = pixel_sequence_0(_S569, frame_record_0.pass_number_0, u32(5) + u32(2) * (u32(8) * _S570 + layer_0));
        var _S583 : f32;
        if((fabrics_0[_S580].is_open_0) != u32(0))
        {
            var _S584 : f32 = passed_share_0(_S580, _S581, (vec3<f32>(0) - _S572.towards_0), _S576, _S582);
            _S583 = _S584;
        }
        else
        {
            _S583 = 0.0f;
        }
        var visibility_1 : f32 = visibility_0 * _S583;
        var _S585 : u32 = layer_0 + u32(1);
        nearest_1 = _S579.distance_0;
        without_0 = _S579.face_2;
        layer_0 = _S585;
        visibility_0 = visibility_1;
    }
    return select(0.0f, visibility_0, _S571);
}

@compute
@workgroup_size(8, 8, 1)
fn cast_shadows(@builtin(global_invocation_id) id_0 : vec3<u32>)
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
    var _S591 : vec2<u32> = id_0.xy;
    var _S592 : VisiblePoint_0 = visible_point_0(fabric_of_0(_S590), _S590, _S591);
    var number_11 : u32 = u32(0);
    for(;;)
    {
        if(number_11 < (light_sample_count_0()))
        {
        }
        else
        {
            break;
        }
        var _S593 : f32 = visibility_of_0(_S592, _S590, _S591, number_11);
        visibilities_0[number_11 * frame_record_0.width_0 * frame_record_0.height_0 + _S588] = _S593;
        number_11 = number_11 + u32(1);
    }
    return;
}

