struct Frame_std430_0
{
    @align(4) width_0 : u32,
    @align(4) height_0 : u32,
    @align(4) lights_0 : u32,
    @align(4) samples_0 : u32,
    @align(4) pass_number_0 : u32,
    @align(4) environment_samples_0 : u32,
    @align(4) environment_columns_0 : u32,
    @align(4) environment_rows_0 : u32,
    @align(4) environment_table_0 : u32,
    @align(4) environment_total_0 : f32,
    @align(4) environment_sine_0 : f32,
    @align(4) environment_cosine_0 : f32,
    @align(4) shows_environment_0 : u32,
    @align(4) casts_shadows_0 : u32,
    @align(4) leaves_0 : u32,
    @align(4) leaf_faces_0 : u32,
    @align(4) ray_offset_0 : f32,
    @align(4) jitter_x_0 : f32,
    @align(4) jitter_y_0 : f32,
    @align(4) gain_0 : f32,
    @align(4) origin_x_0 : f32,
    @align(4) origin_y_0 : f32,
    @align(4) origin_z_0 : f32,
    @align(4) right_x_0 : f32,
    @align(4) right_y_0 : f32,
    @align(4) right_z_0 : f32,
    @align(4) up_x_0 : f32,
    @align(4) up_y_0 : f32,
    @align(4) up_z_0 : f32,
    @align(4) forward_x_0 : f32,
    @align(4) forward_y_0 : f32,
    @align(4) forward_z_0 : f32,
    @align(4) near_0 : f32,
    @align(4) background_red_0 : f32,
    @align(4) background_green_0 : f32,
    @align(4) background_blue_0 : f32,
};

@binding(4) @group(0) var<storage, read> frames_0 : array<Frame_std430_0>;

struct Layer_std430_0
{
    @align(4) face_0 : u32,
    @align(4) share_0 : f32,
};

@binding(12) @group(0) var<storage, read_write> layers_0 : array<Layer_std430_0>;

@binding(7) @group(0) var<storage, read> face_fabrics_0 : array<u32>;

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
    @align(4) frames_1 : u32,
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
    @align(4) light_0 : u32,
    @align(4) view_0 : u32,
    @align(4) offset_1 : u32,
    @align(4) trust_0 : u32,
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

@binding(6) @group(0) var<storage, read> corners_0 : array<u32>;

struct Vertex_std430_0
{
    @align(4) x_0 : f32,
    @align(4) y_0 : f32,
    @align(4) z_0 : f32,
    @align(4) normal_x_0 : f32,
    @align(4) normal_y_0 : f32,
    @align(4) normal_z_0 : f32,
    @align(4) u_0 : f32,
    @align(4) v_0 : f32,
};

@binding(5) @group(0) var<storage, read> vertices_0 : array<Vertex_std430_0>;

@binding(13) @group(0) var<storage, read_write> visibilities_0 : array<f32>;

@binding(11) @group(0) var<storage, read> scene_words_0 : array<u32>;

struct Light_std430_0
{
    @align(4) is_point_0 : u32,
    @align(4) x_1 : f32,
    @align(4) y_1 : f32,
    @align(4) z_1 : f32,
    @align(4) red_0 : f32,
    @align(4) green_0 : f32,
    @align(4) blue_0 : f32,
};

@binding(3) @group(0) var<storage, read> lights_1 : array<Light_std430_0>;

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

var<private> TAP_OFFSETS_0 : array<vec2<f32>, i32(9)> = array<vec2<f32>, i32(9)>( vec2<f32>(-0.3333333432674408f, -0.3333333432674408f), vec2<f32>(-0.3333333432674408f, 0.0f), vec2<f32>(-0.3333333432674408f, 0.3333333432674408f), vec2<f32>(0.0f, -0.3333333432674408f), vec2<f32>(0.0f, 0.0f), vec2<f32>(0.0f, 0.3333333432674408f), vec2<f32>(0.3333333432674408f, -0.3333333432674408f), vec2<f32>(0.3333333432674408f, 0.0f), vec2<f32>(0.3333333432674408f, 0.3333333432674408f) );
var<private> PYRAMID_RADII_0 : array<f32, i32(4)> = array<f32, i32(4)>( 1.0f, 2.0f, 4.0f, 8.0f );
fn rsqrt_0( x_2 : f32) -> f32
{
    return 1.0f / sqrt(x_2);
}

fn firstbitlow_0( value_0 : u32) -> u32
{
    var _S1 : u32 = firstTrailingBit(value_0);
    return _S1;
}

fn position_of_0( vertex_0 : ptr<function, Vertex_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*vertex_0).x_0, (*vertex_0).y_0, (*vertex_0).z_0);
}

fn position_of_1( vertex_1 : ptr<function, Vertex_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*vertex_1).x_0, (*vertex_1).y_0, (*vertex_1).z_0);
}

fn position_of_2( vertex_2 : ptr<function, Vertex_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*vertex_2).x_0, (*vertex_2).y_0, (*vertex_2).z_0);
}

fn position_of_3( vertex_3 : ptr<function, Vertex_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*vertex_3).x_0, (*vertex_3).y_0, (*vertex_3).z_0);
}

fn square_0( v_1 : vec3<f32>) -> f32
{
    return dot(v_1, v_1);
}

fn normal_of_0( vertex_4 : ptr<function, Vertex_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*vertex_4).normal_x_0, (*vertex_4).normal_y_0, (*vertex_4).normal_z_0);
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

fn uniform_hash_0( thread_1 : u32,  cell_1 : u32,  stream_1 : u32) -> f32
{
    return (f32(((hash_bits_0(hash_key_0(thread_1, stream_1), cell_1)) >> (u32(9)))) + 0.5f) * 1.1920928955078125e-07f;
}

fn pixel_sequence_0( pixel_0 : vec2<u32>,  index_0 : u32,  stream_2 : u32) -> vec2<f32>
{
    var _S4 : u32 = pixel_0.x;
    var _S5 : u32 = pixel_0.y;
    return fract(vec2<f32>(uniform_hash_0(_S4, _S5, stream_2), uniform_hash_0(_S4, _S5, stream_2 + u32(1))) + vec2<f32>(f32((index_0 & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
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
        var _S6 : u32 = (low_0 + high_0) / u32(2);
        if((scene_number_0(table_0 + _S6)) <= number_0)
        {
            low_0 = _S6;
        }
        else
        {
            high_0 = _S6;
        }
    }
    var _S7 : u32 = table_0 + low_0;
    var _S8 : f32 = scene_number_0(_S7);
    var _S9 : f32 = scene_number_0(_S7 + u32(1));
    var choice_0 : Choice_0;
    choice_0.index_2 = low_0;
    choice_0.remainder_0 = saturate((number_0 - _S8) / max(_S9 - _S8, 9.999999960041972e-13f));
    return choice_0;
}

fn mean_0( colour_0 : vec3<f32>) -> f32
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

fn sine_cosine_0( x_3 : f32) -> vec2<f32>
{
    var _S10 : f32 = floor(x_3 * 0.63661974668502808f + 0.5f);
    var _S11 : f32 = x_3 - _S10 * 1.5703125f - _S10 * 0.00048375129699707f - _S10 * 7.54979012640433211e-08f;
    var _S12 : f32 = _S11 * _S11;
    var _S13 : f32 = ((-0.00019515295571182f * _S12 + 0.00833216123282909f) * _S12 - 0.16666655242443085f) * _S12 * _S11 + _S11;
    var _S14 : f32 = ((0.00002443315679557f * _S12 - 0.00138873164542019f) * _S12 + 0.04166664555668831f) * _S12 * _S12 - 0.5f * _S12 + 1.0f;
    var _S15 : u32 = (u32(i32(_S10)) & (u32(3)));
    var _S16 : vec2<f32>;
    if(((_S15 & (u32(1)))) != u32(0))
    {
        _S16 = vec2<f32>(_S14, _S13);
    }
    else
    {
        _S16 = vec2<f32>(_S13, _S14);
    }
    var _S17 : f32;
    if(((_S15 & (u32(2)))) != u32(0))
    {
        _S17 = - _S16.x;
    }
    else
    {
        _S17 = _S16.x;
    }
    var _S18 : f32;
    if((((_S15 + u32(1)) & (u32(2)))) != u32(0))
    {
        _S18 = - _S16.y;
    }
    else
    {
        _S18 = _S16.y;
    }
    return vec2<f32>(_S17, _S18);
}

fn inverse_of_0( component_0 : f32) -> f32
{
    var _S19 : f32;
    if((abs(component_0)) > 9.99999968265522539e-21f)
    {
        _S19 = component_0;
    }
    else
    {
        _S19 = 9.99999968265522539e-21f;
    }
    return 1.0f / _S19;
}

fn meets_node_0( node_0 : u32,  origin_0 : vec3<f32>,  inverse_0 : vec3<f32>,  nearest_0 : f32,  farthest_0 : f32) -> bool
{
    var _S20 : u32 = u32(6) * (node_0 - u32(1));
    var _S21 : vec3<f32> = (vec3<f32>(scene_number_0(_S20), scene_number_0(_S20 + u32(1)), scene_number_0(_S20 + u32(2))) - origin_0) * inverse_0;
    var _S22 : vec3<f32> = (vec3<f32>(scene_number_0(_S20 + u32(3)), scene_number_0(_S20 + u32(4)), scene_number_0(_S20 + u32(5))) - origin_0) * inverse_0;
    var _S23 : vec3<f32> = min(_S21, _S22);
    var _S24 : vec3<f32> = max(_S21, _S22) * vec3<f32>(1.0000004768371582f);
    return (max(max(_S23.x, _S23.y), max(_S23.z, nearest_0))) <= (min(min(_S24.x, _S24.y), min(_S24.z, farthest_0)));
}

fn following_node_0( node_1 : u32) -> u32
{
    var _S25 : u32 = node_1 + u32(1);
    var _S26 : u32 = (_S25 >> ((firstbitlow_0(_S25))));
    var _S27 : u32;
    if(_S26 == u32(1))
    {
        _S27 = u32(0);
    }
    else
    {
        _S27 = _S26;
    }
    return _S27;
}

struct Hit_0
{
     face_1 : u32,
     distance_0 : f32,
     weight_b_0 : f32,
     weight_c_0 : f32,
};

fn meet_face_0( face_2 : u32,  origin_1 : vec3<f32>,  direction_0 : vec3<f32>) -> Hit_0
{
    var _S28 : u32 = u32(3) * face_2;
    var _S29 : Vertex_std430_0 = vertices_0[corners_0[_S28]];
    var _S30 : vec3<f32> = position_of_1(&(_S29));
    var _S31 : Vertex_std430_0 = vertices_0[corners_0[_S28 + u32(1)]];
    var _S32 : vec3<f32> = position_of_1(&(_S31));
    var _S33 : vec3<f32> = _S32 - _S30;
    var _S34 : Vertex_std430_0 = vertices_0[corners_0[_S28 + u32(2)]];
    var _S35 : vec3<f32> = position_of_1(&(_S34));
    var _S36 : vec3<f32> = _S35 - _S30;
    var _S37 : vec3<f32> = cross(direction_0, _S36);
    var _S38 : f32 = dot(_S33, _S37);
    var _S39 : bool = (abs(_S38)) > 1.00000000317107685e-30f;
    var _S40 : f32;
    if(_S39)
    {
        _S40 = _S38;
    }
    else
    {
        _S40 = 1.00000000317107685e-30f;
    }
    var _S41 : f32 = 1.0f / _S40;
    var _S42 : vec3<f32> = origin_1 - _S30;
    var _S43 : vec3<f32> = cross(_S42, _S33);
    var hit_0 : Hit_0;
    var _S44 : f32 = dot(_S42, _S37) * _S41;
    hit_0.weight_b_0 = _S44;
    hit_0.weight_c_0 = dot(direction_0, _S43) * _S41;
    hit_0.distance_0 = dot(_S36, _S43) * _S41;
    var _S45 : bool;
    if(_S44 >= 0.0f)
    {
        _S45 = (hit_0.weight_c_0) >= 0.0f;
    }
    else
    {
        _S45 = false;
    }
    if(_S45)
    {
        _S45 = (hit_0.weight_b_0 + hit_0.weight_c_0) <= 1.0f;
    }
    else
    {
        _S45 = false;
    }
    if(_S45)
    {
        _S45 = _S39;
    }
    else
    {
        _S45 = false;
    }
    var _S46 : u32;
    if(_S45)
    {
        _S46 = face_2;
    }
    else
    {
        _S46 = u32(4294967295);
    }
    hit_0.face_1 = _S46;
    return hit_0;
}

struct VisiblePoint_0
{
     position_0 : vec3<f32>,
     view_1 : vec3<f32>,
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
    var _S47 : vec2<f32> = direction_2.xy;
    var _S48 : f32;
    if(back_2)
    {
        _S48 = - direction_2.z;
    }
    else
    {
        _S48 = direction_2.z;
    }
    return vec3<f32>(_S47, _S48);
}

struct Footprint_0
{
     centre_0 : vec2<f32>,
     dx_0 : vec2<f32>,
     dy_0 : vec2<f32>,
};

fn Footprint_spread_side_0( this_0 : Footprint_0) -> f32
{
    var _S49 : vec2<f32> = this_0.dx_0;
    var _S50 : vec2<f32> = this_0.dy_0;
    return sqrt(0.5f * (dot(_S49, _S49) + dot(_S50, _S50)));
}

fn natural_logarithm_0( x_4 : f32) -> f32
{
    var _S51 : u32 = (bitcast<u32>((x_4)));
    var exponent_0 : f32 = f32(i32((_S51 >> (u32(23)))) - i32(126));
    var m_0 : f32 = (bitcast<f32>(((((_S51 & (u32(8388607)))) | (u32(1056964608))))));
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
    var _S52 : f32 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S52 - exponent_1 * 0.00021219444170129f - 0.5f * _S52) + exponent_1 * 0.693359375f;
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

fn turns_and_remainder_0( family_0 : u32,  index_3 : f32) -> vec2<f32>
{
    var _S53 : f32 = floor(fma(index_3, families_0[family_0].inverse_count_0, families_0[family_0].half_inverse_count_0));
    return vec2<f32>(_S53, fma(- _S53, families_0[family_0].count_0, index_3));
}

struct Cell_0
{
     thread_2 : u32,
     across_0 : f32,
     half_width_1 : f32,
     below_0 : f32,
     above_0 : f32,
};

fn locate_alike_0( family_1 : u32,  position_1 : f32) -> Cell_0
{
    var _S54 : f32 = floor(position_1 * families_0[family_1].inverse_size_0);
    var cell_2 : Cell_0;
    var _S55 : f32 = fma(- _S54, families_0[family_1].size_0, position_1);
    cell_2.below_0 = _S55;
    cell_2.above_0 = families_0[family_1].size_0 - _S55;
    cell_2.across_0 = _S55 - 0.5f * families_0[family_1].size_0;
    cell_2.half_width_1 = families_0[family_1].half_width_0;
    cell_2.thread_2 = u32(clamp(turns_and_remainder_0(family_1, _S54).y, 0.0f, families_0[family_1].count_0 - 1.0f));
    return cell_2;
}

fn table_number_0( index_4 : u32) -> f32
{
    return (bitcast<f32>((words_0[index_4])));
}

fn locate_varied_0( family_2 : u32,  position_2 : f32) -> Cell_0
{
    var turns_0 : f32 = (position_2 - families_0[family_2].start_0) * families_0[family_2].inverse_period_0;
    var turns_1 : f32 = turns_0 - floor(turns_0);
    var _S56 : f32 = turns_1 * families_0[family_2].period_0;
    var thread_3 : u32 = words_0[families_0[family_2].first_thread_table_0 + u32(clamp(turns_1 * families_0[family_2].bins_0, 0.0f, families_0[family_2].bins_0 - 1.0f))];
    var _S57 : u32;
    if(_S56 >= (table_number_0(families_0[family_2].place_table_0 + thread_3 * u32(4) + u32(1))))
    {
        _S57 = u32(1);
    }
    else
    {
        _S57 = u32(0);
    }
    var _S58 : u32 = min(thread_3 + _S57, u32(families_0[family_2].count_0) - u32(1));
    var _S59 : u32 = families_0[family_2].place_table_0 + _S58 * u32(4);
    var cell_3 : Cell_0;
    cell_3.thread_2 = _S58;
    cell_3.below_0 = _S56 - table_number_0(_S59);
    cell_3.above_0 = table_number_0(_S59 + u32(1)) - _S56;
    cell_3.across_0 = _S56 - table_number_0(_S59 + u32(2));
    cell_3.half_width_1 = table_number_0(_S59 + u32(3));
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
    var _S60 : bool = (abs(crossing_0.warp_1.across_0)) < (crossing_0.warp_1.half_width_1);
    var _S61 : bool = (abs(crossing_0.weft_1.across_0)) < (crossing_0.weft_1.half_width_1);
    var shown_0 : Shown_0;
    var _S62 : bool;
    if(_S60)
    {
        if(!_S61)
        {
            _S62 = true;
        }
        else
        {
            _S62 = crossing_0.warp_above_0;
        }
    }
    else
    {
        _S62 = false;
    }
    shown_0.is_warp_0 = _S62;
    if(!_S60)
    {
        _S62 = !_S61;
    }
    else
    {
        _S62 = false;
    }
    shown_0.hole_0 = _S62;
    var _S63 : u32;
    if(shown_0.is_warp_0)
    {
        _S63 = crossing_0.warp_word_0;
    }
    else
    {
        _S63 = crossing_0.weft_word_0;
    }
    shown_0.word_0 = _S63;
    shown_0.on_top_0 = (((_S63 & (u32(1)))) == u32(1)) != back_3;
    return shown_0;
}

fn select_cell_0( is_first_0 : bool,  first_0 : Cell_0,  second_0 : Cell_0) -> Cell_0
{
    var cell_4 : Cell_0;
    var _S64 : u32;
    if(is_first_0)
    {
        _S64 = first_0.thread_2;
    }
    else
    {
        _S64 = second_0.thread_2;
    }
    cell_4.thread_2 = _S64;
    var _S65 : f32;
    if(is_first_0)
    {
        _S65 = first_0.across_0;
    }
    else
    {
        _S65 = second_0.across_0;
    }
    cell_4.across_0 = _S65;
    if(is_first_0)
    {
        _S65 = first_0.half_width_1;
    }
    else
    {
        _S65 = second_0.half_width_1;
    }
    cell_4.half_width_1 = _S65;
    if(is_first_0)
    {
        _S65 = first_0.below_0;
    }
    else
    {
        _S65 = second_0.below_0;
    }
    cell_4.below_0 = _S65;
    if(is_first_0)
    {
        _S65 = first_0.above_0;
    }
    else
    {
        _S65 = second_0.above_0;
    }
    cell_4.above_0 = _S65;
    return cell_4;
}

fn boundary_0( family_4 : u32,  thread_4 : u32,  step_0 : i32) -> f32
{
    var _S66 : vec2<f32> = turns_and_remainder_0(family_4, f32(i32(thread_4) + step_0));
    return fma(_S66.x, families_0[family_4].period_0, table_number_0(families_0[family_4].place_table_0 + u32(_S66.y) * u32(4)));
}

fn span_0( family_5 : u32,  thread_5 : u32,  first_1 : i32,  last_0 : i32) -> f32
{
    if((families_0[family_5].is_alike_0) != u32(0))
    {
        return f32(last_0 - first_1) * families_0[family_5].size_0;
    }
    return boundary_0(family_5, thread_5, last_0) - boundary_0(family_5, thread_5, first_1);
}

struct Bend_0
{
     sine_0 : f32,
     half_tangent_0 : f32,
     arc_0 : f32,
};

fn bend_of_0( family_6 : u32,  thread_6 : u32) -> Bend_0
{
    var _S67 : u32 = families_0[family_6].bend_table_0;
    var _S68 : u32;
    if((families_0[family_6].is_alike_0) != u32(0))
    {
        _S68 = u32(0);
    }
    else
    {
        _S68 = thread_6 * u32(4);
    }
    var _S69 : u32 = _S67 + _S68;
    var bend_0 : Bend_0;
    bend_0.sine_0 = table_number_0(_S69);
    bend_0.half_tangent_0 = table_number_0(_S69 + u32(1));
    bend_0.arc_0 = table_number_0(_S69 + u32(2));
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
    var _S70 : i32 = i32((((word_1 >> (u32(1)))) & (u32(127))));
    var _S71 : i32 = i32((((word_1 >> (u32(8)))) & (u32(127))));
    var _S72 : i32 = i32((((word_1 >> (u32(15)))) & (u32(63))));
    var _S73 : i32 = i32((((word_1 >> (u32(21)))) & (u32(63))));
    var run_0 : Run_0;
    run_0.straight_0 = ((((word_1 >> (u32(27)))) & (u32(1)))) == u32(1);
    var _S74 : i32 = - _S70;
    var _S75 : f32 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_2, _S74, i32(0));
    run_0.from_start_0 = _S75;
    var _S76 : i32 = _S71 + i32(1);
    var _S77 : f32 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_2, i32(1), _S76);
    run_0.to_end_0 = _S77;
    var _S78 : bool = _S75 < _S77;
    run_0.near_start_0 = _S78;
    var _S79 : i32;
    if(_S78)
    {
        _S79 = _S74 - _S72;
    }
    else
    {
        _S79 = _S76;
    }
    var _S80 : i32;
    if(run_0.near_start_0)
    {
        _S80 = _S74;
    }
    else
    {
        _S80 = _S76 + _S73;
    }
    run_0.bend_1 = bend_of_0(own_0, thread_7);
    var _S81 : f32;
    if(run_0.straight_0)
    {
        _S81 = 1.0e+06f;
    }
    else
    {
        _S81 = min(run_0.from_start_0, run_0.to_end_0);
    }
    run_0.distance_1 = _S81;
    run_0.reach_0 = min(0.5f * (run_0.from_start_0 + run_0.to_end_0), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_2, _S79, _S80), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S70 == i32(0);
    run_0.last_crossing_0 = _S71 == i32(0);
    return run_0;
}

fn square_1( x_6 : f32) -> f32
{
    return x_6 * x_6;
}

struct Section_0
{
     across_1 : f32,
     drop_0 : f32,
     slope_0 : f32,
};

fn section_at_0( cell_5 : Cell_0) -> Section_0
{
    var _S82 : f32 = cell_5.half_width_1 * 1.0154266357421875f;
    var section_0 : Section_0;
    var _S83 : f32 = clamp(cell_5.across_0, - cell_5.half_width_1, cell_5.half_width_1);
    section_0.across_1 = _S83;
    var _S84 : f32 = _S82 * _S82 - square_1(_S83);
    var _S85 : f32 = rsqrt_0(_S84);
    section_0.drop_0 = _S82 - _S84 * _S85;
    section_0.slope_0 = - _S83 * _S85;
    return section_0;
}

fn edge_drop_0( family_7 : u32,  thread_8 : u32,  step_1 : i32) -> f32
{
    if((families_0[family_7].is_alike_0) != u32(0))
    {
        return table_number_0(families_0[family_7].bend_table_0 + u32(3));
    }
    return table_number_0(families_0[family_7].bend_table_0 + u32(turns_and_remainder_0(family_7, f32(i32(thread_8) + step_1)).y) * u32(4) + u32(3));
}

fn dive_0( other_1 : u32,  shown_1 : Shown_0,  run_1 : Run_0,  crossed_1 : Cell_0) -> vec2<f32>
{
    var _S86 : bool = (crossed_1.below_0) < (crossed_1.above_0);
    var _S87 : f32 = min(crossed_1.below_0, crossed_1.above_0);
    var _S88 : f32;
    if(_S86)
    {
        _S88 = crossed_1.below_0 - crossed_1.across_0;
    }
    else
    {
        _S88 = crossed_1.above_0 + crossed_1.across_0;
    }
    var _S89 : f32 = _S88 - crossed_1.half_width_1;
    var _S90 : bool;
    if(_S86)
    {
        _S90 = run_1.first_crossing_0;
    }
    else
    {
        _S90 = run_1.last_crossing_0;
    }
    if(shown_1.on_top_0)
    {
        _S88 = 0.0f;
    }
    else
    {
        _S88 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_2, i32(0));
    }
    var _S91 : f32;
    if((shown_1.on_top_0) != _S90)
    {
        _S91 = 0.0f;
    }
    else
    {
        var _S92 : f32 = families_0[other_1].height_scale_0;
        var _S93 : i32;
        if(_S86)
        {
            _S93 = i32(-1);
        }
        else
        {
            _S93 = i32(1);
        }
        _S91 = _S92 * edge_drop_0(other_1, crossed_1.thread_2, _S93);
    }
    var _S94 : f32 = 1.0f / max(2.0f * _S89, 9.999999960041972e-13f);
    var _S95 : f32 = clamp((_S89 - _S87) * _S94, 0.0f, 1.0f);
    var _S96 : f32 = _S88 + (_S91 - _S88) * (_S95 * _S95 * (3.0f - 2.0f * _S95));
    var _S97 : f32 = (_S88 - _S91) * (6.0f * _S95 * (1.0f - _S95) * _S94);
    if(_S86)
    {
        _S88 = 1.0f;
    }
    else
    {
        _S88 = -1.0f;
    }
    return vec2<f32>(_S96, _S97 * _S88);
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

fn step_control_0( direction_3 : vec2<f32>,  step_3 : f32) -> StepControl_0
{
    var control_0 : StepControl_0;
    control_0.step_2 = step_3;
    control_0.epsilon_0 = 0.00499999988824129f * step_3;
    var _S98 : f32 = direction_3.x;
    control_0.per_x_0 = 1.0f / max(abs(_S98), 9.99999971718068537e-10f);
    var _S99 : f32 = direction_3.y;
    control_0.per_y_0 = 1.0f / max(abs(_S99), 9.99999971718068537e-10f);
    control_0.right_0 = _S98 > 0.0f;
    control_0.up_0 = _S99 > 0.0f;
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
    var _S100 : f32;
    if(forwards_0)
    {
        _S100 = cell_6.across_0;
    }
    else
    {
        _S100 = - cell_6.across_0;
    }
    var _S101 : f32;
    if(forwards_0)
    {
        _S101 = cell_6.above_0;
    }
    else
    {
        _S101 = cell_6.below_0;
    }
    var _S102 : bool;
    if(forwards_0)
    {
        _S102 = run_2.last_crossing_0;
    }
    else
    {
        _S102 = run_2.first_crossing_0;
    }
    var _S103 : bool;
    if(forwards_0)
    {
        _S103 = run_2.first_crossing_0;
    }
    else
    {
        _S103 = run_2.last_crossing_0;
    }
    var _S104 : f32 = - cell_6.half_width_1;
    var _S105 : bool = _S100 < _S104;
    var _S106 : bool = _S100 >= (cell_6.half_width_1);
    if(lengthwise_0)
    {
        _S102 = !_S102;
    }
    else
    {
        _S102 = false;
    }
    if(_S102)
    {
        _S102 = !shown_2.hole_0;
    }
    else
    {
        _S102 = false;
    }
    var _S107 : bool;
    if(_S102)
    {
        _S107 = shown_2.on_top_0;
    }
    else
    {
        _S107 = false;
    }
    if(_S107)
    {
        if(_S103)
        {
            _S103 = _S105;
        }
        else
        {
            _S103 = false;
        }
        _S103 = !_S103;
    }
    else
    {
        _S103 = false;
    }
    if(shown_2.hole_0)
    {
        _S102 = true;
    }
    else
    {
        if(_S102)
        {
            _S102 = !shown_2.on_top_0;
        }
        else
        {
            _S102 = false;
        }
    }
    var _S108 : f32;
    if(_S105)
    {
        _S108 = _S104;
    }
    else
    {
        _S108 = cell_6.half_width_1;
    }
    var _S109 : f32 = _S108 - _S100;
    if(_S102)
    {
        _S100 = 2.0f * _S101 + _S100 - cell_6.half_width_1;
    }
    else
    {
        _S100 = _S101;
    }
    if(_S103)
    {
        if(forwards_0)
        {
            _S100 = run_2.to_end_0;
        }
        else
        {
            _S100 = run_2.from_start_0;
        }
        return _S100;
    }
    if(_S106)
    {
    }
    else
    {
        _S100 = _S109;
    }
    return _S100;
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
    var _S110 : f32 = previous_1.rate_0 * step_4;
    var _S111 : f32 = rate_1 * step_4;
    var _S112 : bool;
    if(!previous_1.known_0)
    {
        _S112 = true;
    }
    else
    {
        _S112 = here_0.hole_1;
    }
    if(_S112)
    {
        _S112 = true;
    }
    else
    {
        _S112 = (previous_1.yarn_0) != (here_0.yarn_1);
    }
    if(_S112)
    {
        _S112 = true;
    }
    else
    {
        _S112 = (previous_1.rate_0) >= 0.0f;
    }
    if(_S112)
    {
        _S112 = true;
    }
    else
    {
        _S112 = rate_1 <= 0.0f;
    }
    if(_S112)
    {
        return -1.0f;
    }
    if((3.0f * previous_1.clearance_0 + _S110) >= 0.0f)
    {
        _S112 = (3.0f * clearance_1 - _S111) >= 0.0f;
    }
    else
    {
        _S112 = false;
    }
    if(_S112)
    {
        return -1.0f;
    }
    var _S113 : f32 = clearance_1 - previous_1.clearance_0;
    var _S114 : f32 = 6.0f * _S113 - 4.0f * _S110 - 2.0f * _S111;
    var _S115 : f32 = -2.0f * _S110 / max(_S114 + sqrt(max(_S114 * _S114 - 4.0f * (3.0f * (_S110 + _S111 - 2.0f * _S113)) * _S110, 0.0f)), 9.99999968265522539e-21f);
    var _S116 : f32 = 1.0f - _S115;
    var _S117 : f32 = (previous_1.clearance_0 * (2.0f * _S115 + 1.0f) + _S110 * _S115) * _S116 * _S116;
    var _S118 : f32 = (clearance_1 * (2.0f * _S116 + 1.0f) - _S111 * _S116) * _S115 * _S115;
    if(_S115 > 0.01999999955296516f)
    {
        _S112 = _S116 > 0.01999999955296516f;
    }
    else
    {
        _S112 = false;
    }
    if(_S112)
    {
        _S112 = (_S117 + _S118) < 0.0f;
    }
    else
    {
        _S112 = false;
    }
    var _S119 : f32;
    if(_S112)
    {
        _S119 = _S116 * step_4;
    }
    else
    {
        _S119 = -1.0f;
    }
    return _S119;
}

fn after_sample_0( clearance_2 : f32,  rate_2 : f32,  here_1 : Probe_0,  is_cell_exit_0 : bool) -> PreviousSample_0
{
    var previous_2 : PreviousSample_0;
    var _S120 : f32;
    if(here_1.hole_1)
    {
        _S120 = 1.0e+09f;
    }
    else
    {
        _S120 = clearance_2;
    }
    previous_2.clearance_0 = _S120;
    previous_2.rate_0 = rate_2;
    previous_2.yarn_0 = here_1.yarn_1;
    var _S121 : bool;
    if(!here_1.hole_1)
    {
        _S121 = !is_cell_exit_0;
    }
    else
    {
        _S121 = false;
    }
    previous_2.known_0 = _S121;
    return previous_2;
}

fn StepControl_to_cell_exit_0( this_1 : StepControl_0,  side_x_1 : f32,  side_y_1 : f32) -> f32
{
    return max(min(side_x_1 * this_1.per_x_0, side_y_1 * this_1.per_y_0), 0.0f) + this_1.epsilon_0;
}

fn StepControl_to_next_sample_0( this_2 : StepControl_0,  here_2 : Probe_0,  clearance_3 : f32,  rate_3 : f32) -> f32
{
    var _S122 : f32 = min(here_2.edge_x_0 * this_2.per_x_0, here_2.edge_y_0 * this_2.per_y_0);
    var _S123 : bool;
    if(!here_2.hole_1)
    {
        _S123 = (rate_3 * _S122 + clearance_3) < 0.0f;
    }
    else
    {
        _S123 = false;
    }
    if(_S123)
    {
        _S123 = _S122 > (2.0f * this_2.epsilon_0);
    }
    else
    {
        _S123 = false;
    }
    var _S124 : f32;
    if(_S123)
    {
        _S124 = _S122 - this_2.epsilon_0;
    }
    else
    {
        _S124 = max(_S122, 0.0f) + this_2.epsilon_0;
    }
    return min(this_2.step_2, _S124);
}

struct ViewRay_0
{
     origin_2 : vec2<f32>,
     slope_1 : vec2<f32>,
};

fn ViewRay_at_0( this_3 : ViewRay_0,  height_3 : f32) -> vec2<f32>
{
    return this_3.origin_2 + this_3.slope_1 * vec2<f32>(height_3);
}

fn ViewRay_rate_0( this_4 : ViewRay_0,  here_3 : Probe_0) -> f32
{
    return here_3.slope_x_0 * this_4.slope_1.x + here_3.slope_y_0 * this_4.slope_1.y - 1.0f;
}

fn cubic_root_0( start_1 : f32,  end_0 : f32,  start_rate_0 : f32,  end_rate_0 : f32) -> f32
{
    var _S125 : f32 = end_0 - start_1;
    var _S126 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S125;
    var _S127 : f32 = 3.0f * _S125 - 2.0f * start_rate_0 - end_rate_0;
    var share_1 : f32 = start_1 / max(- _S125, 9.99999968265522539e-21f);
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
        var _S128 : f32 = clamp(share_1 - (((_S126 * share_1 + _S127) * share_1 + start_rate_0) * share_1 + start_1) / min((3.0f * _S126 * share_1 + 2.0f * _S127) * share_1 + start_rate_0, 0.10000000149011612f * _S125 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S129 : i32 = i_0 + i32(1);
        share_1 = _S128;
        i_0 = _S129;
    }
    return share_1;
}

fn between_0( above_1 : f32,  under_0 : f32,  above_gap_0 : f32,  under_gap_0 : f32) -> f32
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

fn arc_tangent_quotient_0( x_7 : f32,  y_2 : f32) -> f32
{
    return ((((((0.0f * x_7 + 0.00809729471802711f) * x_7 + -0.0377517081797123f) * x_7 + 0.08475969731807709f) * x_7 + -0.13537675142288208f) * x_7 + 0.19895026087760925f) * x_7 + -0.33327975869178772f) * x_7 + 0.99999970197677612f;
}

fn arc_tangent_of_ratio_0( ratio_0 : f32) -> f32
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0f);
}

fn arc_tangent_0( y_3 : f32,  x_8 : f32) -> f32
{
    var _S130 : f32 = abs(x_8);
    var _S131 : f32 = abs(y_3);
    var angle_0 : f32 = arc_tangent_of_ratio_0(min(_S130, _S131) / max(max(_S130, _S131), 1.00000000317107685e-30f));
    var angle_1 : f32;
    if(_S131 > _S130)
    {
        angle_1 = 1.57079637050628662f - angle_0;
    }
    else
    {
        angle_1 = angle_0;
    }
    if(x_8 < 0.0f)
    {
        angle_1 = 3.14159274101257324f - angle_1;
    }
    if(y_3 < 0.0f)
    {
        angle_1 = - angle_1;
    }
    return angle_1;
}

struct NodeTaps_0
{
     nodes_0 : vec4<u32>,
     weights_0 : vec4<u32>,
     inverse_sum_0 : f32,
};

fn node_taps_0( direction_4 : vec3<f32>) -> NodeTaps_0
{
    var _S132 : f32 = arc_tangent_0(direction_4.y, direction_4.x) * 5.09295797348022461f;
    var _S133 : f32 = floor(_S132);
    var _S134 : f32 = _S132 - _S133;
    var _S135 : f32 = sqrt(clamp((1.0f - abs(direction_4.z)) / 0.97000002861022949f, 0.0f, 1.0f));
    var _S136 : f32 = 7.0f * _S135 * sqrt(_S135);
    var _S137 : f32 = min(floor(_S136), 6.0f);
    var _S138 : f32 = _S136 - _S137;
    var _S139 : u32 = u32(i32(_S133) + i32(32)) % u32(32);
    var _S140 : u32 = u32(_S137);
    var _S141 : u32 = _S139 * u32(8) + _S140;
    var _S142 : u32 = (_S139 + u32(1)) % u32(32) * u32(8) + _S140;
    var taps_0 : NodeTaps_0;
    taps_0.nodes_0 = vec4<u32>(_S141, _S141 + u32(1), _S142, _S142 + u32(1));
    var _S143 : f32 = 1.0f - _S134;
    var _S144 : f32 = 1.0f - _S138;
    var _S145 : vec4<u32> = vec4<u32>(vec4<f32>(_S143 * _S144, _S143 * _S138, _S134 * _S144, _S134 * _S138) * vec4<f32>(252.0f) + vec4<f32>(0.5f));
    taps_0.weights_0 = _S145;
    taps_0.inverse_sum_0 = 1.0f / f32(_S145.x + _S145.y + _S145.z + _S145.w);
    return taps_0;
}

fn wrapped_cell_0( position_4 : f32,  count_2 : f32) -> f32
{
    return min(floor((position_4 - floor(position_4)) * count_2), count_2 - 1.0f);
}

fn bytes_of_sums_0( even_0 : u32,  odd_0 : u32) -> vec4<f32>
{
    return vec4<f32>(f32((even_0 & (u32(65535)))), f32((odd_0 & (u32(65535)))), f32((even_0 >> (u32(16)))), f32((odd_0 >> (u32(16)))));
}

fn interpolate_0( taps_1 : NodeTaps_0,  packs_1 : vec4<u32>) -> vec4<f32>
{
    var _S146 : vec4<u32> = vec4<u32>(u32(16711935));
    var _S147 : vec4<u32> = ((packs_1 & (_S146))) * taps_1.weights_0;
    var _S148 : vec4<u32> = ((((packs_1 >> (vec4<u32>(u32(8))))) & (_S146))) * taps_1.weights_0;
    return bytes_of_sums_0(_S147.x + _S147.y + _S147.z + _S147.w, _S148.x + _S148.y + _S148.z + _S148.w) * vec4<f32>(taps_1.inverse_sum_0);
}

fn interpolate_table_0( taps_2 : NodeTaps_0,  table_1 : u32,  stride_0 : u32) -> vec4<f32>
{
    var _S149 : vec4<u32> = vec4<u32>(table_1) + taps_2.nodes_0 * vec4<u32>(stride_0);
    return interpolate_0(taps_2, vec4<u32>(words_0[_S149.x], words_0[_S149.y], words_0[_S149.z], words_0[_S149.w]));
}

fn sheen_scale_0( x_9 : f32,  y_4 : f32) -> f32
{
    return (((((0.0f * x_9 + (((((-1.1402510404586792f * y_4 + 0.40672621130943298f) * y_4 + 1.65398800373077393f) * y_4 + -1.29730904102325439f) * y_4 + 0.30570998787879944f) * y_4 + -0.0220868494361639f)) * x_9 + (((((-0.21142719686031342f * y_4 + 1.05947399139404297f) * y_4 + -0.41116121411323547f) * y_4 + -0.93859231472015381f) * y_4 + 0.51606941223144531f) * y_4 + 0.05409301072359085f)) * x_9 + (((((1.22944498062133789f * y_4 + -0.45962560176849365f) * y_4 + -1.63861405849456787f) * y_4 + 1.33565104007720947f) * y_4 + -0.45725581049919128f) * y_4 + 0.08243165910243988f)) * x_9 + (((((0.39779931306838989f * y_4 + -1.18879103660583496f) * y_4 + 0.28251591324806213f) * y_4 + 1.168984055519104f) * y_4 + -0.76864629983901978f) * y_4 + 0.0091691892594099f)) * x_9 + (((((-0.26563560962677002f * y_4 + -0.19379159808158875f) * y_4 + 0.2677634060382843f) * y_4 + 0.00270519289188087f) * y_4 + 0.14349560439586639f) * y_4 + 0.10290180146694183f)) * x_9 + (((((-0.20701569318771362f * y_4 + 0.24526430666446686f) * y_4 + 0.19551840424537659f) * y_4 + 0.07586126774549484f) * y_4 + 0.38894739747047424f) * y_4 + 0.15043120086193085f);
}

fn sheen_shear_0( x_10 : f32,  y_5 : f32) -> f32
{
    return ((((0.0f * x_10 + (((((-0.10608240216970444f * y_5 + 1.99214303493499756f) * y_5 + -1.42255294322967529f) * y_5 + -1.09495604038238525f) * y_5 + 0.59180057048797607f) * y_5 + 0.06902855634689331f)) * x_10 + (((((-0.46220690011978149f * y_5 + -0.29113379120826721f) * y_5 + 1.39025199413299561f) * y_5 + 0.35589990019798279f) * y_5 + -1.17120099067687988f) * y_5 + 0.15940259397029877f)) * x_10 + (((((2.26068711280822754f * y_5 + -3.64728999137878418f) * y_5 + -0.72173482179641724f) * y_5 + 3.07659196853637695f) * y_5 + -0.6827620267868042f) * y_5 + -0.3039557933807373f)) * x_10 + (((((0.81201767921447754f * y_5 + 0.36014080047607422f) * y_5 + -1.72646903991699219f) * y_5 + -0.22630110383033752f) * y_5 + 0.89514690637588501f) * y_5 + -0.10397960245609283f)) * x_10 + (((((-0.37648698687553406f * y_5 + 1.10974001884460449f) * y_5 + 0.17824520170688629f) * y_5 + -1.04968702793121338f) * y_5 + 0.1461234986782074f) * y_5 + -0.00475129019469023f);
}

fn sheen_reflectance_0( x_11 : f32,  y_6 : f32) -> f32
{
    return ((((0.0f * x_11 + (((((12.95646953582763672f * y_6 + -21.38032913208007812f) * y_6 + -7.37853097915649414f) * y_6 + 34.55607986450195312f) * y_6 + -23.61347007751464844f) * y_6 + 5.00126314163208008f)) * x_11 + (((((10.91487026214599609f * y_6 + -6.08202791213989258f) * y_6 + -38.2036285400390625f) * y_6 + 53.3440399169921875f) * y_6 + -21.91996002197265625f) * y_6 + 2.01606011390686035f)) * x_11 + (((((-14.52206039428710938f * y_6 + 36.803619384765625f) * y_6 + -22.94047927856445312f) * y_6 + -10.07973003387451172f) * y_6 + 15.77003955841064453f) * y_6 + -4.92722177505493164f)) * x_11 + (((((-7.62505722045898438f * y_6 + 1.27310299873352051f) * y_6 + 31.19523048400878906f) * y_6 + -44.39989852905273438f) * y_6 + 26.44947052001953125f) * y_6 + -8.73507976531982422f)) * x_11 + (((((5.65633487701416016f * y_6 + -17.66820907592773438f) * y_6 + 24.65356063842773438f) * y_6 + -19.38941001892089844f) * y_6 + 11.06159019470214844f) * y_6 + -3.06573700904846191f);
}

fn exponential_0( x_12 : f32) -> f32
{
    var _S150 : f32 = clamp(x_12, -87.0f, 88.0f);
    var _S151 : f32 = floor(_S150 * 1.4426950216293335f + 0.5f);
    var _S152 : f32 = _S150 - _S151 * 0.693359375f + _S151 * 0.00021219444170129f;
    var p_0 : f32 = ((((0.00019875691214111f * _S152 + 0.00139819993637502f) * _S152 + 0.00833345204591751f) * _S152 + 0.04166579619050026f) * _S152 + 0.1666666567325592f) * _S152 + 0.5f;
    var _S153 : f32 = (bitcast<f32>(((u32(i32(_S151) + i32(127)) << (u32(23))))));
    var _S154 : f32;
    if(x_12 < -87.0f)
    {
        _S154 = 0.0f;
    }
    else
    {
        _S154 = (p_0 * _S152 * _S152 + _S152 + 1.0f) * _S153;
    }
    return _S154;
}

fn sheen_lobe_0( cos_view_0 : f32,  roughness_1 : f32) -> vec3<f32>
{
    var _S155 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S156 : f32 = 2.0f * sqrt(_S155) - 1.0f;
    var _S157 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_1, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S156, _S157), 0.00999999977648258f, 1.0f), clamp((1.0f - _S155) * sheen_shear_0(_S156, _S157), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S156, _S157), -60.0f, 60.0f))));
}

fn camera_right_0( _S158 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S158].right_x_0, frames_0[_S158].right_y_0, frames_0[_S158].right_z_0);
}

fn camera_up_0( _S159 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S159].up_x_0, frames_0[_S159].up_y_0, frames_0[_S159].up_z_0);
}

fn camera_forward_0( _S160 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S160].forward_x_0, frames_0[_S160].forward_y_0, frames_0[_S160].forward_z_0);
}

fn camera_origin_0( _S161 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S161].origin_x_0, frames_0[_S161].origin_y_0, frames_0[_S161].origin_z_0);
}

fn face_point_0( _S162 : u32,  _S163 : u32,  _S164 : f32,  _S165 : f32) -> VisiblePoint_0
{
    var _S166 : u32 = u32(3) * _S163;
    var _S167 : Vertex_std430_0 = vertices_0[corners_0[_S166]];
    var _S168 : Vertex_std430_0 = vertices_0[corners_0[_S166 + u32(1)]];
    var _S169 : Vertex_std430_0 = vertices_0[corners_0[_S166 + u32(2)]];
    var _S170 : vec3<f32> = position_of_0(&(_S168));
    var _S171 : vec3<f32> = position_of_0(&(_S167));
    var _S172 : vec3<f32> = _S170 - _S171;
    var _S173 : vec3<f32> = position_of_0(&(_S169));
    var _S174 : vec3<f32> = _S173 - _S171;
    var _S175 : f32 = _S167.u_0;
    var _S176 : f32 = _S168.u_0 - _S167.u_0;
    var _S177 : f32 = _S167.v_0;
    var _S178 : f32 = _S168.v_0 - _S167.v_0;
    var _S179 : vec2<f32> = vec2<f32>(_S176, _S178);
    var _S180 : f32 = _S169.u_0 - _S167.u_0;
    var _S181 : f32 = _S169.v_0 - _S167.v_0;
    var _S182 : vec2<f32> = vec2<f32>(_S180, _S181);
    var _S183 : f32;
    if((_S176 * _S181 - _S178 * _S180) < 0.0f)
    {
        _S183 = -1.0f;
    }
    else
    {
        _S183 = 1.0f;
    }
    var _S184 : vec3<f32> = vec3<f32>(_S183) * (vec3<f32>(_S181) * _S172 - vec3<f32>(_S178) * _S174);
    var _S185 : vec3<f32> = vec3<f32>(_S183) * (vec3<f32>(_S176) * _S174 - vec3<f32>(_S180) * _S172);
    var point_1 : VisiblePoint_0;
    var _S186 : f32 = 1.0f - _S164 - _S165;
    var _S187 : vec3<f32> = normal_of_0(&(_S167));
    var _S188 : vec3<f32> = vec3<f32>(_S186) * _S187;
    var _S189 : vec3<f32> = normal_of_0(&(_S168));
    var _S190 : vec3<f32> = vec3<f32>(_S164);
    var _S191 : vec3<f32> = _S188 + _S190 * _S189;
    var _S192 : vec3<f32> = normal_of_0(&(_S169));
    var _S193 : vec3<f32> = vec3<f32>(_S165);
    var _S194 : vec3<f32> = normalize(_S191 + _S193 * _S192);
    point_1.normal_0 = _S194;
    var _S195 : vec3<f32> = normalize(_S184 - _S194 * vec3<f32>(dot(_S194, _S184)));
    point_1.axis_x_0 = _S195;
    point_1.axis_y_0 = cross(_S194, _S195);
    var _S196 : vec3<f32> = normalize(cross(_S172, _S174));
    var _S197 : vec3<f32>;
    if((dot(_S196, _S194)) < 0.0f)
    {
        _S197 = (vec3<f32>(0) - _S196);
    }
    else
    {
        _S197 = _S196;
    }
    point_1.face_normal_0 = _S197;
    point_1.position_0 = _S171 + _S190 * _S172 + _S193 * _S174;
    point_1.view_1 = point_1.normal_0;
    point_1.uv_0 = vec2<f32>(_S175, _S177) + vec2<f32>(_S164) * _S179 + vec2<f32>(_S165) * _S182;
    var _S198 : bool = (dot(cross(_S184, _S185), point_1.normal_0)) < 0.0f;
    var _S199 : f32 = fabrics_0[_S162].uv_width_0;
    if(_S198)
    {
        _S183 = - fabrics_0[_S162].uv_height_0;
    }
    else
    {
        _S183 = fabrics_0[_S162].uv_height_0;
    }
    var _S200 : vec2<f32> = vec2<f32>(_S199, _S183);
    point_1.draft_per_uv_0 = _S200;
    var _S201 : vec2<f32> = point_1.uv_0 * _S200;
    if(_S198)
    {
        _S183 = fabrics_0[_S162].uv_height_0;
    }
    else
    {
        _S183 = 0.0f;
    }
    point_1.draft_0 = _S201 + vec2<f32>(0.0f, _S183);
    var _S202 : vec2<f32> = vec2<f32>(0.0f);
    point_1.draft_dx_0 = _S202;
    point_1.draft_dy_0 = _S202;
    return point_1;
}

fn visible_point_0( _S203 : i32,  _S204 : u32,  _S205 : u32,  _S206 : vec2<u32>) -> VisiblePoint_0
{
    var _S207 : u32 = u32(3) * _S205;
    var _S208 : Vertex_std430_0 = vertices_0[corners_0[_S207]];
    var _S209 : Vertex_std430_0 = vertices_0[corners_0[_S207 + u32(1)]];
    var _S210 : Vertex_std430_0 = vertices_0[corners_0[_S207 + u32(2)]];
    var _S211 : vec3<f32> = position_of_3(&(_S209));
    var _S212 : vec3<f32> = position_of_3(&(_S208));
    var _S213 : vec3<f32> = _S211 - _S212;
    var _S214 : vec3<f32> = position_of_3(&(_S210));
    var _S215 : vec3<f32> = _S214 - _S212;
    var _S216 : vec3<f32> = cross(_S213, _S215);
    var _S217 : f32 = 1.0f / max(square_0(_S216), 1.00000000317107685e-30f);
    var _S218 : f32 = f32(frames_0[_S203].width_0);
    var _S219 : vec3<f32> = camera_right_0(_S203) * vec3<f32>((2.0f / _S218));
    var _S220 : f32 = f32(frames_0[_S203].height_0);
    var _S221 : vec3<f32> = camera_up_0(_S203) * vec3<f32>((-2.0f / _S220));
    var _S222 : vec3<f32> = camera_forward_0(_S203) + vec3<f32>((f32(_S206.x) + 0.5f - 0.5f * _S218)) * _S219 + vec3<f32>((f32(_S206.y) + 0.5f - 0.5f * _S220)) * _S221;
    var _S223 : f32 = dot(_S222, _S216);
    var _S224 : f32;
    if((abs(_S223)) > 1.00000000317107685e-30f)
    {
        _S224 = _S223;
    }
    else
    {
        _S224 = 1.00000000317107685e-30f;
    }
    var _S225 : f32 = 1.0f / _S224;
    var _S226 : vec3<f32> = _S212 - camera_origin_0(_S203);
    var _S227 : vec3<f32> = vec3<f32>((dot(_S226, _S216) * _S225));
    var _S228 : vec3<f32> = _S222 * _S227 - _S226;
    var _S229 : vec3<f32> = _S227 * (_S219 - _S222 * vec3<f32>((dot(_S219, _S216) * _S225)));
    var _S230 : vec3<f32> = _S227 * (_S221 - _S222 * vec3<f32>((dot(_S221, _S216) * _S225)));
    var _S231 : vec3<f32> = vec3<f32>(_S217);
    var _S232 : vec3<f32> = cross(_S215, _S216) * _S231;
    var _S233 : vec3<f32> = cross(_S216, _S213) * _S231;
    var _S234 : vec2<f32> = vec2<f32>(_S209.u_0 - _S208.u_0, _S209.v_0 - _S208.v_0);
    var _S235 : vec2<f32> = vec2<f32>(_S210.u_0 - _S208.u_0, _S210.v_0 - _S208.v_0);
    var point_2 : VisiblePoint_0 = face_point_0(_S204, _S205, dot(_S228, _S232), dot(_S228, _S233));
    point_2.position_0 = _S212 + _S228;
    point_2.view_1 = (vec3<f32>(0) - normalize(_S222));
    point_2.draft_dx_0 = (vec2<f32>(dot(_S229, _S232)) * _S234 + vec2<f32>(dot(_S229, _S233)) * _S235) * point_2.draft_per_uv_0;
    point_2.draft_dy_0 = (vec2<f32>(dot(_S230, _S232)) * _S234 + vec2<f32>(dot(_S230, _S233)) * _S235) * point_2.draft_per_uv_0;
    return point_2;
}

fn light_sample_count_0( _S236 : i32) -> u32
{
    return frames_0[_S236].lights_0 + frames_0[_S236].environment_samples_0;
}

struct LightSample_0
{
     towards_0 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_2 : f32,
};

fn environment_texel_0( _S237 : i32,  _S238 : u32,  _S239 : u32) -> vec3<f32>
{
    var _S240 : u32 = frames_0[_S237].environment_table_0 + frames_0[_S237].environment_rows_0 + u32(1) + frames_0[_S237].environment_rows_0 * (frames_0[_S237].environment_columns_0 + u32(1)) + u32(3) * (_S238 * frames_0[_S237].environment_columns_0 + _S239);
    return vec3<f32>(scene_number_0(_S240), scene_number_0(_S240 + u32(1)), scene_number_0(_S240 + u32(2)));
}

fn sample_environment_0( _S241 : i32,  _S242 : vec2<f32>,  _S243 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S244 : u32 = frames_0[_S241].environment_rows_0;
    var _S245 : Choice_0 = choose_0(frames_0[_S241].environment_table_0, frames_0[_S241].environment_rows_0, _S242.y);
    var _S246 : u32 = frames_0[_S241].environment_columns_0;
    var _S247 : Choice_0 = choose_0(frames_0[_S241].environment_table_0 + frames_0[_S241].environment_rows_0 + u32(1) + _S245.index_2 * (frames_0[_S241].environment_columns_0 + u32(1)), frames_0[_S241].environment_columns_0, _S242.x);
    var _S248 : vec3<f32> = environment_texel_0(_S241, _S245.index_2, _S247.index_2);
    (*_S243) = _S248 * vec3<f32>((frames_0[_S241].environment_total_0 / max(mean_0(_S248), 9.99999968265522539e-21f)));
    var _S249 : f32 = 3.14159274101257324f / f32(_S244);
    var _S250 : f32 = mix(sine_cosine_0(f32(_S245.index_2) * _S249).y, sine_cosine_0(f32(_S245.index_2 + u32(1)) * _S249).y, _S245.remainder_0);
    var _S251 : f32 = sqrt(max(1.0f - _S250 * _S250, 0.0f));
    var _S252 : vec2<f32> = sine_cosine_0((f32(_S247.index_2) + _S247.remainder_0) * (6.28318548202514648f / f32(_S246)));
    var _S253 : f32 = _S251 * _S252.x;
    var _S254 : f32 = - _S251 * _S252.y;
    return vec3<f32>(frames_0[_S241].environment_cosine_0 * _S253 + frames_0[_S241].environment_sine_0 * _S254, _S250, frames_0[_S241].environment_cosine_0 * _S254 - frames_0[_S241].environment_sine_0 * _S253);
}

fn light_sample_0( _S255 : i32,  _S256 : u32,  _S257 : vec2<u32>,  _S258 : vec3<f32>) -> LightSample_0
{
    var sample_0 : LightSample_0;
    sample_0.distance_2 = 1.00000001504746622e+30f;
    var _S259 : u32 = frames_0[_S255].lights_0;
    if(_S256 >= (frames_0[_S255].lights_0))
    {
        var weight_0 : vec3<f32>;
        var _S260 : vec3<f32> = sample_environment_0(_S255, pixel_sequence_0(_S257, frames_0[_S255].pass_number_0 * frames_0[_S255].environment_samples_0 + (_S256 - _S259), u32(3)), &(weight_0));
        sample_0.towards_0 = _S260;
        sample_0.irradiance_1 = weight_0 / vec3<f32>(f32(frames_0[_S255].environment_samples_0));
        return sample_0;
    }
    var _S261 : Light_std430_0 = lights_1[_S256];
    sample_0.irradiance_1 = vec3<f32>(_S261.red_0, _S261.green_0, _S261.blue_0);
    sample_0.towards_0 = vec3<f32>(_S261.x_1, _S261.y_1, _S261.z_1);
    if((_S261.is_point_0) != u32(0))
    {
        var _S262 : vec3<f32> = sample_0.towards_0 - _S258;
        var _S263 : f32 = max(square_0(_S262), 9.999999960041972e-13f);
        sample_0.distance_2 = sqrt(_S263);
        sample_0.irradiance_1 = sample_0.irradiance_1 / vec3<f32>(_S263);
        sample_0.towards_0 = normalize(_S262);
    }
    return sample_0;
}

fn seen_position_0( _S264 : i32,  _S265 : u32,  _S266 : vec2<u32>) -> vec3<f32>
{
    var _S267 : u32 = u32(3) * _S265;
    var _S268 : Vertex_std430_0 = vertices_0[corners_0[_S267]];
    var _S269 : vec3<f32> = position_of_2(&(_S268));
    var _S270 : Vertex_std430_0 = vertices_0[corners_0[_S267 + u32(1)]];
    var _S271 : vec3<f32> = position_of_2(&(_S270));
    var _S272 : vec3<f32> = _S271 - _S269;
    var _S273 : Vertex_std430_0 = vertices_0[corners_0[_S267 + u32(2)]];
    var _S274 : vec3<f32> = position_of_2(&(_S273));
    var _S275 : vec3<f32> = _S274 - _S269;
    var _S276 : vec3<f32> = cross(_S272, _S275);
    var _S277 : f32 = 1.0f / max(square_0(_S276), 1.00000000317107685e-30f);
    var _S278 : f32 = f32(frames_0[_S264].width_0);
    var _S279 : f32 = f32(frames_0[_S264].height_0);
    var _S280 : vec3<f32> = camera_forward_0(_S264) + camera_right_0(_S264) * vec3<f32>((2.0f * (f32(_S266.x) + 0.5f + frames_0[_S264].jitter_x_0 - 0.5f * _S278) / _S278)) - camera_up_0(_S264) * vec3<f32>((2.0f * (f32(_S266.y) + 0.5f + frames_0[_S264].jitter_y_0 - 0.5f * _S279) / _S279));
    var _S281 : f32 = dot(_S280, _S276);
    var _S282 : vec3<f32> = _S269 - camera_origin_0(_S264);
    var _S283 : f32 = dot(_S282, _S276);
    var _S284 : f32;
    if((abs(_S281)) > 1.00000000317107685e-30f)
    {
        _S284 = _S281;
    }
    else
    {
        _S284 = 1.00000000317107685e-30f;
    }
    var _S285 : vec3<f32> = _S280 * vec3<f32>((_S283 / _S284)) - _S282;
    var _S286 : f32 = clamp(dot(_S285, cross(_S275, _S276)) * _S277, 0.0f, 1.0f);
    return _S269 + vec3<f32>(_S286) * _S272 + vec3<f32>(clamp(dot(_S285, cross(_S276, _S272)) * _S277, 0.0f, 1.0f - _S286)) * _S275;
}

fn nearest_hit_0( _S287 : i32,  _S288 : vec3<f32>,  _S289 : vec3<f32>,  _S290 : f32,  _S291 : f32,  _S292 : u32,  _S293 : bool) -> Hit_0
{
    var _S294 : vec3<f32> = vec3<f32>(inverse_of_0(_S289.x), inverse_of_0(_S289.y), inverse_of_0(_S289.z));
    var found_0 : Hit_0;
    found_0.face_1 = u32(4294967295);
    found_0.distance_0 = _S291;
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
        if(!meets_node_0(node_2, _S288, _S294, _S290, found_0.distance_0))
        {
            node_3 = following_node_0(node_2);
        }
        else
        {
            var _S295 : u32 = frames_0[_S287].leaves_0;
            if(node_2 < (frames_0[_S287].leaves_0))
            {
                node_3 = node_2 * u32(2);
            }
            else
            {
                var _S296 : u32 = frames_0[_S287].leaf_faces_0 + u32(4) * (node_2 - _S295);
                var _S297 : u32 = following_node_0(node_2);
                var number_1 : u32 = u32(0);
                node_3 = _S297;
                for(;;)
                {
                    if(number_1 < u32(4))
                    {
                    }
                    else
                    {
                        break;
                    }
                    var _S298 : u32 = scene_words_0[_S296 + number_1];
                    var _S299 : bool;
                    if(_S298 == u32(4294967295))
                    {
                        _S299 = true;
                    }
                    else
                    {
                        _S299 = _S298 == _S292;
                    }
                    if(_S299)
                    {
                        number_1 = number_1 + u32(1);
                        continue;
                    }
                    var _S300 : Hit_0 = meet_face_0(_S298, _S288, _S289);
                    var _S301 : bool;
                    if((_S300.face_1) == u32(4294967295))
                    {
                        _S301 = true;
                    }
                    else
                    {
                        _S301 = (_S300.distance_0) <= _S290;
                    }
                    var _S302 : bool;
                    if(_S301)
                    {
                        _S302 = true;
                    }
                    else
                    {
                        _S302 = (_S300.distance_0) >= (found_0.distance_0);
                    }
                    if(_S302)
                    {
                        number_1 = number_1 + u32(1);
                        continue;
                    }
                    found_0 = _S300;
                    var _S303 : bool;
                    if(_S293)
                    {
                        _S303 = (fabrics_0[face_fabrics_0[_S298]].is_open_0) == u32(0);
                    }
                    else
                    {
                        _S303 = false;
                    }
                    var node_4 : u32;
                    if(_S303)
                    {
                        node_4 = u32(0);
                    }
                    else
                    {
                        node_4 = node_3;
                    }
                    node_3 = node_4;
                    number_1 = number_1 + u32(1);
                }
            }
        }
        node_2 = node_3;
    }
    return found_0;
}

struct Regime_0
{
     prefiltered_0 : f32,
     threads_0 : f32,
     points_0 : f32,
};

fn regime_of_0( _S304 : u32,  _S305 : Footprint_0,  _S306 : f32) -> Regime_0
{
    var _S307 : f32 = Footprint_spread_side_0(_S305);
    var _S308 : f32 = clamp((binary_logarithm_0(max(_S307, 9.99999971718068537e-10f)) - fabrics_0[_S304].lobes_0.unit_level_0 - -0.7369655966758728f) / 1.41503751277923584f, 0.0f, 1.0f);
    var regime_0 : Regime_0;
    var _S309 : f32 = _S308 * _S308 * (3.0f - 2.0f * _S308);
    regime_0.prefiltered_0 = _S309;
    regime_0.threads_0 = _S307 * fabrics_0[_S304].lobes_0.threads_per_mm_0;
    var _S310 : f32 = mix(max(8.0f / _S306, 1.0f), 1.0f, _S309);
    var _S311 : f32;
    if(_S309 < 1.0f)
    {
        _S311 = clamp(regime_0.threads_0 * 12.0f, 1.0f, _S310);
    }
    else
    {
        _S311 = 0.0f;
    }
    regime_0.points_0 = _S311;
    return regime_0;
}

struct Hit_1
{
     x_13 : f32,
     y_7 : f32,
     hole_2 : bool,
     height_4 : f32,
};

struct Sample_0
{
     crossing_1 : Crossing_0,
     shown_3 : Shown_0,
     run_3 : Run_0,
     section_1 : Section_0,
     height_5 : f32,
     slope_across_0 : f32,
     slope_along_0 : f32,
     slope_x_1 : f32,
     slope_y_1 : f32,
};

fn crossing_at_0( _S312 : u32,  _S313 : f32,  _S314 : f32,  _S315 : bool) -> Crossing_0
{
    var crossing_2 : Crossing_0;
    crossing_2.warp_1 = locate_0(fabrics_0[_S312].warp_0, _S313);
    crossing_2.weft_1 = locate_0(fabrics_0[_S312].weft_0, _S314);
    var _S316 : u32 = fabrics_0[_S312].run_words_0 + u32(2) * (crossing_2.weft_1.thread_2 * fabrics_0[_S312].ends_1 + crossing_2.warp_1.thread_2);
    var _S317 : u32 = words_0[_S316];
    crossing_2.warp_word_0 = _S317;
    crossing_2.weft_word_0 = words_0[_S316 + u32(1)];
    crossing_2.warp_above_0 = (((_S317 & (u32(1)))) == u32(1)) != _S315;
    return crossing_2;
}

fn sample_at_0( _S318 : u32,  _S319 : f32,  _S320 : f32,  _S321 : bool) -> Sample_0
{
    var sample_1 : Sample_0;
    var _S322 : Crossing_0 = crossing_at_0(_S318, _S319, _S320, _S321);
    sample_1.crossing_1 = _S322;
    var _S323 : Shown_0 = shown_at_0(_S322, _S321);
    sample_1.shown_3 = _S323;
    var _S324 : u32;
    if(_S323.is_warp_0)
    {
        _S324 = fabrics_0[_S318].warp_0;
    }
    else
    {
        _S324 = fabrics_0[_S318].weft_0;
    }
    var _S325 : u32;
    if(_S323.is_warp_0)
    {
        _S325 = fabrics_0[_S318].weft_0;
    }
    else
    {
        _S325 = fabrics_0[_S318].warp_0;
    }
    var _S326 : Cell_0 = select_cell_0(_S323.is_warp_0, sample_1.crossing_1.warp_1, sample_1.crossing_1.weft_1);
    var _S327 : Cell_0 = select_cell_0(_S323.is_warp_0, sample_1.crossing_1.weft_1, sample_1.crossing_1.warp_1);
    var _S328 : Run_0 = unpack_0(_S324, _S325, _S326.thread_2, _S327, _S323.word_0);
    var _S329 : Section_0 = section_at_0(_S326);
    var _S330 : bool;
    if(_S323.on_top_0)
    {
        _S330 = (_S328.distance_1) < (_S329.drop_0 * _S328.bend_1.sine_0);
    }
    else
    {
        _S330 = false;
    }
    var _S331 : bool;
    if(_S323.on_top_0)
    {
        _S331 = !_S330;
    }
    else
    {
        _S331 = false;
    }
    var _S332 : f32;
    if(_S331)
    {
        _S332 = 1.0f;
    }
    else
    {
        _S332 = -1.0f;
    }
    var _S333 : f32;
    if(_S330)
    {
        _S333 = _S328.other_reach_0;
    }
    else
    {
        _S333 = _S328.reach_0;
    }
    var _S334 : f32;
    if(_S330)
    {
        _S334 = _S333 + _S328.distance_1;
    }
    else
    {
        _S334 = max(_S333 - _S328.distance_1, 0.0f);
    }
    var _S335 : f32 = _S333 / _S328.bend_1.sine_0 - _S332 * _S329.drop_0;
    var _S336 : f32 = _S334 * _S334;
    var _S337 : f32 = max(_S335 * _S335 - _S336, 9.99999968265522539e-21f);
    var _S338 : f32 = rsqrt_0(_S337);
    var _S339 : f32 = _S336 / (_S337 * _S338 + _S335);
    var _S340 : bool = _S334 > 0.0f;
    var _S341 : f32;
    if(_S323.on_top_0)
    {
        _S341 = 1.0f;
    }
    else
    {
        _S341 = -1.0f;
    }
    var _S342 : f32;
    if(_S328.near_start_0)
    {
        _S342 = 1.0f;
    }
    else
    {
        _S342 = -1.0f;
    }
    var _S343 : f32 = _S341 * _S342;
    if(_S340)
    {
        _S341 = _S335 * _S338;
    }
    else
    {
        _S341 = 1.0f;
    }
    sample_1.slope_across_0 = _S329.slope_0 * _S341;
    if(_S340)
    {
        _S334 = _S343 * _S334 * _S338;
    }
    else
    {
        _S334 = 0.0f;
    }
    sample_1.slope_along_0 = _S334;
    var _S344 : f32 = families_0[_S324].height_scale_0;
    var _S345 : vec2<f32> = dive_0(_S325, _S323, _S328, _S327);
    if(_S328.straight_0)
    {
        _S332 = 0.0f;
    }
    else
    {
        _S332 = _S344 * _S332;
    }
    sample_1.height_5 = _S332 * (_S333 * _S328.bend_1.half_tangent_0 - _S339) - _S344 * _S329.drop_0 - _S345.x;
    var _S346 : f32 = _S344 * sample_1.slope_across_0;
    var _S347 : f32 = _S344 * sample_1.slope_along_0 - _S345.y;
    if(_S323.is_warp_0)
    {
        _S332 = _S346;
    }
    else
    {
        _S332 = _S347;
    }
    sample_1.slope_x_1 = _S332;
    if(_S323.is_warp_0)
    {
        _S332 = _S347;
    }
    else
    {
        _S332 = _S346;
    }
    sample_1.slope_y_1 = _S332;
    sample_1.run_3 = _S328;
    sample_1.section_1 = _S329;
    return sample_1;
}

fn steps_per_length_0( _S348 : u32,  _S349 : SearchQuality_0,  _S350 : vec3<f32>) -> f32
{
    return max(max(abs(_S350.x) * fabrics_0[_S348].threads_per_x_0, abs(_S350.y) * fabrics_0[_S348].threads_per_y_0) * _S349.steps_per_thread_0, abs(_S350.z) * fabrics_0[_S348].per_relief_0 * _S349.steps_per_relief_0);
}

fn cell_maximum_0( _S351 : u32,  _S352 : Crossing_0) -> f32
{
    var _S353 : u32;
    if(_S352.warp_above_0)
    {
        _S353 = fabrics_0[_S351].warp_0;
    }
    else
    {
        _S353 = fabrics_0[_S351].weft_0;
    }
    var _S354 : u32;
    if(_S352.warp_above_0)
    {
        _S354 = _S352.warp_word_0;
    }
    else
    {
        _S354 = _S352.weft_word_0;
    }
    return f32((_S354 >> (u32(28)))) * families_0[_S353].height_scale_0 * families_0[_S353].level_0;
}

fn probe_0( _S355 : u32,  _S356 : f32,  _S357 : f32,  _S358 : bool,  _S359 : bool,  _S360 : bool) -> Probe_0
{
    var _S361 : Sample_0 = sample_at_0(_S355, _S356, _S357, _S358);
    var probe_1 : Probe_0;
    probe_1.height_2 = _S361.height_5;
    probe_1.hole_1 = _S361.shown_3.hole_0;
    probe_1.slope_x_0 = _S361.slope_x_1;
    probe_1.slope_y_0 = _S361.slope_y_1;
    var _S362 : u32;
    if(_S361.shown_3.is_warp_0)
    {
        _S362 = _S361.crossing_1.warp_1.thread_2 * u32(2) + u32(1);
    }
    else
    {
        _S362 = _S361.crossing_1.weft_1.thread_2 * u32(2);
    }
    probe_1.yarn_1 = _S362;
    probe_1.cell_max_0 = cell_maximum_0(_S355, _S361.crossing_1);
    var _S363 : f32;
    if(_S359)
    {
        _S363 = _S361.crossing_1.warp_1.above_0;
    }
    else
    {
        _S363 = _S361.crossing_1.warp_1.below_0;
    }
    probe_1.side_x_0 = _S363;
    if(_S360)
    {
        _S363 = _S361.crossing_1.weft_1.above_0;
    }
    else
    {
        _S363 = _S361.crossing_1.weft_1.below_0;
    }
    probe_1.side_y_0 = _S363;
    probe_1.edge_x_0 = outline_distance_0(_S361.crossing_1.warp_1, _S361.shown_3, _S361.run_3, !_S361.shown_3.is_warp_0, _S359);
    probe_1.edge_y_0 = outline_distance_0(_S361.crossing_1.weft_1, _S361.shown_3, _S361.run_3, _S361.shown_3.is_warp_0, _S360);
    return probe_1;
}

fn is_free_0( _S364 : u32,  _S365 : SearchQuality_0,  _S366 : vec3<f32>,  _S367 : vec3<f32>,  _S368 : bool,  _S369 : f32) -> bool
{
    var _S370 : f32 = _S367.z;
    if(_S370 <= 0.0f)
    {
        return false;
    }
    var _S371 : f32 = 1.0f / max(_S365.shadow_share_0 * steps_per_length_0(_S364, _S365, _S367), 9.99999971718068537e-10f);
    var _S372 : StepControl_0 = step_control_0(_S367.xy, _S371);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_3 : u32 = u32(0);
    var distance_3 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        var _S373 : bool;
        if(count_3 < u32(1024))
        {
            _S373 = (_S366.z + _S370 * distance_3) < _S369;
        }
        else
        {
            _S373 = false;
        }
        if(_S373)
        {
        }
        else
        {
            break;
        }
        var _S374 : vec3<f32> = _S366 + _S367 * vec3<f32>(distance_3);
        var _S375 : Probe_0 = probe_0(_S364, _S374.x, _S374.y, _S368, _S372.right_0, _S372.up_0);
        var _S376 : f32 = _S374.z;
        var _S377 : f32 = _S376 - _S375.height_2;
        var _S378 : f32 = _S370 - _S375.slope_x_0 * _S367.x - _S375.slope_y_0 * _S367.y;
        var _S379 : bool;
        if(!_S375.hole_1)
        {
            _S379 = _S377 < 0.0f;
        }
        else
        {
            _S379 = false;
        }
        if(_S379)
        {
            return false;
        }
        var _S380 : f32 = way_back_to_dip_0(previous_3, _S377, _S378, last_step_0, _S375);
        if(_S380 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S380;
            distance_3 = distance_3 - _S380;
            last_step_0 = last_step_1;
            count_3 = count_3 + u32(1);
            continue;
        }
        var _S381 : bool = _S376 > (_S375.cell_max_0);
        var _S382 : PreviousSample_0 = after_sample_0(_S377, _S378, _S375, _S381);
        var last_step_2 : f32;
        if(_S381)
        {
            last_step_2 = max(StepControl_to_cell_exit_0(_S372, _S375.side_x_0, _S375.side_y_0), _S371);
        }
        else
        {
            last_step_2 = StepControl_to_next_sample_0(_S372, _S375, _S377, _S378);
        }
        var distance_4 : f32 = distance_3 + last_step_2;
        previous_3 = _S382;
        distance_3 = distance_4;
        last_step_0 = last_step_2;
        count_3 = count_3 + u32(1);
    }
    return true;
}

fn passes_through_0( _S383 : u32,  _S384 : SearchQuality_0,  _S385 : f32,  _S386 : f32,  _S387 : vec3<f32>,  _S388 : bool) -> bool
{
    if(!sample_at_0(_S383, _S385, _S386, _S388).shown_3.hole_0)
    {
        return false;
    }
    var _S389 : vec3<f32> = vec3<f32>(_S385, _S386, 0.0f);
    var passes_0 : bool = true;
    var side_0 : u32 = u32(0);
    for(;;)
    {
        var _S390 : bool;
        if(side_0 < u32(2))
        {
            _S390 = passes_0;
        }
        else
        {
            _S390 = false;
        }
        if(_S390)
        {
        }
        else
        {
            break;
        }
        var _S391 : vec3<f32>;
        if(side_0 == u32(0))
        {
            _S391 = _S387;
        }
        else
        {
            _S391 = vec3<f32>(- _S387.x, - _S387.y, _S387.z);
        }
        var _S392 : bool = is_free_0(_S383, _S384, _S389, _S391, _S388 != (side_0 == u32(1)), fabrics_0[_S383].height_high_0);
        var _S393 : u32 = side_0 + u32(1);
        passes_0 = _S392;
        side_0 = _S393;
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

fn max_height_along_0( _S394 : u32,  _S395 : f32,  _S396 : f32,  _S397 : f32,  _S398 : vec3<f32>,  _S399 : bool) -> f32
{
    var _S400 : u32 = locate_0(fabrics_0[_S394].warp_0, _S395).thread_2 / u32(2);
    var _S401 : u32 = locate_0(fabrics_0[_S394].weft_0, _S396).thread_2 / u32(2);
    var _S402 : f32 = _S398.x;
    var _S403 : u32;
    if(_S402 > 0.0f)
    {
        _S403 = u32(1);
    }
    else
    {
        _S403 = u32(0);
    }
    var _S404 : f32 = _S398.y;
    var _S405 : u32;
    if(_S404 > 0.0f)
    {
        _S405 = u32(2);
    }
    else
    {
        _S405 = u32(0);
    }
    var _S406 : u32 = words_0[fabrics_0[_S394].max_heights_0 + u32(4) * (_S401 * fabrics_0[_S394].max_height_columns_0 + _S400) + (_S403 + _S405)];
    var number_2 : i32;
    if(_S399)
    {
        number_2 = i32(4);
    }
    else
    {
        number_2 = i32(0);
    }
    var _S407 : u32 = (_S406 >> (u32(number_2)));
    var _S408 : f32 = max(abs(_S402) * fabrics_0[_S394].threads_per_x_0, abs(_S404) * fabrics_0[_S394].threads_per_y_0) / _S398.z;
    var _S409 : f32 = fabrics_0[_S394].height_high_0;
    var max_height_0 : f32 = fabrics_0[_S394].height_high_0;
    number_2 = i32(3);
    for(;;)
    {
        if(number_2 >= i32(0))
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S397) * _S408) <= (PYRAMID_RADII_0[number_2]))
        {
            max_height_0 = min(max_height_0, f32((((_S407 >> (u32(i32(8) * number_2)))) & (u32(15)))) * 0.06666667014360428f * _S409);
        }
        number_2 = number_2 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S410 : u32,  _S411 : f32,  _S412 : f32,  _S413 : bool,  _S414 : bool,  _S415 : bool) -> vec3<f32>
{
    var _S416 : Crossing_0 = crossing_at_0(_S410, _S411, _S412, _S413);
    var _S417 : f32 = cell_maximum_0(_S410, _S416);
    var _S418 : f32;
    if(_S414)
    {
        _S418 = _S416.warp_1.above_0;
    }
    else
    {
        _S418 = _S416.warp_1.below_0;
    }
    var _S419 : f32;
    if(_S415)
    {
        _S419 = _S416.weft_1.above_0;
    }
    else
    {
        _S419 = _S416.weft_1.below_0;
    }
    return vec3<f32>(_S417, _S418, _S419);
}

fn first_sample_height_0( _S420 : u32,  _S421 : ViewRay_0,  _S422 : StepControl_0,  _S423 : bool) -> f32
{
    var _S424 : f32 = max_height_along_0(_S420, _S421.origin_2.x, _S421.origin_2.y, 0.0f, vec3<f32>(_S421.slope_1, 1.0f), _S423);
    var count_4 : u32 = u32(0);
    var height_7 : f32 = _S424;
    for(;;)
    {
        if(count_4 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S425 : vec2<f32> = ViewRay_at_0(_S421, height_7);
        var _S426 : vec3<f32> = cell_bounds_0(_S420, _S425.x, _S425.y, _S423, _S422.right_0, _S422.up_0);
        var _S427 : f32 = height_7 - _S426.x;
        var _S428 : f32 = StepControl_to_cell_exit_0(_S422, _S426.y, _S426.z);
        var height_8 : f32 = height_7 - clamp(_S427, 0.0f, _S428);
        if(_S427 <= _S428)
        {
            height_7 = height_8;
            break;
        }
        count_4 = count_4 + u32(1);
        height_7 = height_8;
    }
    return height_7;
}

fn search_down_0( _S429 : u32,  _S430 : ViewRay_0,  _S431 : StepControl_0,  _S432 : bool) -> ViewRayEnd_0
{
    var _S433 : f32 = fabrics_0[_S429].height_low_0 - (fabrics_0[_S429].height_high_0 - fabrics_0[_S429].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_6 = first_sample_height_0(_S429, _S430, _S431, _S432);
    end_1.last_step_3 = _S431.epsilon_0;
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
        var _S434 : vec2<f32> = ViewRay_at_0(_S430, end_1.height_6);
        var _S435 : Probe_0 = probe_0(_S429, _S434.x, _S434.y, _S432, _S431.right_0, _S431.up_0);
        var _S436 : f32 = end_1.height_6 - _S435.height_2;
        var _S437 : f32 = ViewRay_rate_0(_S430, _S435);
        end_1.depth_0 = - _S436;
        end_1.rate_4 = _S437;
        var _S438 : bool;
        if(end_1.previous_4.known_0)
        {
            _S438 = !_S435.hole_1;
        }
        else
        {
            _S438 = false;
        }
        var _S439 : bool;
        if(_S438)
        {
            _S439 = (end_1.previous_4.yarn_0) == (_S435.yarn_1);
        }
        else
        {
            _S439 = false;
        }
        end_1.smooth_0 = _S439;
        var _S440 : bool;
        if(!_S435.hole_1)
        {
            _S440 = _S436 <= 0.0f;
        }
        else
        {
            _S440 = false;
        }
        var _S441 : bool;
        if(_S440)
        {
            _S441 = true;
        }
        else
        {
            _S441 = (end_1.height_6) <= _S433;
        }
        if(_S441)
        {
            break;
        }
        var _S442 : f32 = way_back_to_dip_0(end_1.previous_4, _S436, _S437, end_1.last_step_3, _S435);
        if(_S442 >= 0.0f)
        {
            end_1.height_6 = end_1.height_6 + _S442;
            end_1.last_step_3 = end_1.last_step_3 - _S442;
            count_5 = count_5 + u32(1);
            continue;
        }
        var _S443 : f32 = min(StepControl_to_cell_exit_0(_S431, _S435.side_x_0, _S435.side_y_0), end_1.height_6 - _S435.cell_max_0);
        var _S444 : f32 = StepControl_to_next_sample_0(_S431, _S435, _S436, _S437);
        end_1.previous_4 = after_sample_0(_S436, _S437, _S435, _S443 > _S444);
        var _S445 : f32 = max(_S443, _S444);
        end_1.last_step_3 = _S445;
        end_1.height_6 = end_1.height_6 - _S445;
        count_5 = count_5 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S446 : u32,  _S447 : ViewRay_0,  _S448 : StepControl_0,  _S449 : bool,  _S450 : ViewRayEnd_0,  _S451 : u32) -> f32
{
    var _S452 : f32 = fabrics_0[_S446].height_high_0 - fabrics_0[_S446].height_low_0;
    var above_2 : f32 = _S450.height_6 + _S450.last_step_3;
    var above_gap_1 : f32 = clamp(_S450.previous_4.clearance_0, 0.0f, _S452);
    var under_gap_1 : f32 = clamp(_S450.depth_0, 0.0f, _S452);
    var _S453 : f32 = cubic_root_0(above_gap_1, - under_gap_1, _S450.previous_4.rate_0 * _S450.last_step_3, _S450.rate_4 * _S450.last_step_3);
    var middle_0 : f32;
    if(_S450.smooth_0)
    {
        middle_0 = above_2 - _S453 * _S450.last_step_3;
    }
    else
    {
        middle_0 = between_0(above_2, _S450.height_6, above_gap_1, under_gap_1);
    }
    var side_1 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S450.height_6;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < _S451)
        {
        }
        else
        {
            break;
        }
        var _S454 : vec2<f32> = ViewRay_at_0(_S447, middle_0);
        var _S455 : Probe_0 = probe_0(_S446, _S454.x, _S454.y, _S449, _S448.right_0, _S448.up_0);
        var _S456 : f32;
        if(_S455.hole_1)
        {
            _S456 = -1.0e+09f;
        }
        else
        {
            _S456 = _S455.height_2;
        }
        var _S457 : f32 = clamp(middle_0 - _S456, - _S452, _S452);
        var _S458 : f32;
        if(_S457 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S458 = 0.5f * above_gap_2;
            }
            else
            {
                _S458 = above_gap_2;
            }
            var _S459 : f32 = - _S457;
            under_1 = middle_0;
            above_gap_2 = _S458;
            under_gap_2 = _S459;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S458 = 0.5f * under_gap_2;
            }
            else
            {
                _S458 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S457;
            under_gap_2 = _S458;
            side_1 = -1.0f;
        }
        if(_S450.smooth_0)
        {
            middle_0 = clamp(middle_0 + _S457 / min(ViewRay_rate_0(_S447, _S455), -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + u32(1);
    }
    if(_S450.smooth_0)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

fn first_hit_of_yarn_0( _S460 : u32,  _S461 : SearchQuality_0,  _S462 : f32,  _S463 : f32,  _S464 : vec3<f32>,  _S465 : bool) -> Hit_1
{
    var _S466 : f32 = max(_S464.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_2 = vec2<f32>(_S462, _S463);
    var _S467 : vec2<f32> = _S464.xy / vec2<f32>(_S466);
    ray_0.slope_1 = _S467;
    var _S468 : StepControl_0 = step_control_0((vec2<f32>(0) - _S467), 1.0f / max(steps_per_length_0(_S460, _S461, _S464) / _S466, 9.99999971718068537e-10f));
    var _S469 : ViewRayEnd_0 = search_down_0(_S460, ray_0, _S468, _S465);
    var hit_1 : Hit_1;
    hit_1.hole_2 = false;
    var _S470 : f32 = refined_height_0(_S460, ray_0, _S468, _S465, _S469, _S461.refinements_0);
    hit_1.height_4 = _S470;
    var _S471 : vec2<f32> = ViewRay_at_0(ray_0, _S470);
    hit_1.x_13 = _S471.x;
    hit_1.y_7 = _S471.y;
    return hit_1;
}

fn first_hit_0( _S472 : u32,  _S473 : SearchQuality_0,  _S474 : f32,  _S475 : f32,  _S476 : vec3<f32>,  _S477 : bool) -> Hit_1
{
    if(!passes_through_0(_S472, _S473, _S474, _S475, _S476, _S477))
    {
        return first_hit_of_yarn_0(_S472, _S473, _S474, _S475, _S476, _S477);
    }
    var hit_2 : Hit_1;
    hit_2.x_13 = _S474;
    hit_2.y_7 = _S475;
    hit_2.height_4 = 0.0f;
    hit_2.hole_2 = true;
    return hit_2;
}

struct CoverageTaps_0
{
     nodes_1 : array<u32, i32(9)>,
};

fn pyramid_level_0( _S478 : u32,  _S479 : f32) -> vec3<f32>
{
    var _S480 : u32 = fabrics_0[_S478].lobes_0.levels_0 + u32(4) * u32(min(_S479, fabrics_0[_S478].lobes_0.last_level_0));
    return vec3<f32>(table_number_0(_S480), table_number_0(_S480 + u32(1)), table_number_0(_S480 + u32(2)));
}

fn coverage_taps_0( _S481 : u32,  _S482 : Footprint_0,  _S483 : bool) -> CoverageTaps_0
{
    var _S484 : Lobes_std430_0 = fabrics_0[_S481].lobes_0;
    var _S485 : f32 = Footprint_spread_side_0(_S482) * fabrics_0[_S481].lobes_0.inverse_base_size_0;
    var _S486 : vec3<f32> = pyramid_level_0(_S481, floor(binary_logarithm_0(max(0.68000000715255737f * _S485, 1.0f))));
    var _S487 : f32 = 1.0f / max(_S485, 9.99999997475242708e-07f);
    var _S488 : vec2<f32> = vec2<f32>(families_0[fabrics_0[_S481].warp_0].inverse_period_0, families_0[fabrics_0[_S481].weft_0].inverse_period_0);
    var _S489 : vec2<f32> = _S482.centre_0 * _S488;
    var _S490 : vec2<f32> = vec2<f32>(min(max(sqrt(clamp(1.29999995231628418f * (1.0f - _S487 * _S487), 0.0f, 1.0f)), 0.3333333432674408f * _S487), 1.0f));
    var _S491 : vec2<f32> = _S482.dx_0 * _S488 * _S490;
    var _S492 : vec2<f32> = _S482.dy_0 * _S488 * _S490;
    var taps_3 : CoverageTaps_0;
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
        var _S493 : vec2<f32> = _S489 + vec2<f32>(TAP_OFFSETS_0[number_3].x) * _S491 + vec2<f32>(TAP_OFFSETS_0[number_3].y) * _S492;
        var _S494 : f32 = _S486.y;
        var _S495 : f32 = wrapped_cell_0(_S493.x, _S494);
        var _S496 : f32 = wrapped_cell_0(_S493.y, _S486.z);
        var _S497 : u32;
        if(_S483)
        {
            _S497 = _S484.face_nodes_0;
        }
        else
        {
            _S497 = u32(0);
        }
        taps_3.nodes_1[number_3] = _S497 + u32(_S496 * _S494 + _S495 + _S486.x);
        number_3 = number_3 + u32(1);
    }
    return taps_3;
}

fn coverage_of_holes_0( _S498 : u32,  _S499 : CoverageTaps_0) -> f32
{
    var number_4 : u32 = u32(0);
    var total_0 : u32 = u32(0);
    for(;;)
    {
        if(number_4 < u32(9))
        {
        }
        else
        {
            break;
        }
        var total_1 : u32 = total_0 + ((((words_0[fabrics_0[_S498].lobes_0.coverage_holes_0 + _S499.nodes_1[number_4] / u32(4)] >> ((u32(8) * (_S499.nodes_1[number_4] % u32(4)))))) & (u32(255))));
        number_4 = number_4 + u32(1);
        total_0 = total_1;
    }
    return f32(total_0) / 9.0f;
}

fn prefiltered_hole_0( _S500 : u32,  _S501 : CoverageTaps_0,  _S502 : NodeTaps_0,  _S503 : bool) -> f32
{
    var _S504 : Lobes_std430_0 = fabrics_0[_S500].lobes_0;
    var _S505 : f32 = interpolate_table_0(_S502, fabrics_0[_S500].lobes_0.projected_area_0 + fabrics_0[_S500].lobes_0.packs_0, fabrics_0[_S500].lobes_0.packs_0 + u32(1)).x;
    var _S506 : f32;
    if(_S503)
    {
        _S506 = _S504.back_hole_weight_0;
    }
    else
    {
        _S506 = _S504.front_hole_weight_0;
    }
    return min(coverage_of_holes_0(_S500, _S501) * _S505 * _S505 * _S506, 1.0f);
}

fn passed_share_0( _S507 : u32,  _S508 : VisiblePoint_0,  _S509 : vec3<f32>,  _S510 : f32,  _S511 : vec2<f32>) -> f32
{
    if((fabrics_0[_S507].has_yarns_0) == u32(0))
    {
        return fabrics_0[_S507].mean_hole_0;
    }
    var _S512 : vec3<f32> = to_local_0(_S508, _S509);
    var _S513 : bool = (_S512.z) < 0.0f;
    var _S514 : vec3<f32> = to_face_frame_0(_S512, _S513);
    var footprint_0 : Footprint_0;
    footprint_0.centre_0 = _S508.draft_0;
    footprint_0.dx_0 = vec2<f32>(_S510, 0.0f);
    footprint_0.dy_0 = vec2<f32>(0.0f, _S510);
    var _S515 : f32;
    if((fabrics_0[_S507].lobes_0.is_baked_0) != u32(0))
    {
        _S515 = regime_of_0(_S507, footprint_0, 1.0f).prefiltered_0;
    }
    else
    {
        _S515 = 0.0f;
    }
    var share_2 : f32;
    if(_S515 < 1.0f)
    {
        var _S516 : vec2<f32> = footprint_0.centre_0 + (_S511 - vec2<f32>(0.5f)) * vec2<f32>(_S510);
        if(first_hit_0(_S507, default_quality_0(), _S516.x, _S516.y, _S514, _S513).hole_2)
        {
            share_2 = 1.0f - _S515;
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
    if(_S515 > 0.0f)
    {
        var nodes_2 : NodeTaps_0 = node_taps_0(_S514);
        var _S517 : u32;
        if(_S513)
        {
            _S517 = u32(1);
        }
        else
        {
            _S517 = u32(0);
        }
        nodes_2.nodes_0 = nodes_2.nodes_0 + vec4<u32>((_S517 * u32(256)));
        share_2 = share_2 + _S515 * prefiltered_hole_0(_S507, coverage_taps_0(_S507, footprint_0, _S513), nodes_2, _S513);
    }
    var _S518 : f32 = fabrics_0[_S507].sheen_strength_0;
    if((fabrics_0[_S507].sheen_strength_0) > 0.0f)
    {
        share_2 = share_2 * (1.0f - _S518 * sheen_lobe_0(_S514.z, fabrics_0[_S507].sheen_roughness_0).z);
    }
    return share_2;
}

fn visibility_of_0( _S519 : i32,  _S520 : VisiblePoint_0,  _S521 : u32,  _S522 : vec2<u32>,  _S523 : u32) -> f32
{
    var _S524 : LightSample_0 = light_sample_0(_S519, _S523, _S522, _S520.position_0);
    var nearest_1 : f32;
    if((dot(_S524.towards_0, _S520.face_normal_0)) < 0.0f)
    {
        nearest_1 = -1.0f;
    }
    else
    {
        nearest_1 = 1.0f;
    }
    var _S525 : vec3<f32> = seen_position_0(_S519, _S521, _S522) + vec3<f32>((nearest_1 * frames_0[_S519].ray_offset_0)) * _S520.face_normal_0;
    var _S526 : vec2<f32> = _S520.draft_dx_0;
    var _S527 : vec2<f32> = _S520.draft_dy_0;
    var _S528 : f32 = sqrt(0.5f * (dot(_S526, _S526) + dot(_S527, _S527)));
    nearest_1 = 0.0f;
    var without_0 : u32 = _S521;
    var layer_0 : u32 = u32(0);
    var visibility_0 : f32 = 1.0f;
    for(;;)
    {
        var _S529 : bool;
        if(layer_0 < u32(8))
        {
            _S529 = visibility_0 > 0.00100000004749745f;
        }
        else
        {
            _S529 = false;
        }
        if(_S529)
        {
        }
        else
        {
            break;
        }
        var _S530 : Hit_0 = nearest_hit_0(_S519, _S525, _S524.towards_0, nearest_1, _S524.distance_2, without_0, true);
        if((_S530.face_1) == u32(4294967295))
        {
            break;
        }
        var _S531 : u32 = face_fabrics_0[_S530.face_1];
        var _S532 : VisiblePoint_0 = face_point_0(_S531, _S530.face_1, _S530.weight_b_0, _S530.weight_c_0);
        var _S533 : vec2<f32> = pixel_sequence_0(_S522, frames_0[_S519].pass_number_0, u32(5) + u32(2) * (u32(8) * _S523 + layer_0));
        var _S534 : f32;
        if((fabrics_0[_S531].is_open_0) != u32(0))
        {
            _S534 = passed_share_0(_S531, _S532, (vec3<f32>(0) - _S524.towards_0), _S528, _S533);
        }
        else
        {
            _S534 = 0.0f;
        }
        var visibility_1 : f32 = visibility_0 * _S534;
        var _S535 : u32 = layer_0 + u32(1);
        nearest_1 = _S530.distance_0;
        without_0 = _S530.face_1;
        layer_0 = _S535;
        visibility_0 = visibility_1;
    }
    if(visibility_0 > 0.00100000004749745f)
    {
        nearest_1 = visibility_0;
    }
    else
    {
        nearest_1 = 0.0f;
    }
    return nearest_1;
}

@compute
@workgroup_size(8, 8, 1)
fn cast_shadows(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S536 : u32 = id_0.x;
    var _S537 : u32 = frames_0[i32(0)].width_0;
    var _S538 : bool;
    if(_S536 >= (frames_0[i32(0)].width_0))
    {
        _S538 = true;
    }
    else
    {
        _S538 = (id_0.y) >= (frames_0[i32(0)].height_0);
    }
    if(_S538)
    {
        return;
    }
    var _S539 : u32 = id_0.y * _S537 + _S536;
    var _S540 : u32 = layers_0[_S539].face_0;
    if((layers_0[_S539].face_0) == u32(0))
    {
        return;
    }
    var _S541 : u32 = _S540 - u32(1);
    var _S542 : vec2<u32> = id_0.xy;
    var _S543 : VisiblePoint_0 = visible_point_0(i32(0), face_fabrics_0[_S541], _S541, _S542);
    var number_5 : u32 = u32(0);
    for(;;)
    {
        if(number_5 < (light_sample_count_0(i32(0))))
        {
        }
        else
        {
            break;
        }
        visibilities_0[number_5 * _S537 * frames_0[i32(0)].height_0 + _S539] = visibility_of_0(i32(0), _S543, _S541, _S542, number_5);
        number_5 = number_5 + u32(1);
    }
    return;
}

