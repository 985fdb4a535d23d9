@binding(1) @group(1) var<storage, read> query_count_0 : array<u32>;

struct Query_std430_0
{
    @align(4) fabric_0 : u32,
    @align(4) centre_x_0 : f32,
    @align(4) centre_y_0 : f32,
    @align(4) dx_x_0 : f32,
    @align(4) dx_y_0 : f32,
    @align(4) dy_x_0 : f32,
    @align(4) dy_y_0 : f32,
    @align(4) light_x_0 : f32,
    @align(4) light_y_0 : f32,
    @align(4) light_z_0 : f32,
    @align(4) view_x_0 : f32,
    @align(4) view_y_0 : f32,
    @align(4) view_z_0 : f32,
    @align(4) seed_0 : u32,
};

@binding(0) @group(1) var<storage, read> queries_0 : array<Query_std430_0>;

@binding(2) @group(1) var<storage, read_write> answers_0 : array<vec4<f32>>;

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
    @align(4) width_0 : f32,
    @align(4) height_0 : f32,
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
    @align(4) samples_0 : u32,
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
    @align(4) seed_1 : u32,
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

@binding(2) @group(0) var<storage, read> words_0 : array<u32>;

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

fn rsqrt_0( x_0 : f32) -> f32
{
    return 1.0f / sqrt(x_0);
}

var<private> PYRAMID_RADII_0 : array<f32, i32(4)> = array<f32, i32(4)>( 1.0f, 2.0f, 4.0f, 8.0f );
struct Footprint_0
{
     centre_0 : vec2<f32>,
     dx_0 : vec2<f32>,
     dy_0 : vec2<f32>,
};

fn footprint_of_0( centre_1 : vec2<f32>,  dx_1 : vec2<f32>,  dy_1 : vec2<f32>) -> Footprint_0
{
    var footprint_0 : Footprint_0;
    footprint_0.centre_0 = centre_1;
    footprint_0.dx_0 = dx_1;
    footprint_0.dy_0 = dy_1;
    return footprint_0;
}

fn mixed_0( number_0 : u32) -> u32
{
    var bits_0 : u32 = ((number_0 ^ (((number_0 >> (u32(16))))))) * u32(2246822507);
    var bits_1 : u32 = ((bits_0 ^ (((bits_0 >> (u32(13))))))) * u32(3266489909);
    return (bits_1 ^ (((bits_1 >> (u32(16))))));
}

fn with_number_0( hash_0 : u32,  number_1 : f32) -> u32
{
    var _S1 : u32;
    if(number_1 == 0.0f)
    {
        _S1 = u32(0);
    }
    else
    {
        _S1 = (bitcast<u32>((number_1)));
    }
    return mixed_0((hash_0 ^ (_S1)));
}

fn hashed_0( footprint_1 : Footprint_0,  view_1 : vec3<f32>,  size_1 : vec2<f32>) -> u32
{
    var hash_1 : u32 = u32(2654435769);
    var axis_0 : u32 = u32(0);
    for(;;)
    {
        if(axis_0 < u32(2))
        {
        }
        else
        {
            break;
        }
        var _S2 : f32 = footprint_1.centre_0[axis_0] / size_1[axis_0];
        var _S3 : u32 = mixed_0((hash_1 ^ (u32((_S2 - floor(_S2)) * 4096.0f))));
        var _S4 : u32 = axis_0 + u32(1);
        hash_1 = _S3;
        axis_0 = _S4;
    }
    axis_0 = u32(0);
    for(;;)
    {
        if(axis_0 < u32(3))
        {
        }
        else
        {
            break;
        }
        var _S5 : u32 = with_number_0(hash_1, view_1[axis_0]);
        var _S6 : u32 = axis_0 + u32(1);
        hash_1 = _S5;
        axis_0 = _S6;
    }
    return with_number_0(with_number_0(with_number_0(with_number_0(hash_1, footprint_1.dx_0.x), footprint_1.dx_0.y), footprint_1.dy_0.x), footprint_1.dy_0.y);
}

fn uniform_of_0( seed_2 : u32,  dimension_0 : u32) -> f32
{
    return f32(((mixed_0(seed_2 + (dimension_0 + u32(1)) * u32(2654435769))) >> (u32(8)))) * 5.9604644775390625e-08f;
}

fn to_face_frame_0( direction_0 : vec3<f32>,  back_2 : bool) -> vec3<f32>
{
    var _S7 : vec2<f32> = direction_0.xy;
    var _S8 : f32;
    if(back_2)
    {
        _S8 = - direction_0.z;
    }
    else
    {
        _S8 = direction_0.z;
    }
    return vec3<f32>(_S7, _S8);
}

fn arc_tangent_quotient_0( x_1 : f32,  y_0 : f32) -> f32
{
    return ((((((0.0f * x_1 + 0.00809729471802711f) * x_1 + -0.0377517081797123f) * x_1 + 0.08475969731807709f) * x_1 + -0.13537675142288208f) * x_1 + 0.19895026087760925f) * x_1 + -0.33327975869178772f) * x_1 + 0.99999970197677612f;
}

fn arc_tangent_of_ratio_0( ratio_0 : f32) -> f32
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0f);
}

struct BinTaps_0
{
     corner_0 : u32,
     bins_1 : u32,
     weights_0 : vec4<f32>,
};

fn bin_taps_0( direction_1 : vec3<f32>,  bins_2 : u32) -> BinTaps_0
{
    var _S9 : f32 = sqrt(max(1.0f - direction_1.z, 0.0f));
    var _S10 : f32 = direction_1.x;
    var _S11 : f32 = abs(_S10);
    var _S12 : f32 = direction_1.y;
    var _S13 : f32 = abs(_S12);
    var _S14 : f32 = arc_tangent_of_ratio_0(min(_S11, _S13) / max(max(_S11, _S13), 9.999999960041972e-13f)) * 1.27323949337005615f;
    var _S15 : bool = _S11 >= _S13;
    var _S16 : f32;
    if(_S10 < 0.0f)
    {
        _S16 = -1.0f;
    }
    else
    {
        _S16 = 1.0f;
    }
    var _S17 : f32;
    if(_S15)
    {
        _S17 = _S9;
    }
    else
    {
        _S17 = _S9 * _S14;
    }
    var _S18 : f32 = _S16 * _S17;
    if(_S12 < 0.0f)
    {
        _S16 = -1.0f;
    }
    else
    {
        _S16 = 1.0f;
    }
    if(_S15)
    {
        _S17 = _S9 * _S14;
    }
    else
    {
        _S17 = _S9;
    }
    var _S19 : f32 = f32(bins_2);
    var _S20 : vec2<f32> = clamp((vec2<f32>(_S18, _S16 * _S17) + vec2<f32>(1.0f)) * vec2<f32>((0.5f * _S19)) - vec2<f32>(0.5f), vec2<f32>(0.0f), vec2<f32>((_S19 - 1.0f)));
    var _S21 : f32 = _S20.x;
    var _S22 : u32 = bins_2 - u32(2);
    var _S23 : u32 = min(u32(_S21), _S22);
    var _S24 : f32 = _S20.y;
    var _S25 : u32 = min(u32(_S24), _S22);
    var _S26 : f32 = _S21 - f32(_S23);
    var _S27 : f32 = _S24 - f32(_S25);
    var taps_0 : BinTaps_0;
    taps_0.corner_0 = _S25 * bins_2 + _S23;
    taps_0.bins_1 = bins_2;
    var _S28 : f32 = 1.0f - _S26;
    var _S29 : f32 = 1.0f - _S27;
    taps_0.weights_0 = vec4<f32>(_S28 * _S29, _S26 * _S29, _S28 * _S27, _S26 * _S27);
    return taps_0;
}

fn table_number_0( index_0 : u32) -> f32
{
    return (bitcast<f32>((words_0[index_0])));
}

fn BinTaps_read_0( this_0 : BinTaps_0,  table_0 : u32,  first_0 : u32,  stride_0 : u32,  offset_2 : u32) -> f32
{
    var _S30 : u32 = table_0 + (first_0 + this_0.corner_0) * stride_0 + offset_2;
    return table_number_0(_S30) * this_0.weights_0.x + table_number_0(_S30 + stride_0) * this_0.weights_0.y + table_number_0(_S30 + this_0.bins_1 * stride_0) * this_0.weights_0.z + table_number_0(_S30 + (this_0.bins_1 + u32(1)) * stride_0) * this_0.weights_0.w;
}

struct TexelBox_0
{
     corner_1 : vec2<f32>,
     size_2 : vec2<f32>,
     first_1 : vec2<u32>,
     extent_0 : vec2<f32>,
     last_0 : vec2<u32>,
     turns_0 : vec2<f32>,
};

fn texel_box_0( tables_0 : ptr<function, Clustered_std430_0>,  footprint_2 : Footprint_0,  offset_3 : vec2<f32>,  place_0 : f32) -> TexelBox_0
{
    var _S31 : f32 = footprint_2.dx_0.x;
    var _S32 : f32 = footprint_2.dy_0.x;
    var _S33 : f32 = sqrt(_S31 * _S31 + _S32 * _S32);
    var _S34 : f32 = footprint_2.dx_0.y;
    var _S35 : f32 = footprint_2.dy_0.y;
    var _S36 : f32 = sqrt(_S34 * _S34 + _S35 * _S35);
    var _S37 : vec2<f32> = vec2<f32>(_S33, _S36);
    var _S38 : f32 = (_S31 * _S34 + _S32 * _S35) / max(_S33 * _S36, 1.00000000317107685e-30f);
    var _S39 : f32 = abs(_S38);
    var _S40 : f32 = place_0 * sqrt(min(_S39, 1.0f));
    var _S41 : f32;
    if(_S38 < 0.0f)
    {
        _S41 = - _S40;
    }
    else
    {
        _S41 = _S40;
    }
    var _S42 : vec2<f32> = _S37 * vec2<f32>(_S40, _S41);
    var _S43 : vec2<f32> = vec2<f32>((*tables_0).texel_width_0, (*tables_0).texel_height_0);
    var _S44 : u32 = (*tables_0).columns_0;
    var _S45 : u32 = (*tables_0).rows_0;
    var _S46 : vec2<f32> = vec2<f32>(f32((*tables_0).columns_0), f32((*tables_0).rows_0));
    var box_0 : TexelBox_0;
    var _S47 : vec2<f32> = _S37 * vec2<f32>(sqrt(max(1.0f - _S39, 0.0f)));
    box_0.size_2 = _S47;
    var _S48 : vec2<f32> = vec2<f32>(0.5f);
    var _S49 : vec2<f32> = _S48 * _S47;
    var _S50 : vec2<f32> = footprint_2.centre_0 + _S42 - _S49;
    box_0.corner_1 = _S50;
    var _S51 : vec2<f32> = max(round(_S47 / _S43), vec2<f32>(1.0f));
    box_0.extent_0 = _S51;
    var _S52 : vec2<f32> = round((_S50 + _S49 + offset_3) / _S43 - _S48 * _S51);
    var _S53 : vec2<f32> = vec2<f32>(0.0f);
    var _S54 : vec2<f32> = max(_S52 - floor(_S52 / _S46) * _S46, _S53);
    var _S55 : vec2<u32> = vec2<u32>(min(u32(_S54.x), (*tables_0).columns_0 - u32(1)), min(u32(_S54.y), (*tables_0).rows_0 - u32(1)));
    box_0.first_1 = _S55;
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

fn turns_and_remainder_0( family_0 : u32,  index_1 : f32) -> vec2<f32>
{
    var _S59 : f32 = floor(fma(index_1, families_0[family_0].inverse_count_0, families_0[family_0].half_inverse_count_0));
    return vec2<f32>(_S59, fma(- _S59, families_0[family_0].count_0, index_1));
}

struct Cell_0
{
     thread_0 : u32,
     across_0 : f32,
     half_width_1 : f32,
     below_0 : f32,
     above_0 : f32,
};

fn locate_alike_0( family_1 : u32,  position_0 : f32) -> Cell_0
{
    var _S60 : f32 = floor(position_0 * families_0[family_1].inverse_size_0);
    var cell_0 : Cell_0;
    var _S61 : f32 = fma(- _S60, families_0[family_1].size_0, position_0);
    cell_0.below_0 = _S61;
    cell_0.above_0 = families_0[family_1].size_0 - _S61;
    cell_0.across_0 = _S61 - 0.5f * families_0[family_1].size_0;
    cell_0.half_width_1 = families_0[family_1].half_width_0;
    cell_0.thread_0 = u32(clamp(turns_and_remainder_0(family_1, _S60).y, 0.0f, families_0[family_1].count_0 - 1.0f));
    return cell_0;
}

fn locate_varied_0( family_2 : u32,  position_1 : f32) -> Cell_0
{
    var turns_1 : f32 = (position_1 - families_0[family_2].start_0) * families_0[family_2].inverse_period_0;
    var turns_2 : f32 = turns_1 - floor(turns_1);
    var _S62 : f32 = turns_2 * families_0[family_2].period_0;
    var thread_1 : u32 = words_0[families_0[family_2].first_thread_table_0 + u32(clamp(turns_2 * families_0[family_2].bins_0, 0.0f, families_0[family_2].bins_0 - 1.0f))];
    var _S63 : u32;
    if(_S62 >= (table_number_0(families_0[family_2].place_table_0 + thread_1 * u32(4) + u32(1))))
    {
        _S63 = u32(1);
    }
    else
    {
        _S63 = u32(0);
    }
    var _S64 : u32 = min(thread_1 + _S63, u32(families_0[family_2].count_0) - u32(1));
    var _S65 : u32 = families_0[family_2].place_table_0 + _S64 * u32(4);
    var cell_1 : Cell_0;
    cell_1.thread_0 = _S64;
    cell_1.below_0 = _S62 - table_number_0(_S65);
    cell_1.above_0 = table_number_0(_S65 + u32(1)) - _S62;
    cell_1.across_0 = _S62 - table_number_0(_S65 + u32(2));
    cell_1.half_width_1 = table_number_0(_S65 + u32(3));
    return cell_1;
}

fn locate_0( family_3 : u32,  position_2 : f32) -> Cell_0
{
    if((families_0[family_3].is_alike_0) != u32(0))
    {
        return locate_alike_0(family_3, position_2);
    }
    return locate_varied_0(family_3, position_2);
}

struct Bound_0
{
     thread_2 : u32,
     turns_3 : f32,
     cell_2 : f32,
     visible_0 : f32,
     width_1 : f32,
     gap_0 : f32,
};

fn bound_at_0( family_4 : u32,  position_3 : f32) -> Bound_0
{
    var _S66 : Cell_0 = locate_0(family_4, position_3);
    var _S67 : f32 = table_number_0(families_0[family_4].before_0 + u32(2) * _S66.thread_0 + u32(1));
    var bound_0 : Bound_0;
    bound_0.thread_2 = _S66.thread_0;
    bound_0.turns_3 = round((position_3 - families_0[family_4].start_0 - _S67 - _S66.below_0) * families_0[family_4].inverse_period_0);
    bound_0.cell_2 = _S66.below_0;
    var _S68 : f32 = 2.0f * _S66.half_width_1;
    bound_0.width_1 = _S68;
    bound_0.visible_0 = clamp((_S66.across_0 + _S66.half_width_1) / _S68, 0.0f, 1.0f);
    bound_0.gap_0 = min(_S66.below_0, _S66.below_0 - _S66.across_0 - _S66.half_width_1) + max(_S66.across_0 - _S66.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
     low_0 : Bound_0,
     high_0 : Bound_0,
};

fn stretch_of_0( family_5 : u32,  centre_2 : f32,  size_3 : f32) -> Stretch_0
{
    var _S69 : f32 = centre_2 - floor((centre_2 - families_0[family_5].start_0) * families_0[family_5].inverse_period_0) * families_0[family_5].period_0;
    var _S70 : f32 = 0.5f * max(size_3, families_0[family_5].smallest_box_0);
    var stretch_0 : Stretch_0;
    stretch_0.low_0 = bound_at_0(family_5, _S69 - _S70);
    stretch_0.high_0 = bound_at_0(family_5, _S69 + _S70);
    return stretch_0;
}

fn table_colour_0( index_2 : u32) -> vec3<f32>
{
    return vec3<f32>(table_number_0(index_2), table_number_0(index_2 + u32(1)), table_number_0(index_2 + u32(2)));
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

fn Stretch_turns_0( this_1 : Stretch_0) -> f32
{
    return this_1.high_0.turns_3 - this_1.low_0.turns_3;
}

fn lengths_0( family_6 : u32,  stretch_1 : Stretch_0) -> vec3<f32>
{
    var _S71 : f32 = Stretch_turns_0(stretch_1);
    var _S72 : u32 = families_0[family_6].before_0 + u32(2) * stretch_1.low_0.thread_2;
    var _S73 : u32 = families_0[family_6].before_0 + u32(2) * stretch_1.high_0.thread_2;
    var _S74 : f32 = table_number_0(_S73) - table_number_0(_S72);
    var _S75 : f32 = table_number_0(_S73 + u32(1)) - table_number_0(_S72 + u32(1));
    return vec3<f32>(_S74 + stretch_1.high_0.visible_0 * stretch_1.high_0.width_1 - stretch_1.low_0.visible_0 * stretch_1.low_0.width_1 + _S71 * families_0[family_6].visible_total_0, _S75 - _S74 + stretch_1.high_0.gap_0 - stretch_1.low_0.gap_0 + _S71 * (families_0[family_6].period_0 - families_0[family_6].visible_total_0), _S75 + stretch_1.high_0.cell_2 - stretch_1.low_0.cell_2 + _S71 * families_0[family_6].period_0);
}

fn integrals_along_0( family_7 : u32,  stretch_2 : Stretch_0,  quantity_0 : u32) -> vec2<f32>
{
    var _S76 : u32 = u32(3) * families_0[family_7].quantities_0;
    var _S77 : u32 = families_0[family_7].colour_threads_0 + _S76 * stretch_2.low_0.thread_2 + quantity_0;
    var _S78 : u32 = families_0[family_7].colour_threads_0 + _S76 * stretch_2.high_0.thread_2 + quantity_0;
    var _S79 : u32 = families_0[family_7].colour_threads_0 + _S76 * u32(families_0[family_7].count_0) + quantity_0;
    var _S80 : f32 = table_number_0(_S77);
    var _S81 : f32 = table_number_0(_S78);
    var _S82 : f32 = Stretch_turns_0(stretch_2);
    var _S83 : u32 = u32(2) * families_0[family_7].quantities_0;
    return vec2<f32>(table_number_0(_S78 + families_0[family_7].quantities_0) - table_number_0(_S77 + families_0[family_7].quantities_0) + _S81 * stretch_2.high_0.visible_0 * stretch_2.high_0.width_1 - _S80 * stretch_2.low_0.visible_0 * stretch_2.low_0.width_1 + _S82 * table_number_0(_S79 + families_0[family_7].quantities_0), table_number_0(_S78 + _S83) - table_number_0(_S77 + _S83) + _S81 * stretch_2.high_0.cell_2 - _S80 * stretch_2.low_0.cell_2 + _S82 * table_number_0(_S79 + _S83));
}

fn Stretch_wraps_0( this_2 : Stretch_0) -> bool
{
    return (this_2.high_0.thread_2) < (this_2.low_0.thread_2);
}

fn Stretch_differences_0( this_3 : Stretch_0,  entries_0 : vec4<u32>,  whole_0 : u32) -> vec4<u32>
{
    var _S84 : u32 = entries_0.z;
    var _S85 : u32 = entries_0.x;
    var _S86 : u32 = _S84 - _S85;
    var _S87 : u32;
    if(Stretch_wraps_0(this_3))
    {
        _S87 = whole_0;
    }
    else
    {
        _S87 = u32(0);
    }
    return vec4<u32>(_S86 + _S87, entries_0.w - _S84, entries_0.y - _S85, whole_0);
}

fn row_differences_0( across_1 : Stretch_0,  row_1 : u32,  count_1 : u32,  quantities_1 : u32) -> vec4<u32>
{
    var _S88 : u32 = row_1 + across_1.low_0.thread_2 * quantities_1;
    var _S89 : u32 = row_1 + across_1.high_0.thread_2 * quantities_1;
    return Stretch_differences_0(across_1, vec4<u32>(words_0[_S88], words_0[_S88 + quantities_1], words_0[_S89], words_0[_S89 + quantities_1]), words_0[row_1 + count_1 * quantities_1]);
}

fn Stretch_weights_0( this_4 : Stretch_0) -> vec4<f32>
{
    var _S90 : f32 = - this_4.low_0.visible_0;
    var _S91 : f32 = Stretch_turns_0(this_4);
    var _S92 : f32;
    if(Stretch_wraps_0(this_4))
    {
        _S92 = 1.0f;
    }
    else
    {
        _S92 = 0.0f;
    }
    return vec4<f32>(1.0f, this_4.high_0.visible_0, _S90, _S91 - _S92);
}

fn integral_on_top_0( family_8 : u32,  across_2 : Stretch_0,  along_0 : Stretch_0,  crossing_count_0 : u32,  quantity_1 : u32) -> f32
{
    var _S93 : u32 = u32(families_0[family_8].count_0);
    var _S94 : u32 = (_S93 + u32(1)) * families_0[family_8].quantities_0;
    var _S95 : u32 = families_0[family_8].colour_areas_0 + quantity_1;
    var _S96 : vec4<u32> = row_differences_0(across_2, _S95 + along_0.low_0.thread_2 * _S94, _S93, families_0[family_8].quantities_0);
    var _S97 : vec4<u32> = row_differences_0(across_2, _S95 + (along_0.low_0.thread_2 + u32(1)) * _S94, _S93, families_0[family_8].quantities_0);
    var _S98 : vec4<u32> = row_differences_0(across_2, _S95 + along_0.high_0.thread_2 * _S94, _S93, families_0[family_8].quantities_0);
    var _S99 : vec4<u32> = row_differences_0(across_2, _S95 + (along_0.high_0.thread_2 + u32(1)) * _S94, _S93, families_0[family_8].quantities_0);
    var _S100 : vec4<u32> = row_differences_0(across_2, _S95 + crossing_count_0 * _S94, _S93, families_0[family_8].quantities_0);
    var _S101 : vec4<u32> = _S98 - _S96;
    var _S102 : vec4<u32>;
    if(Stretch_wraps_0(along_0))
    {
        _S102 = _S100;
    }
    else
    {
        _S102 = vec4<u32>(vec4<i32>(i32(0)));
    }
    var _S103 : vec4<f32> = Stretch_weights_0(across_2);
    return dot(vec4<f32>(dot(vec4<f32>(vec4<i32>(_S101 + _S102)), _S103), dot(vec4<f32>(vec4<i32>(_S99 - _S98)), _S103), dot(vec4<f32>(vec4<i32>(_S97 - _S96)), _S103), dot(vec4<f32>(vec4<i32>(_S100)), _S103)), Stretch_weights_0(along_0)) * families_0[family_8].area_unit_0;
}

fn with_added_albedos_0( albedos_1 : Albedos_0,  weight_0 : f32,  row_2 : u32) -> Albedos_0
{
    var _S104 : Albedos_0 = table_albedos_0(row_2);
    var sum_0 : Albedos_0;
    var _S105 : vec3<f32> = vec3<f32>(weight_0);
    sum_0.diffuse_reflect_0 = albedos_1.diffuse_reflect_0 + _S105 * _S104.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_1.diffuse_transmit_0 + _S105 * _S104.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_1.specular_reflect_0 + _S105 * _S104.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_1.specular_transmit_0 + _S105 * _S104.specular_transmit_0;
    return sum_0;
}

fn mean_albedos_0( family_9 : u32,  crossing_0 : u32,  own_0 : Stretch_0,  other_0 : Stretch_0,  back_3 : bool) -> Albedos_0
{
    var albedos_2 : Albedos_0 = table_albedos_0(families_0[family_9].colour_mean_0);
    if((families_0[family_9].quantities_0) == u32(1))
    {
        return albedos_2;
    }
    var _S106 : vec3<f32> = lengths_0(crossing_0, other_0);
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
        var _S107 : vec2<f32> = integrals_along_0(family_9, own_0, quantity_2);
        var _S108 : f32 = integral_on_top_0(family_9, own_0, other_0, u32(families_0[crossing_0].count_0), quantity_2);
        var _S109 : f32 = _S107.x;
        var _S110 : f32 = _S109 * _S106.x;
        var _S111 : f32;
        if(back_3)
        {
            _S111 = _S110 - _S108;
        }
        else
        {
            _S111 = _S108;
        }
        var _S112 : bool = quantity_2 == u32(0);
        if(_S112)
        {
            is_exposed_0 = _S111 > (16.0f * families_0[family_9].area_unit_0 * min(_S110 / families_0[family_9].crossing_area_0, 1.0f) + 0.00000999999974738f * _S110);
        }
        var _S113 : f32 = _S109 * _S106.y;
        var _S114 : f32;
        if(is_exposed_0)
        {
            _S114 = _S111;
        }
        else
        {
            _S114 = 0.0f;
        }
        var _S115 : f32 = _S113 + _S114 + 0.000244140625f * _S106.z * _S107.y;
        if(_S112)
        {
            weight_1 = 1.0f / max(_S115, 9.99999968265522539e-21f);
        }
        else
        {
            albedos_2 = with_added_albedos_0(albedos_2, _S115 * weight_1, families_0[family_9].colour_axes_0 + u32(12) * (quantity_2 - u32(1)));
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
    var _S116 : vec3<f32> = vec3<f32>((1.0f - open_of_other_0)) * passed_0;
    var found_0 : FaceRadiance_0;
    var _S117 : vec3<f32> = sends_0.sky_warp_0 + _S116 * sends_0.crossing_warp_0;
    found_0.warp_1 = _S117;
    var _S118 : vec3<f32> = sends_0.sky_weft_0 + _S116 * sends_0.crossing_weft_0;
    found_0.weft_1 = _S118;
    found_0.mean_0 = vec3<f32>(sends_0.blocks_warp_0) * _S117 + vec3<f32>(sends_0.blocks_weft_0) * _S118;
    found_0.leaked_0 = from_other_0;
    return found_0;
}

fn view_terms_0( view_2 : vec3<f32>,  terms_0 : ptr<function, array<f32, i32(6)>>)
{
    var _S119 : f32 = 1.0f - view_2.z;
    var _S120 : f32 = _S119 * _S119;
    (*terms_0)[i32(0)] = 1.0f;
    var _S121 : f32 = view_2.x;
    var _S122 : f32 = _S121 * _S121;
    var _S123 : f32 = view_2.y;
    var _S124 : f32 = _S123 * _S123;
    (*terms_0)[i32(1)] = sqrt(max(_S122 + _S124, 9.999999960041972e-13f));
    (*terms_0)[i32(2)] = _S120;
    (*terms_0)[i32(3)] = _S120 * _S120;
    (*terms_0)[i32(4)] = _S122 - _S124;
    (*terms_0)[i32(5)] = 0.0f;
    return;
}

fn view_terms_1( view_3 : vec3<f32>,  terms_1 : ptr<function, array<f32, i32(6)>>)
{
    var _S125 : f32 = 1.0f - view_3.z;
    var _S126 : f32 = _S125 * _S125;
    (*terms_1)[i32(0)] = 1.0f;
    var _S127 : f32 = view_3.x;
    var _S128 : f32 = _S127 * _S127;
    var _S129 : f32 = view_3.y;
    var _S130 : f32 = _S129 * _S129;
    (*terms_1)[i32(1)] = sqrt(max(_S128 + _S130, 9.999999960041972e-13f));
    (*terms_1)[i32(2)] = _S126;
    (*terms_1)[i32(3)] = _S126 * _S126;
    (*terms_1)[i32(4)] = _S128 - _S130;
    (*terms_1)[i32(5)] = 0.0f;
    return;
}

struct Blocked_0
{
     by_warp_0 : f32,
     by_weft_0 : f32,
     far_0 : f32,
};

fn scaled_0( blocked_0 : Blocked_0,  share_0 : f32) -> Blocked_0
{
    var result_1 : Blocked_0;
    result_1.by_warp_0 = share_0 * blocked_0.by_warp_0;
    result_1.by_weft_0 = share_0 * blocked_0.by_weft_0;
    result_1.far_0 = share_0 * blocked_0.far_0;
    return result_1;
}

struct Bounced_0
{
     reflected_0 : vec3<f32>,
     transmitted_0 : vec3<f32>,
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

fn bounced_by_0( blocked_1 : Blocked_0,  yarn_0 : Scattered_0,  interior_0 : Interior_0) -> Bounced_0
{
    var _S131 : vec3<f32> = vec3<f32>((blocked_1.by_warp_0 + blocked_1.by_weft_0)) * interior_0.leaked_1;
    var _S132 : vec3<f32> = vec3<f32>(blocked_1.far_0) * yarn_0.through_0;
    var bounced_0 : Bounced_0;
    bounced_0.reflected_0 = yarn_0.back_4 * (vec3<f32>(blocked_1.by_warp_0) * interior_0.warp_2 + vec3<f32>(blocked_1.by_weft_0) * interior_0.weft_2) + _S132 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S132 * interior_0.far_1 + yarn_0.back_4 * _S131;
    return bounced_0;
}

fn sum_of_0( first_2 : Bounced_0,  second_0 : Bounced_0) -> Bounced_0
{
    var sum_1 : Bounced_0;
    sum_1.reflected_0 = first_2.reflected_0 + second_0.reflected_0;
    sum_1.transmitted_0 = first_2.transmitted_0 + second_0.transmitted_0;
    return sum_1;
}

fn summed_0( tables_1 : ptr<function, Clustered_std430_0>,  first_3 : u32,  column_0 : u32,  row_3 : u32) -> i32
{
    return i32(words_0[first_3 + (row_3 * ((*tables_1).columns_0 + u32(1)) + column_0) * (*tables_1).channels_0]);
}

fn box_mean_0( tables_2 : ptr<function, Clustered_std430_0>,  box_1 : TexelBox_0,  face_0 : u32,  channel_0 : u32) -> f32
{
    var _S133 : u32 = (*tables_2).columns_0;
    var _S134 : u32 = (*tables_2).rows_0;
    var _S135 : u32 = (*tables_2).sums_0 + face_0 * ((*tables_2).columns_0 + u32(1)) * ((*tables_2).rows_0 + u32(1)) * (*tables_2).channels_0 + channel_0;
    var _S136 : u32 = box_1.last_0.x;
    var _S137 : u32 = box_1.first_1.y;
    var _S138 : i32 = summed_0(&((*tables_2)), _S135, _S136, _S137);
    var _S139 : u32 = box_1.first_1.x;
    var _S140 : i32 = summed_0(&((*tables_2)), _S135, _S139, _S137);
    var _S141 : i32 = _S138 - _S140;
    var _S142 : u32 = box_1.last_0.y;
    var _S143 : i32 = summed_0(&((*tables_2)), _S135, _S136, _S142);
    var _S144 : i32 = summed_0(&((*tables_2)), _S135, _S139, _S142);
    var total_0 : f32 = f32(_S143 - _S144 - _S141);
    var _S145 : f32 = box_1.turns_0.x;
    var _S146 : bool = _S145 > 0.0f;
    var total_1 : f32;
    if(_S146)
    {
        var _S147 : i32 = summed_0(&((*tables_2)), _S135, _S133, _S142);
        var _S148 : i32 = summed_0(&((*tables_2)), _S135, _S133, _S137);
        total_1 = total_0 + _S145 * f32(_S147 - _S148);
    }
    else
    {
        total_1 = total_0;
    }
    var _S149 : f32 = box_1.turns_0.y;
    var _S150 : bool = _S149 > 0.0f;
    if(_S150)
    {
        var _S151 : i32 = summed_0(&((*tables_2)), _S135, _S136, _S134);
        var _S152 : i32 = summed_0(&((*tables_2)), _S135, _S139, _S134);
        total_1 = total_1 + _S149 * f32(_S151 - _S152);
    }
    var _S153 : bool;
    if(_S146)
    {
        _S153 = _S150;
    }
    else
    {
        _S153 = false;
    }
    if(_S153)
    {
        var _S154 : f32 = _S145 * _S149;
        var _S155 : i32 = summed_0(&((*tables_2)), _S135, _S133, _S134);
        total_1 = total_1 + _S154 * f32(_S155);
    }
    return total_1 / (box_1.extent_0.x * box_1.extent_0.y);
}

fn square_0( v_0 : vec3<f32>) -> f32
{
    return dot(v_0, v_0);
}

struct BaseTaps_0
{
     facing_0 : vec3<f32>,
     transmits_1 : bool,
     around_0 : BinTaps_0,
     first_4 : u32,
     half_vector_0 : BinTaps_0,
};

struct ViewedBase_0
{
     view_4 : vec3<f32>,
     back_5 : bool,
     face_1 : u32,
     around_1 : BinTaps_0,
     box_2 : TexelBox_0,
     trust_1 : vec2<f32>,
};

fn base_taps_0( seen_0 : ViewedBase_0,  light_1 : vec3<f32>) -> BaseTaps_0
{
    var taps_1 : BaseTaps_0;
    var _S156 : vec3<f32> = to_face_frame_0(light_1, seen_0.back_5);
    taps_1.facing_0 = _S156;
    var _S157 : f32 = _S156.z;
    var _S158 : bool = _S157 < 0.0f;
    taps_1.transmits_1 = _S158;
    taps_1.around_0 = bin_taps_0(vec3<f32>(_S156.xy, abs(_S157)), u32(32));
    var _S159 : u32 = seen_0.face_1 * u32(2);
    var _S160 : u32;
    if(_S158)
    {
        _S160 = u32(1);
    }
    else
    {
        _S160 = u32(0);
    }
    taps_1.first_4 = (_S159 + _S160) * u32(1024);
    var _S161 : vec3<f32> = taps_1.facing_0 + seen_0.view_4;
    var half_vector_1 : vec3<f32> = _S161 * vec3<f32>((1.0f / sqrt(max(square_0(_S161), 9.999999960041972e-13f))));
    var half_vector_2 : vec3<f32>;
    if((half_vector_1.z) < 0.0f)
    {
        half_vector_2 = (vec3<f32>(0) - half_vector_1);
    }
    else
    {
        half_vector_2 = half_vector_1;
    }
    taps_1.half_vector_0 = bin_taps_0(half_vector_2, u32(32));
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

fn projected_area_1( direction_2 : vec3<f32>,  tangent_0 : vec3<f32>,  roughness_1 : f32) -> f32
{
    var _S162 : f32 = dot(direction_2, tangent_0);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S162 * _S162 + 1.0f, roughness_1 * roughness_1));
}

fn exponential_0( x_2 : f32) -> f32
{
    var _S163 : f32 = clamp(x_2, -87.0f, 88.0f);
    var _S164 : f32 = floor(_S163 * 1.4426950216293335f + 0.5f);
    var _S165 : f32 = _S163 - _S164 * 0.693359375f + _S164 * 0.00021219444170129f;
    var p_0 : f32 = ((((0.00019875691214111f * _S165 + 0.00139819993637502f) * _S165 + 0.00833345204591751f) * _S165 + 0.04166579619050026f) * _S165 + 0.1666666567325592f) * _S165 + 0.5f;
    var _S166 : f32 = (bitcast<f32>(((u32(i32(_S164) + i32(127)) << (u32(23))))));
    var _S167 : f32;
    if(x_2 < -87.0f)
    {
        _S167 = 0.0f;
    }
    else
    {
        _S167 = (p_0 * _S165 * _S165 + _S165 + 1.0f) * _S166;
    }
    return _S167;
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

fn bounced_value_0( bounced_1 : Bounced_0,  light_2 : vec3<f32>,  view_5 : vec3<f32>) -> vec3<f32>
{
    var _S168 : f32 = light_2.z;
    var _S169 : vec3<f32>;
    if((_S168 * view_5.z) < 0.0f)
    {
        _S169 = bounced_1.transmitted_0;
    }
    else
    {
        _S169 = bounced_1.reflected_0;
    }
    return _S169 * vec3<f32>((abs(_S168) * 0.31830987334251404f));
}

fn sheen_scale_0( x_3 : f32,  y_1 : f32) -> f32
{
    return (((((0.0f * x_3 + (((((-1.1402510404586792f * y_1 + 0.40672621130943298f) * y_1 + 1.65398800373077393f) * y_1 + -1.29730904102325439f) * y_1 + 0.30570998787879944f) * y_1 + -0.0220868494361639f)) * x_3 + (((((-0.21142719686031342f * y_1 + 1.05947399139404297f) * y_1 + -0.41116121411323547f) * y_1 + -0.93859231472015381f) * y_1 + 0.51606941223144531f) * y_1 + 0.05409301072359085f)) * x_3 + (((((1.22944498062133789f * y_1 + -0.45962560176849365f) * y_1 + -1.63861405849456787f) * y_1 + 1.33565104007720947f) * y_1 + -0.45725581049919128f) * y_1 + 0.08243165910243988f)) * x_3 + (((((0.39779931306838989f * y_1 + -1.18879103660583496f) * y_1 + 0.28251591324806213f) * y_1 + 1.168984055519104f) * y_1 + -0.76864629983901978f) * y_1 + 0.0091691892594099f)) * x_3 + (((((-0.26563560962677002f * y_1 + -0.19379159808158875f) * y_1 + 0.2677634060382843f) * y_1 + 0.00270519289188087f) * y_1 + 0.14349560439586639f) * y_1 + 0.10290180146694183f)) * x_3 + (((((-0.20701569318771362f * y_1 + 0.24526430666446686f) * y_1 + 0.19551840424537659f) * y_1 + 0.07586126774549484f) * y_1 + 0.38894739747047424f) * y_1 + 0.15043120086193085f);
}

fn sheen_shear_0( x_4 : f32,  y_2 : f32) -> f32
{
    return ((((0.0f * x_4 + (((((-0.10608240216970444f * y_2 + 1.99214303493499756f) * y_2 + -1.42255294322967529f) * y_2 + -1.09495604038238525f) * y_2 + 0.59180057048797607f) * y_2 + 0.06902855634689331f)) * x_4 + (((((-0.46220690011978149f * y_2 + -0.29113379120826721f) * y_2 + 1.39025199413299561f) * y_2 + 0.35589990019798279f) * y_2 + -1.17120099067687988f) * y_2 + 0.15940259397029877f)) * x_4 + (((((2.26068711280822754f * y_2 + -3.64728999137878418f) * y_2 + -0.72173482179641724f) * y_2 + 3.07659196853637695f) * y_2 + -0.6827620267868042f) * y_2 + -0.3039557933807373f)) * x_4 + (((((0.81201767921447754f * y_2 + 0.36014080047607422f) * y_2 + -1.72646903991699219f) * y_2 + -0.22630110383033752f) * y_2 + 0.89514690637588501f) * y_2 + -0.10397960245609283f)) * x_4 + (((((-0.37648698687553406f * y_2 + 1.10974001884460449f) * y_2 + 0.17824520170688629f) * y_2 + -1.04968702793121338f) * y_2 + 0.1461234986782074f) * y_2 + -0.00475129019469023f);
}

fn sheen_reflectance_0( x_5 : f32,  y_3 : f32) -> f32
{
    return ((((0.0f * x_5 + (((((12.95646953582763672f * y_3 + -21.38032913208007812f) * y_3 + -7.37853097915649414f) * y_3 + 34.55607986450195312f) * y_3 + -23.61347007751464844f) * y_3 + 5.00126314163208008f)) * x_5 + (((((10.91487026214599609f * y_3 + -6.08202791213989258f) * y_3 + -38.2036285400390625f) * y_3 + 53.3440399169921875f) * y_3 + -21.91996002197265625f) * y_3 + 2.01606011390686035f)) * x_5 + (((((-14.52206039428710938f * y_3 + 36.803619384765625f) * y_3 + -22.94047927856445312f) * y_3 + -10.07973003387451172f) * y_3 + 15.77003955841064453f) * y_3 + -4.92722177505493164f)) * x_5 + (((((-7.62505722045898438f * y_3 + 1.27310299873352051f) * y_3 + 31.19523048400878906f) * y_3 + -44.39989852905273438f) * y_3 + 26.44947052001953125f) * y_3 + -8.73507976531982422f)) * x_5 + (((((5.65633487701416016f * y_3 + -17.66820907592773438f) * y_3 + 24.65356063842773438f) * y_3 + -19.38941001892089844f) * y_3 + 11.06159019470214844f) * y_3 + -3.06573700904846191f);
}

fn sheen_lobe_0( cos_view_0 : f32,  roughness_2 : f32) -> vec3<f32>
{
    var _S170 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S171 : f32 = 2.0f * sqrt(_S170) - 1.0f;
    var _S172 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_2, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S171, _S172), 0.00999999977648258f, 1.0f), clamp((1.0f - _S170) * sheen_shear_0(_S171, _S172), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S171, _S172), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_3 : vec3<f32>,  view_6 : vec3<f32>,  scale_0 : f32,  shear_0 : f32) -> f32
{
    var _S173 : f32 = light_3.z;
    var _S174 : bool;
    if(_S173 <= 0.0f)
    {
        _S174 = true;
    }
    else
    {
        _S174 = (view_6.z) <= 0.0f;
    }
    if(_S174)
    {
        return 0.0f;
    }
    var _S175 : vec2<f32> = view_6.xy;
    var _S176 : f32 = dot(_S175, _S175);
    var _S177 : vec2<f32>;
    if(_S176 > 9.99999968265522539e-21f)
    {
        _S177 = _S175 * vec2<f32>(rsqrt_0(_S176));
    }
    else
    {
        _S177 = vec2<f32>(1.0f, 0.0f);
    }
    var _S178 : f32 = scale_0 * dot(light_3.xy, _S177) + shear_0 * _S173;
    var _S179 : f32 = scale_0 * (light_3.y * _S177.x - light_3.x * _S177.y);
    var _S180 : f32 = _S178 * _S178 + _S179 * _S179 + _S173 * _S173;
    return 0.31830987334251404f * scale_0 * scale_0 * _S173 / max(_S180 * _S180, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_4 : vec3<f32>,  view_7 : vec3<f32>,  strength_0 : f32,  roughness_3 : f32) -> vec2<f32>
{
    var _S181 : vec3<f32> = sheen_lobe_0(view_7.z, roughness_3);
    var _S182 : f32 = strength_0 * _S181.z;
    return vec2<f32>(_S182 * transformed_cosine_0(light_4, view_7, _S181.x, _S181.y), 1.0f - _S182);
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

struct Shown_0
{
     is_warp_0 : bool,
     hole_1 : bool,
     on_top_0 : bool,
     word_0 : u32,
};

struct Crossing_0
{
     warp_4 : Cell_0,
     weft_4 : Cell_0,
     warp_word_0 : u32,
     weft_word_0 : u32,
     warp_above_0 : bool,
};

fn shown_at_0( crossing_1 : Crossing_0,  back_6 : bool) -> Shown_0
{
    var _S183 : bool = (abs(crossing_1.warp_4.across_0)) < (crossing_1.warp_4.half_width_1);
    var _S184 : bool = (abs(crossing_1.weft_4.across_0)) < (crossing_1.weft_4.half_width_1);
    var shown_0 : Shown_0;
    var _S185 : bool;
    if(_S183)
    {
        if(!_S184)
        {
            _S185 = true;
        }
        else
        {
            _S185 = crossing_1.warp_above_0;
        }
    }
    else
    {
        _S185 = false;
    }
    shown_0.is_warp_0 = _S185;
    if(!_S183)
    {
        _S185 = !_S184;
    }
    else
    {
        _S185 = false;
    }
    shown_0.hole_1 = _S185;
    var _S186 : u32;
    if(shown_0.is_warp_0)
    {
        _S186 = crossing_1.warp_word_0;
    }
    else
    {
        _S186 = crossing_1.weft_word_0;
    }
    shown_0.word_0 = _S186;
    shown_0.on_top_0 = (((_S186 & (u32(1)))) == u32(1)) != back_6;
    return shown_0;
}

fn select_cell_0( is_first_0 : bool,  first_5 : Cell_0,  second_1 : Cell_0) -> Cell_0
{
    var cell_3 : Cell_0;
    var _S187 : u32;
    if(is_first_0)
    {
        _S187 = first_5.thread_0;
    }
    else
    {
        _S187 = second_1.thread_0;
    }
    cell_3.thread_0 = _S187;
    var _S188 : f32;
    if(is_first_0)
    {
        _S188 = first_5.across_0;
    }
    else
    {
        _S188 = second_1.across_0;
    }
    cell_3.across_0 = _S188;
    if(is_first_0)
    {
        _S188 = first_5.half_width_1;
    }
    else
    {
        _S188 = second_1.half_width_1;
    }
    cell_3.half_width_1 = _S188;
    if(is_first_0)
    {
        _S188 = first_5.below_0;
    }
    else
    {
        _S188 = second_1.below_0;
    }
    cell_3.below_0 = _S188;
    if(is_first_0)
    {
        _S188 = first_5.above_0;
    }
    else
    {
        _S188 = second_1.above_0;
    }
    cell_3.above_0 = _S188;
    return cell_3;
}

fn boundary_0( family_10 : u32,  thread_3 : u32,  step_0 : i32) -> f32
{
    var _S189 : vec2<f32> = turns_and_remainder_0(family_10, f32(i32(thread_3) + step_0));
    return fma(_S189.x, families_0[family_10].period_0, table_number_0(families_0[family_10].place_table_0 + u32(_S189.y) * u32(4)));
}

fn span_0( family_11 : u32,  thread_4 : u32,  first_6 : i32,  last_1 : i32) -> f32
{
    if((families_0[family_11].is_alike_0) != u32(0))
    {
        return f32(last_1 - first_6) * families_0[family_11].size_0;
    }
    return boundary_0(family_11, thread_4, last_1) - boundary_0(family_11, thread_4, first_6);
}

struct Bend_0
{
     sine_0 : f32,
     half_tangent_0 : f32,
     arc_0 : f32,
};

fn bend_of_0( family_12 : u32,  thread_5 : u32) -> Bend_0
{
    var _S190 : u32 = families_0[family_12].bend_table_0;
    var _S191 : u32;
    if((families_0[family_12].is_alike_0) != u32(0))
    {
        _S191 = u32(0);
    }
    else
    {
        _S191 = thread_5 * u32(4);
    }
    var _S192 : u32 = _S190 + _S191;
    var bend_0 : Bend_0;
    bend_0.sine_0 = table_number_0(_S192);
    bend_0.half_tangent_0 = table_number_0(_S192 + u32(1));
    bend_0.arc_0 = table_number_0(_S192 + u32(2));
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

fn unpack_0( own_1 : u32,  other_1 : u32,  thread_6 : u32,  crossed_0 : Cell_0,  word_1 : u32) -> Run_0
{
    var _S193 : i32 = i32((((word_1 >> (u32(1)))) & (u32(127))));
    var _S194 : i32 = i32((((word_1 >> (u32(8)))) & (u32(127))));
    var _S195 : i32 = i32((((word_1 >> (u32(15)))) & (u32(63))));
    var _S196 : i32 = i32((((word_1 >> (u32(21)))) & (u32(63))));
    var run_0 : Run_0;
    run_0.straight_0 = ((((word_1 >> (u32(27)))) & (u32(1)))) == u32(1);
    var _S197 : i32 = - _S193;
    var _S198 : f32 = crossed_0.below_0 + span_0(other_1, crossed_0.thread_0, _S197, i32(0));
    run_0.from_start_0 = _S198;
    var _S199 : i32 = _S194 + i32(1);
    var _S200 : f32 = crossed_0.above_0 + span_0(other_1, crossed_0.thread_0, i32(1), _S199);
    run_0.to_end_0 = _S200;
    var _S201 : bool = _S198 < _S200;
    run_0.near_start_0 = _S201;
    var _S202 : i32;
    if(_S201)
    {
        _S202 = _S197 - _S195;
    }
    else
    {
        _S202 = _S199;
    }
    var _S203 : i32;
    if(run_0.near_start_0)
    {
        _S203 = _S197;
    }
    else
    {
        _S203 = _S199 + _S196;
    }
    run_0.bend_1 = bend_of_0(own_1, thread_6);
    var _S204 : f32;
    if(run_0.straight_0)
    {
        _S204 = 1.0e+06f;
    }
    else
    {
        _S204 = min(run_0.from_start_0, run_0.to_end_0);
    }
    run_0.distance_0 = _S204;
    run_0.reach_0 = min(0.5f * (run_0.from_start_0 + run_0.to_end_0), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_1, crossed_0.thread_0, _S202, _S203), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S193 == i32(0);
    run_0.last_crossing_0 = _S194 == i32(0);
    return run_0;
}

fn square_1( x_6 : f32) -> f32
{
    return x_6 * x_6;
}

struct Section_0
{
     across_3 : f32,
     drop_0 : f32,
     slope_0 : f32,
};

fn section_at_0( cell_4 : Cell_0) -> Section_0
{
    var _S205 : f32 = cell_4.half_width_1 * 1.0154266357421875f;
    var section_0 : Section_0;
    var _S206 : f32 = clamp(cell_4.across_0, - cell_4.half_width_1, cell_4.half_width_1);
    section_0.across_3 = _S206;
    var _S207 : f32 = _S205 * _S205 - square_1(_S206);
    var _S208 : f32 = rsqrt_0(_S207);
    section_0.drop_0 = _S205 - _S207 * _S208;
    section_0.slope_0 = - _S206 * _S208;
    return section_0;
}

fn edge_drop_0( family_13 : u32,  thread_7 : u32,  step_1 : i32) -> f32
{
    if((families_0[family_13].is_alike_0) != u32(0))
    {
        return table_number_0(families_0[family_13].bend_table_0 + u32(3));
    }
    return table_number_0(families_0[family_13].bend_table_0 + u32(turns_and_remainder_0(family_13, f32(i32(thread_7) + step_1)).y) * u32(4) + u32(3));
}

fn dive_0( other_2 : u32,  shown_1 : Shown_0,  run_1 : Run_0,  crossed_1 : Cell_0) -> vec2<f32>
{
    var _S209 : bool = (crossed_1.below_0) < (crossed_1.above_0);
    var _S210 : f32 = min(crossed_1.below_0, crossed_1.above_0);
    var _S211 : f32;
    if(_S209)
    {
        _S211 = crossed_1.below_0 - crossed_1.across_0;
    }
    else
    {
        _S211 = crossed_1.above_0 + crossed_1.across_0;
    }
    var _S212 : f32 = _S211 - crossed_1.half_width_1;
    var _S213 : bool;
    if(_S209)
    {
        _S213 = run_1.first_crossing_0;
    }
    else
    {
        _S213 = run_1.last_crossing_0;
    }
    if(shown_1.on_top_0)
    {
        _S211 = 0.0f;
    }
    else
    {
        _S211 = families_0[other_2].height_scale_0 * edge_drop_0(other_2, crossed_1.thread_0, i32(0));
    }
    var _S214 : f32;
    if((shown_1.on_top_0) != _S213)
    {
        _S214 = 0.0f;
    }
    else
    {
        var _S215 : f32 = families_0[other_2].height_scale_0;
        var _S216 : i32;
        if(_S209)
        {
            _S216 = i32(-1);
        }
        else
        {
            _S216 = i32(1);
        }
        _S214 = _S215 * edge_drop_0(other_2, crossed_1.thread_0, _S216);
    }
    var _S217 : f32 = 1.0f / max(2.0f * _S212, 9.999999960041972e-13f);
    var _S218 : f32 = clamp((_S212 - _S210) * _S217, 0.0f, 1.0f);
    var _S219 : f32 = _S211 + (_S214 - _S211) * (_S218 * _S218 * (3.0f - 2.0f * _S218));
    var _S220 : f32 = (_S211 - _S214) * (6.0f * _S218 * (1.0f - _S218) * _S217);
    if(_S209)
    {
        _S211 = 1.0f;
    }
    else
    {
        _S211 = -1.0f;
    }
    return vec2<f32>(_S219, _S220 * _S211);
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
    var _S221 : f32 = direction_3.x;
    control_0.per_x_0 = 1.0f / max(abs(_S221), 9.99999971718068537e-10f);
    var _S222 : f32 = direction_3.y;
    control_0.per_y_0 = 1.0f / max(abs(_S222), 9.99999971718068537e-10f);
    control_0.right_0 = _S221 > 0.0f;
    control_0.up_0 = _S222 > 0.0f;
    return control_0;
}

struct PreviousSample_0
{
     clearance_0 : f32,
     rate_0 : f32,
     yarn_1 : u32,
     known_0 : bool,
};

fn no_previous_sample_0() -> PreviousSample_0
{
    var previous_0 : PreviousSample_0;
    previous_0.clearance_0 = 0.0f;
    previous_0.rate_0 = 0.0f;
    previous_0.yarn_1 = u32(0);
    previous_0.known_0 = false;
    return previous_0;
}

fn outline_distance_0( cell_5 : Cell_0,  shown_2 : Shown_0,  run_2 : Run_0,  lengthwise_0 : bool,  forwards_0 : bool) -> f32
{
    var _S223 : f32;
    if(forwards_0)
    {
        _S223 = cell_5.across_0;
    }
    else
    {
        _S223 = - cell_5.across_0;
    }
    var _S224 : f32;
    if(forwards_0)
    {
        _S224 = cell_5.above_0;
    }
    else
    {
        _S224 = cell_5.below_0;
    }
    var _S225 : bool;
    if(forwards_0)
    {
        _S225 = run_2.last_crossing_0;
    }
    else
    {
        _S225 = run_2.first_crossing_0;
    }
    var _S226 : bool;
    if(forwards_0)
    {
        _S226 = run_2.first_crossing_0;
    }
    else
    {
        _S226 = run_2.last_crossing_0;
    }
    var _S227 : f32 = - cell_5.half_width_1;
    var _S228 : bool = _S223 < _S227;
    var _S229 : bool = _S223 >= (cell_5.half_width_1);
    if(lengthwise_0)
    {
        _S225 = !_S225;
    }
    else
    {
        _S225 = false;
    }
    if(_S225)
    {
        _S225 = !shown_2.hole_1;
    }
    else
    {
        _S225 = false;
    }
    var _S230 : bool;
    if(_S225)
    {
        _S230 = shown_2.on_top_0;
    }
    else
    {
        _S230 = false;
    }
    if(_S230)
    {
        if(_S226)
        {
            _S226 = _S228;
        }
        else
        {
            _S226 = false;
        }
        _S226 = !_S226;
    }
    else
    {
        _S226 = false;
    }
    if(shown_2.hole_1)
    {
        _S225 = true;
    }
    else
    {
        if(_S225)
        {
            _S225 = !shown_2.on_top_0;
        }
        else
        {
            _S225 = false;
        }
    }
    var _S231 : f32;
    if(_S228)
    {
        _S231 = _S227;
    }
    else
    {
        _S231 = cell_5.half_width_1;
    }
    var _S232 : f32 = _S231 - _S223;
    if(_S225)
    {
        _S223 = 2.0f * _S224 + _S223 - cell_5.half_width_1;
    }
    else
    {
        _S223 = _S224;
    }
    if(_S226)
    {
        if(forwards_0)
        {
            _S223 = run_2.to_end_0;
        }
        else
        {
            _S223 = run_2.from_start_0;
        }
        return _S223;
    }
    if(_S229)
    {
    }
    else
    {
        _S223 = _S232;
    }
    return _S223;
}

struct Probe_0
{
     height_1 : f32,
     hole_2 : bool,
     slope_x_0 : f32,
     slope_y_0 : f32,
     yarn_2 : u32,
     cell_max_0 : f32,
     side_x_0 : f32,
     side_y_0 : f32,
     edge_x_0 : f32,
     edge_y_0 : f32,
};

fn way_back_to_dip_0( previous_1 : PreviousSample_0,  clearance_1 : f32,  rate_1 : f32,  step_4 : f32,  here_0 : Probe_0) -> f32
{
    var _S233 : f32 = previous_1.rate_0 * step_4;
    var _S234 : f32 = rate_1 * step_4;
    var _S235 : bool;
    if(!previous_1.known_0)
    {
        _S235 = true;
    }
    else
    {
        _S235 = here_0.hole_2;
    }
    if(_S235)
    {
        _S235 = true;
    }
    else
    {
        _S235 = (previous_1.yarn_1) != (here_0.yarn_2);
    }
    if(_S235)
    {
        _S235 = true;
    }
    else
    {
        _S235 = (previous_1.rate_0) >= 0.0f;
    }
    if(_S235)
    {
        _S235 = true;
    }
    else
    {
        _S235 = rate_1 <= 0.0f;
    }
    if(_S235)
    {
        return -1.0f;
    }
    if((3.0f * previous_1.clearance_0 + _S233) >= 0.0f)
    {
        _S235 = (3.0f * clearance_1 - _S234) >= 0.0f;
    }
    else
    {
        _S235 = false;
    }
    if(_S235)
    {
        return -1.0f;
    }
    var _S236 : f32 = clearance_1 - previous_1.clearance_0;
    var _S237 : f32 = 6.0f * _S236 - 4.0f * _S233 - 2.0f * _S234;
    var _S238 : f32 = -2.0f * _S233 / max(_S237 + sqrt(max(_S237 * _S237 - 4.0f * (3.0f * (_S233 + _S234 - 2.0f * _S236)) * _S233, 0.0f)), 9.99999968265522539e-21f);
    var _S239 : f32 = 1.0f - _S238;
    var _S240 : f32 = (previous_1.clearance_0 * (2.0f * _S238 + 1.0f) + _S233 * _S238) * _S239 * _S239;
    var _S241 : f32 = (clearance_1 * (2.0f * _S239 + 1.0f) - _S234 * _S239) * _S238 * _S238;
    if(_S238 > 0.01999999955296516f)
    {
        _S235 = _S239 > 0.01999999955296516f;
    }
    else
    {
        _S235 = false;
    }
    if(_S235)
    {
        _S235 = (_S240 + _S241) < 0.0f;
    }
    else
    {
        _S235 = false;
    }
    var _S242 : f32;
    if(_S235)
    {
        _S242 = _S239 * step_4;
    }
    else
    {
        _S242 = -1.0f;
    }
    return _S242;
}

fn after_sample_0( clearance_2 : f32,  rate_2 : f32,  here_1 : Probe_0,  is_cell_exit_0 : bool) -> PreviousSample_0
{
    var previous_2 : PreviousSample_0;
    var _S243 : f32;
    if(here_1.hole_2)
    {
        _S243 = 1.0e+09f;
    }
    else
    {
        _S243 = clearance_2;
    }
    previous_2.clearance_0 = _S243;
    previous_2.rate_0 = rate_2;
    previous_2.yarn_1 = here_1.yarn_2;
    var _S244 : bool;
    if(!here_1.hole_2)
    {
        _S244 = !is_cell_exit_0;
    }
    else
    {
        _S244 = false;
    }
    previous_2.known_0 = _S244;
    return previous_2;
}

fn StepControl_to_cell_exit_0( this_5 : StepControl_0,  side_x_1 : f32,  side_y_1 : f32) -> f32
{
    return max(min(side_x_1 * this_5.per_x_0, side_y_1 * this_5.per_y_0), 0.0f) + this_5.epsilon_0;
}

fn StepControl_to_next_sample_0( this_6 : StepControl_0,  here_2 : Probe_0,  clearance_3 : f32,  rate_3 : f32) -> f32
{
    var _S245 : f32 = min(here_2.edge_x_0 * this_6.per_x_0, here_2.edge_y_0 * this_6.per_y_0);
    var _S246 : bool;
    if(!here_2.hole_2)
    {
        _S246 = (rate_3 * _S245 + clearance_3) < 0.0f;
    }
    else
    {
        _S246 = false;
    }
    if(_S246)
    {
        _S246 = _S245 > (2.0f * this_6.epsilon_0);
    }
    else
    {
        _S246 = false;
    }
    var _S247 : f32;
    if(_S246)
    {
        _S247 = _S245 - this_6.epsilon_0;
    }
    else
    {
        _S247 = max(_S245, 0.0f) + this_6.epsilon_0;
    }
    return min(this_6.step_2, _S247);
}

struct ViewRay_0
{
     origin_0 : vec2<f32>,
     slope_1 : vec2<f32>,
};

fn ViewRay_at_0( this_7 : ViewRay_0,  height_2 : f32) -> vec2<f32>
{
    return this_7.origin_0 + this_7.slope_1 * vec2<f32>(height_2);
}

fn ViewRay_rate_0( this_8 : ViewRay_0,  here_3 : Probe_0) -> f32
{
    return here_3.slope_x_0 * this_8.slope_1.x + here_3.slope_y_0 * this_8.slope_1.y - 1.0f;
}

fn cubic_root_0( start_1 : f32,  end_0 : f32,  start_rate_0 : f32,  end_rate_0 : f32) -> f32
{
    var _S248 : f32 = end_0 - start_1;
    var _S249 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S248;
    var _S250 : f32 = 3.0f * _S248 - 2.0f * start_rate_0 - end_rate_0;
    var share_1 : f32 = start_1 / max(- _S248, 9.99999968265522539e-21f);
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
        var _S251 : f32 = clamp(share_1 - (((_S249 * share_1 + _S250) * share_1 + start_rate_0) * share_1 + start_1) / min((3.0f * _S249 * share_1 + 2.0f * _S250) * share_1 + start_rate_0, 0.10000000149011612f * _S248 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S252 : i32 = i_0 + i32(1);
        share_1 = _S251;
        i_0 = _S252;
    }
    return share_1;
}

fn between_0( above_1 : f32,  under_0 : f32,  above_gap_0 : f32,  under_gap_0 : f32) -> f32
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

fn fibre_direction_0( across_slope_0 : f32,  along_slope_0 : f32,  sine_1 : f32,  cosine_0 : f32) -> vec2<f32>
{
    var _S253 : f32 = along_slope_0 * along_slope_0 + 1.0f;
    var _S254 : f32 = rsqrt_0(_S253);
    var _S255 : f32 = sine_1 * _S254 * rsqrt_0(_S253 + across_slope_0 * across_slope_0);
    return vec2<f32>(- _S255 * _S253, _S255 * across_slope_0 * along_slope_0 + cosine_0 * _S254);
}

fn arc_sine_0( x_7 : f32) -> f32
{
    var _S256 : f32 = abs(x_7);
    var _S257 : bool = _S256 > 0.5f;
    var _S258 : f32;
    if(_S257)
    {
        _S258 = 0.5f * (1.0f - _S256);
    }
    else
    {
        _S258 = _S256 * _S256;
    }
    var _S259 : f32;
    if(_S257)
    {
        _S259 = sqrt(max(_S258, 0.0f));
    }
    else
    {
        _S259 = _S256;
    }
    var _S260 : f32 = ((((0.04216320067644119f * _S258 + 0.02418131195008755f) * _S258 + 0.04547002539038658f) * _S258 + 0.07495300471782684f) * _S258 + 0.16666752099990845f) * _S258 * _S259 + _S259;
    if(_S257)
    {
        _S258 = 1.57079637050628662f - 2.0f * _S260;
    }
    else
    {
        _S258 = _S260;
    }
    if(x_7 < 0.0f)
    {
        _S258 = - _S258;
    }
    return _S258;
}

struct Hair_0
{
     cover_0 : f32,
     normal_0 : vec3<f32>,
     tangent_1 : vec3<f32>,
};

fn Hair_x24init_0( cover_1 : f32,  normal_1 : vec3<f32>,  tangent_2 : vec3<f32>) -> Hair_0
{
    var _S261 : Hair_0;
    _S261.cover_0 = cover_1;
    _S261.normal_0 = normal_1;
    _S261.tangent_1 = tangent_2;
    return _S261;
}

fn fade_0( size_4 : f32,  period_1 : f32) -> f32
{
    return clamp((1.0f - size_4 / period_1) * 1.33333337306976318f, 0.0f, 1.0f);
}

fn scramble_0( value_0 : u32) -> u32
{
    var _S262 : u32 = value_0 * u32(747796405) + u32(2891336453);
    var _S263 : u32 = ((((_S262 >> ((((_S262 >> (u32(28)))) + u32(4))))) ^ (_S262))) * u32(277803737);
    return (((_S263 >> (u32(22)))) ^ (_S263));
}

fn hash_key_0( thread_8 : u32,  stream_0 : u32) -> u32
{
    return scramble_0(thread_8 + scramble_0(stream_0));
}

fn hash_bits_0( key_0 : u32,  cell_6 : u32) -> u32
{
    return scramble_0(cell_6 + key_0);
}

fn share_of_0( bits_2 : u32) -> f32
{
    return (f32((bits_2 & (u32(1023)))) + 0.5f) * 0.0009765625f;
}

fn sine_cosine_0( x_8 : f32) -> vec2<f32>
{
    var _S264 : f32 = floor(x_8 * 0.63661974668502808f + 0.5f);
    var _S265 : f32 = x_8 - _S264 * 1.5703125f - _S264 * 0.00048375129699707f - _S264 * 7.54979012640433211e-08f;
    var _S266 : f32 = _S265 * _S265;
    var _S267 : f32 = ((-0.00019515295571182f * _S266 + 0.00833216123282909f) * _S266 - 0.16666655242443085f) * _S266 * _S265 + _S265;
    var _S268 : f32 = ((0.00002443315679557f * _S266 - 0.00138873164542019f) * _S266 + 0.04166664555668831f) * _S266 * _S266 - 0.5f * _S266 + 1.0f;
    var _S269 : u32 = (u32(i32(_S264)) & (u32(3)));
    var _S270 : vec2<f32>;
    if(((_S269 & (u32(1)))) != u32(0))
    {
        _S270 = vec2<f32>(_S268, _S267);
    }
    else
    {
        _S270 = vec2<f32>(_S267, _S268);
    }
    var _S271 : f32;
    if(((_S269 & (u32(2)))) != u32(0))
    {
        _S271 = - _S270.x;
    }
    else
    {
        _S271 = _S270.x;
    }
    var _S272 : f32;
    if((((_S269 + u32(1)) & (u32(2)))) != u32(0))
    {
        _S272 = - _S270.y;
    }
    else
    {
        _S272 = _S270.y;
    }
    return vec2<f32>(_S271, _S272);
}

fn albedos_of_0( family_14 : u32,  thread_9 : u32) -> Albedos_0
{
    return table_albedos_0(families_0[family_14].albedo_table_0 + families_0[family_14].albedo_stride_0 * thread_9);
}

fn fibre_cell_0( across_4 : f32,  along_1 : f32,  width_2 : f32) -> vec3<f32>
{
    var _S273 : f32 = floor(across_4 / width_2);
    return vec3<f32>(_S273, along_1 / (width_2 * 40.0f) + 0.61799997091293335f * _S273, 2.0f * (across_4 / width_2 - _S273) - 1.0f);
}

struct SurfacePoint_0
{
     hole_3 : bool,
     is_warp_1 : bool,
     warp_thread_0 : u32,
     weft_thread_0 : u32,
     height_3 : f32,
     normal_2 : vec3<f32>,
     tangent_3 : vec3<f32>,
     across_5 : f32,
     fibre_across_0 : f32,
     fibre_along_0 : f32,
};

fn ply_offset_0( family_15 : u32,  point_0 : SurfacePoint_0,  back_7 : bool) -> f32
{
    var _S274 : f32;
    if(back_7)
    {
        _S274 = - families_0[family_15].ply_sine_0;
    }
    else
    {
        _S274 = families_0[family_15].ply_sine_0;
    }
    var _S275 : f32 = (point_0.fibre_across_0 * families_0[family_15].ply_cosine_0 + point_0.fibre_along_0 * _S274) * families_0[family_15].plies_per_mm_0;
    return 2.0f * (_S275 - floor(_S275)) - 1.0f;
}

fn signed_noise_0( bits_3 : u32) -> f32
{
    return (f32((bits_3 & (u32(65535)))) + 0.5f) * 0.000030517578125f - 1.0f;
}

fn smooth_share_0( share_2 : f32) -> f32
{
    return share_2 * share_2 * (3.0f - 2.0f * share_2);
}

fn wave_noise_0( key_1 : u32,  position_4 : f32) -> vec2<f32>
{
    var _S276 : f32 = floor(position_4);
    var _S277 : f32 = position_4 - _S276;
    var _S278 : u32 = u32(i32(_S276));
    var _S279 : f32 = signed_noise_0(hash_bits_0(key_1, _S278));
    var _S280 : f32 = signed_noise_0(hash_bits_0(key_1, _S278 + u32(1)));
    return vec2<f32>(mix(_S279, _S280, smooth_share_0(_S277)), 6.0f * _S277 * (1.0f - _S277) * (_S280 - _S279));
}

fn cell_noise_0( key_2 : u32,  cell_7 : vec3<f32>) -> vec2<f32>
{
    var _S281 : f32 = cell_7.y;
    var _S282 : f32 = floor(_S281);
    var _S283 : u32 = u32(i32(cell_7.x)) * u32(65536) + u32(i32(_S282));
    var _S284 : u32 = hash_bits_0(key_2, _S283);
    var _S285 : u32 = hash_bits_0(key_2, _S283 + u32(1));
    return mix(vec2<f32>(signed_noise_0(_S284), signed_noise_0((_S284 >> (u32(16))))), vec2<f32>(signed_noise_0(_S285), signed_noise_0((_S285 >> (u32(16))))), vec2<f32>(smooth_share_0(_S281 - _S282)));
}

fn uniform_hash_0( thread_10 : u32,  cell_8 : u32,  stream_1 : u32) -> f32
{
    return (f32(((hash_bits_0(hash_key_0(thread_10, stream_1), cell_8)) >> (u32(9)))) + 0.5f) * 1.1920928955078125e-07f;
}

fn thread_gain_0( thread_11 : u32,  amount_0 : f32,  seed_3 : u32) -> f32
{
    return amount_0 * (2.0f * uniform_hash_0(thread_11, u32(0), (seed_3 ^ (u32(2135587861)))) - 1.0f) + 1.0f;
}

fn bounded_gain_0( gain_0 : f32,  albedo_1 : vec3<f32>,  room_0 : vec3<f32>) -> f32
{
    var _S286 : vec3<f32> = room_0 / max(albedo_1, vec3<f32>(9.99999997475242708e-07f));
    return min(gain_0, max(min(min(_S286.x, _S286.y), _S286.z), 0.0f));
}

fn flattened_0( largest_0 : f32,  albedo_2 : vec3<f32>,  room_1 : vec3<f32>) -> f32
{
    var _S287 : vec3<f32> = room_1 / max(albedo_2, vec3<f32>(9.99999997475242708e-07f)) - vec3<f32>(1.0f);
    return min(max(min(min(_S287.x, _S287.y), _S287.z), 0.0f) / max(largest_0, 9.99999997475242708e-07f), 1.0f);
}

fn natural_logarithm_0( x_9 : f32) -> f32
{
    var _S288 : u32 = (bitcast<u32>((x_9)));
    var exponent_0 : f32 = f32(i32((_S288 >> (u32(23)))) - i32(126));
    var m_0 : f32 = (bitcast<f32>(((((_S288 & (u32(8388607)))) | (u32(1056964608))))));
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
    var _S289 : f32 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S289 - exponent_1 * 0.00021219444170129f - 0.5f * _S289) + exponent_1 * 0.693359375f;
}

fn fibre_gain_0( thread_12 : u32,  cell_9 : u32,  amount_1 : f32,  seed_4 : u32) -> f32
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_12, cell_9, (seed_4 ^ (u32(2654435769))))), 10.0f) - 1.0f) + 1.0f;
}

struct YarnFrame_0
{
     normal_3 : vec3<f32>,
     tangent_4 : vec3<f32>,
     loss_0 : f32,
};

fn under_hair_0( frame_0 : YarnFrame_0,  hair_0 : Hair_0) -> YarnFrame_0
{
    var _S290 : vec3<f32>;
    if((dot(frame_0.tangent_4, hair_0.tangent_1)) < 0.0f)
    {
        _S290 = (vec3<f32>(0) - hair_0.tangent_1);
    }
    else
    {
        _S290 = hair_0.tangent_1;
    }
    var blended_0 : YarnFrame_0;
    var _S291 : vec3<f32> = vec3<f32>(hair_0.cover_0);
    var _S292 : vec3<f32> = normalize(mix(frame_0.normal_3, hair_0.normal_0, _S291));
    blended_0.normal_3 = _S292;
    var _S293 : vec3<f32> = mix(frame_0.tangent_4, _S290, _S291);
    var _S294 : vec3<f32> = _S293 - vec3<f32>(dot(_S293, _S292)) * _S292;
    blended_0.tangent_4 = _S294 * vec3<f32>(rsqrt_0(max(dot(_S294, _S294), 9.999999960041972e-13f)));
    blended_0.loss_0 = frame_0.loss_0 * (1.0f - hair_0.cover_0);
    return blended_0;
}

fn diffuse_gain_0( frame_1 : YarnFrame_0,  blend_0 : f32) -> f32
{
    return min(0.85000002384185791f * blend_0 * frame_1.loss_0 + 1.0f, 1.0f / (0.5f * blend_0 * (frame_1.normal_3.z - 1.0f) + 1.0f));
}

fn texel_along_0( share_3 : f32,  first_7 : u32,  extent_1 : f32,  count_2 : u32) -> u32
{
    var _S295 : f32 = min(floor(share_3 * extent_1), extent_1 - 1.0f);
    var _S296 : f32 = f32(count_2);
    var _S297 : u32 = first_7 + min(u32(max(_S295 - floor(_S295 / _S296) * _S296, 0.0f)), count_2 - u32(1));
    var _S298 : u32;
    if(_S297 >= count_2)
    {
        _S298 = _S297 - count_2;
    }
    else
    {
        _S298 = _S297;
    }
    return _S298;
}

fn texel_of_0( tables_3 : ptr<function, Clustered_std430_0>,  box_3 : TexelBox_0,  share_4 : vec2<f32>) -> u32
{
    return texel_along_0(share_4.y, box_3.first_1.y, box_3.extent_0.y, (*tables_3).rows_0) * (*tables_3).columns_0 + texel_along_0(share_4.x, box_3.first_1.x, box_3.extent_0.x, (*tables_3).columns_0);
}

fn table_byte_0( table_1 : u32,  index_3 : u32) -> u32
{
    return (((words_0[table_1 + index_3 / u32(4)] >> ((u32(8) * ((index_3 & (u32(3)))))))) & (u32(255)));
}

fn diffuse_reflection_0( light_5 : vec3<f32>,  normal_4 : vec3<f32>,  blend_1 : f32) -> f32
{
    var _S299 : f32 = light_5.z;
    if(_S299 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S299, 0.0f), max(dot(light_5, normal_4), 0.0f), blend_1);
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
    var _S300 : f32 = roughness_4 * roughness_4;
    var _S301 : f32 = squared_along_0 * (1.0f - _S300) + _S300;
    return 0.31830987334251404f * _S300 * roughness_4 / (_S301 * _S301);
}

fn density_between_0( light_6 : vec3<f32>,  view_8 : vec3<f32>,  tangent_5 : vec3<f32>,  roughness_5 : f32) -> f32
{
    var _S302 : vec3<f32> = light_6 + view_8;
    var _S303 : f32 = dot(_S302, tangent_5);
    return flake_density_0(min(_S303 * _S303 / max(square_0(_S302), 9.999999960041972e-13f), 1.0f), roughness_5);
}

fn transmission_1( light_7 : vec3<f32>,  view_9 : vec3<f32>,  normal_5 : vec3<f32>,  tangent_6 : vec3<f32>,  roughness_6 : f32,  optical_depth_1 : f32) -> f32
{
    var _S304 : f32 = - dot(light_7, normal_5);
    var _S305 : f32 = dot(view_9, normal_5);
    var _S306 : bool;
    if(_S304 <= 0.0f)
    {
        _S306 = true;
    }
    else
    {
        _S306 = _S305 <= 0.0f;
    }
    if(_S306)
    {
        return 0.0f;
    }
    var _S307 : f32 = 1.0f / max(_S305, 9.99999997475242708e-07f);
    var _S308 : f32 = projected_area_1(light_7, tangent_6, roughness_6) / max(_S304, 9.99999997475242708e-07f);
    var _S309 : f32 = projected_area_1(view_9, tangent_6, roughness_6) * _S307;
    return density_between_0(light_7, view_9, tangent_6, roughness_6) * 0.25f * optical_depth_1 * exponential_0(- optical_depth_1 * min(_S308, _S309)) * mean_attenuation_0(optical_depth_1 * abs(_S308 - _S309)) * _S307;
}

fn reflection_0( light_8 : vec3<f32>,  view_10 : vec3<f32>,  normal_6 : vec3<f32>,  tangent_7 : vec3<f32>,  roughness_7 : f32,  optical_depth_2 : f32) -> f32
{
    var _S310 : f32 = dot(light_8, normal_6);
    var _S311 : bool;
    if(_S310 <= 0.0f)
    {
        _S311 = true;
    }
    else
    {
        _S311 = (dot(view_10, normal_6)) <= 0.0f;
    }
    if(_S311)
    {
        return 0.0f;
    }
    var _S312 : f32 = max(_S310, 9.99999997475242708e-07f);
    var _S313 : f32 = max(dot(view_10, normal_6), 9.99999997475242708e-07f);
    var _S314 : f32 = projected_area_1(light_8, tangent_7, roughness_7) * _S313 + projected_area_1(view_10, tangent_7, roughness_7) * _S312;
    var _S315 : f32 = optical_depth_2 * _S314 / (_S312 * _S313);
    return 0.25f * density_between_0(light_8, view_10, tangent_7, roughness_7) * (_S315 * mean_attenuation_0(_S315)) * _S312 / _S314;
}

struct ClusteredView_0
{
     base_0 : ViewedBase_0,
     albedos_5 : FamilyAlbedos_0,
     bounced_2 : Bounced_0,
     view_11 : vec3<f32>,
     is_alone_0 : bool,
};

fn viewed_base_0( _S316 : u32,  _S317 : Footprint_0,  _S318 : vec3<f32>,  _S319 : f32,  _S320 : bool) -> ViewedBase_0
{
    var seen_1 : ViewedBase_0;
    var _S321 : bool = (_S318.z) < 0.0f;
    seen_1.back_5 = _S321;
    seen_1.view_4 = to_face_frame_0(_S318, _S321);
    var _S322 : u32;
    if(_S321)
    {
        _S322 = u32(1);
    }
    else
    {
        _S322 = u32(0);
    }
    seen_1.face_1 = _S322;
    var _S323 : BinTaps_0 = bin_taps_0(seen_1.view_4, u32(16));
    seen_1.around_1 = _S323;
    var _S324 : u32 = _S322 * u32(256);
    var _S325 : Clustered_std430_0 = fabrics_0[_S316].clustered_0;
    var _S326 : TexelBox_0 = texel_box_0(&(_S325), _S317, vec2<f32>(BinTaps_read_0(_S323, _S325.offset_1, _S324, u32(2), u32(0)), BinTaps_read_0(_S323, _S325.offset_1, _S324, u32(2), u32(1))), _S319 - 0.5f);
    seen_1.box_2 = _S326;
    seen_1.trust_1 = vec2<f32>(1.0f);
    if(!_S320)
    {
        seen_1.trust_1 = vec2<f32>(BinTaps_read_0(seen_1.around_1, _S325.trust_0, _S324, u32(2), u32(0)), BinTaps_read_0(seen_1.around_1, _S325.trust_0, _S324, u32(2), u32(1)));
    }
    return seen_1;
}

fn albedos_over_0( _S327 : u32,  _S328 : Footprint_0,  _S329 : bool) -> FamilyAlbedos_0
{
    var _S330 : vec2<f32> = _S328.dx_0;
    var _S331 : vec2<f32> = _S328.dy_0;
    var _S332 : vec2<f32> = sqrt(_S330 * _S330 + _S331 * _S331);
    var _S333 : Stretch_0 = stretch_of_0(fabrics_0[_S327].warp_0, _S328.centre_0.x, _S332.x);
    var _S334 : Stretch_0 = stretch_of_0(fabrics_0[_S327].weft_0, _S328.centre_0.y, _S332.y);
    var albedos_6 : FamilyAlbedos_0;
    albedos_6.warp_3 = mean_albedos_0(fabrics_0[_S327].warp_0, fabrics_0[_S327].weft_0, _S333, _S334, _S329);
    albedos_6.weft_3 = mean_albedos_0(fabrics_0[_S327].weft_0, fabrics_0[_S327].warp_0, _S334, _S333, _S329);
    return albedos_6;
}

fn openness_number_0( _S335 : u32,  _S336 : u32) -> f32
{
    return table_number_0(fabrics_0[_S335].openness_0 + _S336);
}

fn scattered_by_0( _S337 : u32,  _S338 : Albedos_0,  _S339 : u32,  _S340 : vec3<f32>) -> Scattered_0
{
    var _S341 : u32 = u32(159) + u32(2) * _S339;
    var yarn_3 : Scattered_0;
    yarn_3.back_4 = _S340 * _S338.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S337, _S341)) * _S338.specular_reflect_0;
    yarn_3.through_0 = _S340 * _S338.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S337, _S341 + u32(1))) * _S338.specular_transmit_0;
    return yarn_3;
}

fn sent_0( _S342 : u32,  _S343 : u32,  _S344 : vec3<f32>,  _S345 : vec3<f32>,  _S346 : vec3<f32>,  _S347 : vec3<f32>,  _S348 : ptr<function, vec3<f32>>,  _S349 : ptr<function, vec3<f32>>)
{
    var _S350 : u32 = u32(146) + u32(4) * _S343;
    var _S351 : f32 = openness_number_0(_S342, _S350 + u32(1));
    var _S352 : f32 = openness_number_0(_S342, _S350 + u32(2));
    var _S353 : vec3<f32> = vec3<f32>(1.0f);
    var _S354 : vec3<f32> = _S353 - _S346 * vec3<f32>(openness_number_0(_S342, _S350));
    var _S355 : vec3<f32> = _S353 - _S347 * vec3<f32>(openness_number_0(_S342, _S350 + u32(3)));
    var _S356 : vec3<f32> = _S353 / (_S354 * _S355 - _S346 * _S347 * vec3<f32>((_S351 * _S352)));
    (*_S348) = (_S344 * _S355 + _S346 * vec3<f32>(_S351) * _S345) * _S356;
    (*_S349) = (_S345 * _S354 + _S347 * vec3<f32>(_S352) * _S344) * _S356;
    return;
}

fn face_sends_0( _S357 : u32,  _S358 : u32,  _S359 : Scattered_0,  _S360 : Scattered_0) -> FaceSends_0
{
    var _S361 : u32 = u32(2) * _S358;
    var _S362 : u32 = u32(142) + _S361;
    var _S363 : f32 = openness_number_0(_S357, _S362);
    var _S364 : f32 = openness_number_0(_S357, _S362 + u32(1));
    var _S365 : vec3<f32> = vec3<f32>((1.0f - _S363)) * _S359.back_4;
    var _S366 : vec3<f32> = vec3<f32>((1.0f - _S364)) * _S360.back_4;
    var sends_1 : FaceSends_0;
    var _S367 : u32 = u32(154) + _S361;
    var _S368 : f32 = openness_number_0(_S357, _S367);
    sends_1.blocks_warp_0 = _S368;
    var _S369 : f32 = openness_number_0(_S357, _S367 + u32(1));
    sends_1.blocks_weft_0 = _S369;
    sends_1.open_0 = _S368 * _S363 + _S369 * _S364;
    var _S370 : vec3<f32> = vec3<f32>(_S363) * _S359.back_4;
    var _S371 : vec3<f32> = vec3<f32>(_S364) * _S360.back_4;
    var _S372 : vec3<f32> = sends_1.sky_warp_0;
    var _S373 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S357, _S358, _S370, _S371, _S365, _S366, &(_S372), &(_S373));
    sends_1.sky_warp_0 = _S372;
    sends_1.sky_weft_0 = _S373;
    var _S374 : vec3<f32> = sends_1.crossing_warp_0;
    var _S375 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S357, _S358, _S359.through_0, _S360.through_0, _S365, _S366, &(_S374), &(_S375));
    sends_1.crossing_warp_0 = _S374;
    sends_1.crossing_weft_0 = _S375;
    return sends_1;
}

fn interior_of_0( _S376 : u32,  _S377 : vec3<f32>,  _S378 : bool) -> Interior_0
{
    var _S379 : Scattered_0 = scattered_by_0(_S376, table_albedos_0(families_0[fabrics_0[_S376].warp_0].colour_mean_0), u32(0), _S377);
    var _S380 : Scattered_0 = scattered_by_0(_S376, table_albedos_0(families_0[fabrics_0[_S376].weft_0].colour_mean_0), u32(1), _S377);
    var _S381 : u32;
    if(_S378)
    {
        _S381 = u32(1);
    }
    else
    {
        _S381 = u32(0);
    }
    var _S382 : FaceSends_0 = face_sends_0(_S376, _S381, _S379, _S380);
    if(_S378)
    {
        _S381 = u32(0);
    }
    else
    {
        _S381 = u32(1);
    }
    var _S383 : FaceSends_0 = face_sends_0(_S376, _S381, _S379, _S380);
    var _S384 : vec3<f32> = vec3<f32>(_S382.blocks_warp_0);
    var _S385 : vec3<f32> = vec3<f32>(_S382.blocks_weft_0);
    var _S386 : vec3<f32> = _S384 * _S382.crossing_warp_0 + _S385 * _S382.crossing_weft_0;
    var _S387 : vec3<f32> = vec3<f32>(_S383.blocks_warp_0);
    var _S388 : vec3<f32> = vec3<f32>(_S383.blocks_weft_0);
    var _S389 : vec3<f32> = _S387 * _S383.crossing_warp_0 + _S388 * _S383.crossing_weft_0;
    var _S390 : f32 = 1.0f - _S382.open_0;
    var _S391 : f32 = 1.0f - _S383.open_0;
    var _S392 : vec3<f32> = vec3<f32>(1.0f);
    var _S393 : vec3<f32> = _S392 / (_S392 - _S386 * _S389 * vec3<f32>((_S390 * _S391)));
    var _S394 : vec3<f32> = _S389 * (vec3<f32>(_S382.open_0) + vec3<f32>(_S390) * (_S384 * _S382.sky_warp_0 + _S385 * _S382.sky_weft_0)) * _S393;
    var _S395 : vec3<f32> = _S386 * (vec3<f32>(_S383.open_0) + vec3<f32>(_S391) * (_S387 * _S383.sky_warp_0 + _S388 * _S383.sky_weft_0)) * _S393;
    var _S396 : FaceRadiance_0 = face_radiance_0(_S382, _S383.open_0, _S394, _S395);
    var _S397 : FaceRadiance_0 = face_radiance_0(_S383, _S382.open_0, _S395, _S394);
    var interior_1 : Interior_0;
    interior_1.warp_2 = _S396.warp_1;
    interior_1.weft_2 = _S396.weft_1;
    interior_1.leaked_1 = _S396.leaked_0;
    interior_1.far_1 = _S397.mean_0;
    interior_1.far_leaked_0 = _S397.leaked_0;
    return interior_1;
}

fn blocked_of_terms_0( _S398 : u32,  _S399 : u32,  _S400 : array<f32, i32(6)>,  _S401 : u32) -> Blocked_0
{
    var shares_0 : array<f32, i32(3)>;
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
        shares_0[share_5] = 0.0f;
        var term_0 : u32 = u32(0);
        for(;;)
        {
            if(term_0 < _S401)
            {
            }
            else
            {
                break;
            }
            shares_0[share_5] = shares_0[share_5] + openness_number_0(_S398, _S399 + share_5 * _S401 + term_0) * _S400[term_0];
            term_0 = term_0 + u32(1);
        }
        shares_0[share_5] = saturate(shares_0[share_5]);
        share_5 = share_5 + u32(1);
    }
    var blocked_2 : Blocked_0;
    blocked_2.by_warp_0 = shares_0[i32(0)] * shares_0[i32(2)];
    blocked_2.by_weft_0 = shares_0[i32(0)] * (1.0f - shares_0[i32(2)]);
    blocked_2.far_0 = shares_0[i32(1)];
    return blocked_2;
}

fn blocked_from_0( _S402 : u32,  _S403 : vec3<f32>,  _S404 : bool,  _S405 : bool) -> Blocked_0
{
    var terms_2 : array<f32, i32(6)>;
    view_terms_0(_S403, &(terms_2));
    var _S406 : u32;
    if(_S405)
    {
        _S406 = u32(2);
    }
    else
    {
        _S406 = u32(0);
    }
    var _S407 : u32;
    if(_S404)
    {
        _S407 = u32(0);
    }
    else
    {
        _S407 = u32(1);
    }
    return blocked_of_terms_0(_S402, (_S406 + _S407) * u32(15), terms_2, u32(5));
}

fn warp_seen_from_0( _S408 : u32,  _S409 : vec3<f32>,  _S410 : bool) -> f32
{
    var terms_3 : array<f32, i32(6)>;
    view_terms_1(_S409, &(terms_3));
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
        var _S411 : u32;
        if(_S410)
        {
            _S411 = u32(5);
        }
        else
        {
            _S411 = u32(0);
        }
        var share_7 : f32 = share_6 + openness_number_0(_S408, u32(132) + _S411 + term_1) * terms_3[term_1];
        term_1 = term_1 + u32(1);
        share_6 = share_7;
    }
    return saturate(share_6);
}

fn bounced_of_families_0( _S412 : u32,  _S413 : FamilyAlbedos_0,  _S414 : vec3<f32>,  _S415 : Interior_0,  _S416 : Blocked_0,  _S417 : Blocked_0) -> Bounced_0
{
    return sum_of_0(bounced_by_0(_S416, scattered_by_0(_S412, _S413.warp_3, u32(0), _S414), _S415), bounced_by_0(_S417, scattered_by_0(_S412, _S413.weft_3, u32(1), _S414), _S415));
}

fn bounced_far_0( _S418 : u32,  _S419 : FamilyAlbedos_0,  _S420 : vec3<f32>,  _S421 : Interior_0,  _S422 : vec3<f32>,  _S423 : bool,  _S424 : f32,  _S425 : f32,  _S426 : f32) -> Bounced_0
{
    var _S427 : Blocked_0 = blocked_from_0(_S418, _S422, true, _S423);
    var _S428 : Blocked_0 = blocked_from_0(_S418, _S422, false, _S423);
    var _S429 : f32 = _S424 / max(1.0f - _S427.by_warp_0 - _S427.by_weft_0, 0.10000000149011612f);
    var _S430 : f32 = (0.0020000000949949f * warp_seen_from_0(_S418, _S422, _S423) + _S429) / (_S429 + _S425 / max(1.0f - _S428.by_warp_0 - _S428.by_weft_0, 0.10000000149011612f) + 0.0020000000949949f);
    var _S431 : f32 = 1.0f - _S426;
    return bounced_of_families_0(_S418, _S419, _S420, _S421, scaled_0(_S427, _S430 * _S431), scaled_0(_S428, (1.0f - _S430) * _S431));
}

fn clustered_view_0( _S432 : u32,  _S433 : Footprint_0,  _S434 : vec3<f32>,  _S435 : vec3<f32>,  _S436 : u32,  _S437 : bool) -> ClusteredView_0
{
    var seen_2 : ClusteredView_0;
    seen_2.base_0 = viewed_base_0(_S432, _S433, _S434, uniform_of_0(_S436, u32(0)), _S437);
    seen_2.view_11 = _S434;
    seen_2.is_alone_0 = _S437;
    var _S438 : FamilyAlbedos_0 = albedos_over_0(_S432, _S433, seen_2.base_0.back_5);
    seen_2.albedos_5.warp_3 = tinted_0(_S438.warp_3, _S435);
    seen_2.albedos_5.weft_3 = tinted_0(_S438.weft_3, _S435);
    var _S439 : vec3<f32> = vec3<f32>(0.0f);
    seen_2.bounced_2.reflected_0 = _S439;
    seen_2.bounced_2.transmitted_0 = _S439;
    if((fabrics_0[_S432].openness_0) != u32(4294967295))
    {
        seen_2.bounced_2 = bounced_far_0(_S432, _S438, _S435, interior_of_0(_S432, _S435, seen_2.base_0.back_5), seen_2.base_0.view_4, seen_2.base_0.back_5, 0.0f, 0.0f, 0.0f);
    }
    return seen_2;
}

fn clustered_hole_0( _S440 : u32,  _S441 : ViewedBase_0) -> f32
{
    var cluster_0 : u32 = u32(0);
    var covered_0 : f32 = 0.0f;
    for(;;)
    {
        var _S442 : Clustered_std430_0 = fabrics_0[_S440].clustered_0;
        if(cluster_0 < (_S442.clusters_0))
        {
        }
        else
        {
            break;
        }
        var _S443 : f32 = box_mean_0(&(_S442), _S441.box_2, _S441.face_1, cluster_0);
        var covered_1 : f32 = covered_0 + _S443;
        cluster_0 = cluster_0 + u32(1);
        covered_0 = covered_1;
    }
    return clamp(1.0f - covered_0, 0.0f, 1.0f);
}

fn cluster_density_0( _S444 : u32,  _S445 : ViewedBase_0,  _S446 : BaseTaps_0,  _S447 : u32,  _S448 : u32) -> f32
{
    return BinTaps_read_0(_S446.half_vector_0, fabrics_0[_S444].clustered_0.basis_0, _S445.face_1 * u32(1024), fabrics_0[_S444].clustered_0.clusters_0 * (u32(1) + fabrics_0[_S444].clustered_0.rank_0), _S448 * fabrics_0[_S444].clustered_0.clusters_0 + _S447);
}

struct ClusterTerms_0
{
     diffuse_0 : f32,
     specular_0 : f32,
     lit_0 : f32,
};

fn cluster_attenuation_0( _S449 : u32,  _S450 : ViewedBase_0,  _S451 : BaseTaps_0,  _S452 : u32) -> f32
{
    var _S453 : u32 = fabrics_0[_S449].clustered_0.moments_1 + (_S450.face_1 * fabrics_0[_S449].clustered_0.clusters_0 + _S452) * u32(8);
    var _S454 : vec3<f32> = vec3<f32>(table_number_0(_S453), table_number_0(_S453 + u32(1)), table_number_0(_S453 + u32(2)));
    var _S455 : vec3<f32> = vec3<f32>(table_number_0(_S453 + u32(3)), table_number_0(_S453 + u32(4)), table_number_0(_S453 + u32(5)));
    var _S456 : f32 = table_number_0(_S453 + u32(7));
    var _S457 : f32 = fabrics_0[_S449].optical_depth_0;
    var _S458 : f32 = dot(_S451.facing_0, _S454);
    var _S459 : f32;
    if(_S451.transmits_1)
    {
        _S459 = - _S458;
    }
    else
    {
        _S459 = _S458;
    }
    var _S460 : f32 = max(dot(_S450.view_4, _S454), 0.10000000149011612f);
    var _S461 : f32 = projected_area_1(_S451.facing_0, _S455, _S456) / max(_S459, 0.10000000149011612f);
    var _S462 : f32 = projected_area_1(_S450.view_4, _S455, _S456) / _S460;
    if(!_S451.transmits_1)
    {
        var _S463 : f32 = _S461 + _S462;
        return 0.25f * (1.0f - exponential_0(- _S457 * _S463)) / (_S463 * _S460);
    }
    var _S464 : f32 = max(_S457 * abs(_S461 - _S462), 0.00100000004749745f);
    return 0.25f * _S457 * exponential_0(- _S457 * min(_S461, _S462)) * (1.0f - exponential_0(- _S464)) / (_S464 * _S460);
}

fn cluster_terms_0( _S465 : u32,  _S466 : ViewedBase_0,  _S467 : BaseTaps_0,  _S468 : u32) -> ClusterTerms_0
{
    var _S469 : u32 = u32(2) * fabrics_0[_S465].clustered_0.clusters_0;
    var _S470 : f32 = BinTaps_read_0(_S467.around_0, fabrics_0[_S465].clustered_0.light_0, _S467.first_4, _S469, _S468);
    var _S471 : f32 = BinTaps_read_0(_S466.around_1, fabrics_0[_S465].clustered_0.view_0, _S466.face_1 * u32(256), fabrics_0[_S465].clustered_0.clusters_0, _S468);
    var terms_4 : ClusterTerms_0;
    var _S472 : f32 = _S466.trust_1.x * _S471;
    terms_4.diffuse_0 = _S472 * 0.31830987334251404f * ((1.0f - fabrics_0[_S465].diffuse_blend_0) * abs(_S467.facing_0.z) * _S470 + fabrics_0[_S465].diffuse_blend_0 * BinTaps_read_0(_S467.around_0, fabrics_0[_S465].clustered_0.light_0, _S467.first_4, _S469, fabrics_0[_S465].clustered_0.clusters_0 + _S468));
    terms_4.specular_0 = _S466.trust_1.y * _S471 * _S470 * cluster_attenuation_0(_S465, _S466, _S467, _S468);
    terms_4.lit_0 = _S472 * _S470;
    return terms_4;
}

fn with_cluster_0( _S473 : u32,  _S474 : Components_0,  _S475 : ClusterTerms_0,  _S476 : u32,  _S477 : f32,  _S478 : f32) -> Components_0
{
    var _S479 : bool = _S476 < (fabrics_0[_S473].clustered_0.clusters_0 / u32(2));
    var result_2 : Components_0 = _S474;
    var _S480 : f32;
    if(_S479)
    {
        _S480 = _S477 * _S475.diffuse_0;
    }
    else
    {
        _S480 = 0.0f;
    }
    result_2.diffuse_warp_0 = result_2.diffuse_warp_0 + _S480;
    if(_S479)
    {
        _S480 = 0.0f;
    }
    else
    {
        _S480 = _S477 * _S475.diffuse_0;
    }
    result_2.diffuse_weft_0 = result_2.diffuse_weft_0 + _S480;
    if(_S479)
    {
        _S480 = _S475.specular_0 * _S478;
    }
    else
    {
        _S480 = 0.0f;
    }
    result_2.specular_warp_0 = result_2.specular_warp_0 + _S480;
    if(_S479)
    {
        _S480 = 0.0f;
    }
    else
    {
        _S480 = _S475.specular_0 * _S478;
    }
    result_2.specular_weft_0 = result_2.specular_weft_0 + _S480;
    result_2.light_visibility_1 = result_2.light_visibility_1 + _S477 * _S475.lit_0;
    return result_2;
}

fn clustered_base_0( _S481 : u32,  _S482 : ViewedBase_0,  _S483 : BaseTaps_0) -> Components_0
{
    var _S484 : Clustered_std430_0 = fabrics_0[_S481].clustered_0;
    var _S485 : u32 = _S484.clusters_0;
    var base_1 : Components_0 = no_components_0();
    var cluster_1 : u32 = u32(0);
    for(;;)
    {
        if(cluster_1 < _S485)
        {
        }
        else
        {
            break;
        }
        var _S486 : f32 = box_mean_0(&(_S484), _S482.box_2, _S482.face_1, cluster_1);
        if(_S486 <= 0.0f)
        {
            cluster_1 = cluster_1 + u32(1);
            continue;
        }
        var _S487 : f32 = _S486 * cluster_density_0(_S481, _S482, _S483, cluster_1, u32(0));
        var number_2 : u32 = u32(1);
        var density_0 : f32 = _S487;
        for(;;)
        {
            if(number_2 <= (_S484.rank_0))
            {
            }
            else
            {
                break;
            }
            var _S488 : f32 = box_mean_0(&(_S484), _S482.box_2, _S482.face_1, number_2 * _S485 + cluster_1);
            var density_1 : f32 = density_0 + _S488 * cluster_density_0(_S481, _S482, _S483, cluster_1, number_2);
            number_2 = number_2 + u32(1);
            density_0 = density_1;
        }
        base_1 = with_cluster_0(_S481, base_1, cluster_terms_0(_S481, _S482, _S483, cluster_1), cluster_1, _S486, density_0);
        cluster_1 = cluster_1 + u32(1);
    }
    return base_1;
}

fn under_sheen_0( _S489 : u32,  _S490 : ClusteredView_0,  _S491 : vec3<f32>,  _S492 : f32,  _S493 : vec3<f32>) -> vec3<f32>
{
    var _S494 : f32 = fabrics_0[_S489].sheen_strength_0;
    if((fabrics_0[_S489].sheen_strength_0) <= 0.0f)
    {
        return _S491;
    }
    var _S495 : vec2<f32> = sheen_with_transmittance_0(to_face_frame_0(_S493, _S490.base_0.back_5), _S490.base_0.view_4, _S494, fabrics_0[_S489].sheen_roughness_0);
    return vec3<f32>(_S495.y) * _S491 + vec3<f32>((_S492 * _S495.x));
}

fn clustered_base_value_0( _S496 : u32,  _S497 : ClusteredView_0,  _S498 : f32,  _S499 : vec3<f32>) -> vec3<f32>
{
    var _S500 : BaseTaps_0 = base_taps_0(_S497.base_0, _S499);
    var _S501 : Components_0 = clustered_base_0(_S496, _S497.base_0, _S500);
    return under_sheen_0(_S496, _S497, shaded_0(_S501, _S497.albedos_5, _S500.transmits_1) + vec3<f32>((1.0f - _S498)) * bounced_value_0(_S497.bounced_2, _S499, _S497.view_11), _S501.light_visibility_1 + _S498, _S499);
}

struct YarnPoint_0
{
     back_8 : bool,
     hole_4 : bool,
     is_warp_2 : bool,
     x_10 : f32,
     y_4 : f32,
     height_4 : f32,
     normal_7 : vec3<f32>,
     tangent_8 : vec3<f32>,
     surface_normal_0 : vec3<f32>,
     diffuse_gain_1 : f32,
     roughness_8 : f32,
     albedos_7 : Albedos_0,
};

struct ResidualPoint_0
{
     point_1 : YarnPoint_0,
     texel_0 : u32,
};

struct Hit_0
{
     x_11 : f32,
     y_5 : f32,
     hole_5 : bool,
     height_5 : f32,
};

struct Sample_0
{
     crossing_2 : Crossing_0,
     shown_3 : Shown_0,
     run_3 : Run_0,
     section_1 : Section_0,
     height_6 : f32,
     slope_across_0 : f32,
     slope_along_0 : f32,
     slope_x_1 : f32,
     slope_y_1 : f32,
};

fn crossing_at_0( _S502 : u32,  _S503 : f32,  _S504 : f32,  _S505 : bool) -> Crossing_0
{
    var crossing_3 : Crossing_0;
    crossing_3.warp_4 = locate_0(fabrics_0[_S502].warp_0, _S503);
    crossing_3.weft_4 = locate_0(fabrics_0[_S502].weft_0, _S504);
    var _S506 : u32 = fabrics_0[_S502].run_words_0 + u32(2) * (crossing_3.weft_4.thread_0 * fabrics_0[_S502].ends_1 + crossing_3.warp_4.thread_0);
    var _S507 : u32 = words_0[_S506];
    crossing_3.warp_word_0 = _S507;
    crossing_3.weft_word_0 = words_0[_S506 + u32(1)];
    crossing_3.warp_above_0 = (((_S507 & (u32(1)))) == u32(1)) != _S505;
    return crossing_3;
}

fn sample_at_0( _S508 : u32,  _S509 : f32,  _S510 : f32,  _S511 : bool) -> Sample_0
{
    var sample_0 : Sample_0;
    var _S512 : Crossing_0 = crossing_at_0(_S508, _S509, _S510, _S511);
    sample_0.crossing_2 = _S512;
    var _S513 : Shown_0 = shown_at_0(_S512, _S511);
    sample_0.shown_3 = _S513;
    var _S514 : u32;
    if(_S513.is_warp_0)
    {
        _S514 = fabrics_0[_S508].warp_0;
    }
    else
    {
        _S514 = fabrics_0[_S508].weft_0;
    }
    var _S515 : u32;
    if(_S513.is_warp_0)
    {
        _S515 = fabrics_0[_S508].weft_0;
    }
    else
    {
        _S515 = fabrics_0[_S508].warp_0;
    }
    var _S516 : Cell_0 = select_cell_0(_S513.is_warp_0, sample_0.crossing_2.warp_4, sample_0.crossing_2.weft_4);
    var _S517 : Cell_0 = select_cell_0(_S513.is_warp_0, sample_0.crossing_2.weft_4, sample_0.crossing_2.warp_4);
    var _S518 : Run_0 = unpack_0(_S514, _S515, _S516.thread_0, _S517, _S513.word_0);
    var _S519 : Section_0 = section_at_0(_S516);
    var _S520 : bool;
    if(_S513.on_top_0)
    {
        _S520 = (_S518.distance_0) < (_S519.drop_0 * _S518.bend_1.sine_0);
    }
    else
    {
        _S520 = false;
    }
    var _S521 : bool;
    if(_S513.on_top_0)
    {
        _S521 = !_S520;
    }
    else
    {
        _S521 = false;
    }
    var _S522 : f32;
    if(_S521)
    {
        _S522 = 1.0f;
    }
    else
    {
        _S522 = -1.0f;
    }
    var _S523 : f32;
    if(_S520)
    {
        _S523 = _S518.other_reach_0;
    }
    else
    {
        _S523 = _S518.reach_0;
    }
    var _S524 : f32;
    if(_S520)
    {
        _S524 = _S523 + _S518.distance_0;
    }
    else
    {
        _S524 = max(_S523 - _S518.distance_0, 0.0f);
    }
    var _S525 : f32 = _S523 / _S518.bend_1.sine_0 - _S522 * _S519.drop_0;
    var _S526 : f32 = _S524 * _S524;
    var _S527 : f32 = max(_S525 * _S525 - _S526, 9.99999968265522539e-21f);
    var _S528 : f32 = rsqrt_0(_S527);
    var _S529 : f32 = _S526 / (_S527 * _S528 + _S525);
    var _S530 : bool = _S524 > 0.0f;
    var _S531 : f32;
    if(_S513.on_top_0)
    {
        _S531 = 1.0f;
    }
    else
    {
        _S531 = -1.0f;
    }
    var _S532 : f32;
    if(_S518.near_start_0)
    {
        _S532 = 1.0f;
    }
    else
    {
        _S532 = -1.0f;
    }
    var _S533 : f32 = _S531 * _S532;
    if(_S530)
    {
        _S531 = _S525 * _S528;
    }
    else
    {
        _S531 = 1.0f;
    }
    sample_0.slope_across_0 = _S519.slope_0 * _S531;
    if(_S530)
    {
        _S524 = _S533 * _S524 * _S528;
    }
    else
    {
        _S524 = 0.0f;
    }
    sample_0.slope_along_0 = _S524;
    var _S534 : f32 = families_0[_S514].height_scale_0;
    var _S535 : vec2<f32> = dive_0(_S515, _S513, _S518, _S517);
    if(_S518.straight_0)
    {
        _S522 = 0.0f;
    }
    else
    {
        _S522 = _S534 * _S522;
    }
    sample_0.height_6 = _S522 * (_S523 * _S518.bend_1.half_tangent_0 - _S529) - _S534 * _S519.drop_0 - _S535.x;
    var _S536 : f32 = _S534 * sample_0.slope_across_0;
    var _S537 : f32 = _S534 * sample_0.slope_along_0 - _S535.y;
    if(_S513.is_warp_0)
    {
        _S522 = _S536;
    }
    else
    {
        _S522 = _S537;
    }
    sample_0.slope_x_1 = _S522;
    if(_S513.is_warp_0)
    {
        _S522 = _S537;
    }
    else
    {
        _S522 = _S536;
    }
    sample_0.slope_y_1 = _S522;
    sample_0.run_3 = _S518;
    sample_0.section_1 = _S519;
    return sample_0;
}

fn steps_per_length_0( _S538 : u32,  _S539 : SearchQuality_0,  _S540 : vec3<f32>) -> f32
{
    return max(max(abs(_S540.x) * fabrics_0[_S538].threads_per_x_0, abs(_S540.y) * fabrics_0[_S538].threads_per_y_0) * _S539.steps_per_thread_0, abs(_S540.z) * fabrics_0[_S538].per_relief_0 * _S539.steps_per_relief_0);
}

fn cell_maximum_0( _S541 : u32,  _S542 : Crossing_0) -> f32
{
    var _S543 : u32;
    if(_S542.warp_above_0)
    {
        _S543 = fabrics_0[_S541].warp_0;
    }
    else
    {
        _S543 = fabrics_0[_S541].weft_0;
    }
    var _S544 : u32;
    if(_S542.warp_above_0)
    {
        _S544 = _S542.warp_word_0;
    }
    else
    {
        _S544 = _S542.weft_word_0;
    }
    return f32((_S544 >> (u32(28)))) * families_0[_S543].height_scale_0 * families_0[_S543].level_0;
}

fn probe_0( _S545 : u32,  _S546 : f32,  _S547 : f32,  _S548 : bool,  _S549 : bool,  _S550 : bool) -> Probe_0
{
    var _S551 : Sample_0 = sample_at_0(_S545, _S546, _S547, _S548);
    var probe_1 : Probe_0;
    probe_1.height_1 = _S551.height_6;
    probe_1.hole_2 = _S551.shown_3.hole_1;
    probe_1.slope_x_0 = _S551.slope_x_1;
    probe_1.slope_y_0 = _S551.slope_y_1;
    var _S552 : u32;
    if(_S551.shown_3.is_warp_0)
    {
        _S552 = _S551.crossing_2.warp_4.thread_0 * u32(2) + u32(1);
    }
    else
    {
        _S552 = _S551.crossing_2.weft_4.thread_0 * u32(2);
    }
    probe_1.yarn_2 = _S552;
    probe_1.cell_max_0 = cell_maximum_0(_S545, _S551.crossing_2);
    var _S553 : f32;
    if(_S549)
    {
        _S553 = _S551.crossing_2.warp_4.above_0;
    }
    else
    {
        _S553 = _S551.crossing_2.warp_4.below_0;
    }
    probe_1.side_x_0 = _S553;
    if(_S550)
    {
        _S553 = _S551.crossing_2.weft_4.above_0;
    }
    else
    {
        _S553 = _S551.crossing_2.weft_4.below_0;
    }
    probe_1.side_y_0 = _S553;
    probe_1.edge_x_0 = outline_distance_0(_S551.crossing_2.warp_4, _S551.shown_3, _S551.run_3, !_S551.shown_3.is_warp_0, _S549);
    probe_1.edge_y_0 = outline_distance_0(_S551.crossing_2.weft_4, _S551.shown_3, _S551.run_3, _S551.shown_3.is_warp_0, _S550);
    return probe_1;
}

fn is_free_0( _S554 : u32,  _S555 : SearchQuality_0,  _S556 : vec3<f32>,  _S557 : vec3<f32>,  _S558 : bool,  _S559 : f32) -> bool
{
    var _S560 : f32 = _S557.z;
    if(_S560 <= 0.0f)
    {
        return false;
    }
    var _S561 : f32 = 1.0f / max(_S555.shadow_share_0 * steps_per_length_0(_S554, _S555, _S557), 9.99999971718068537e-10f);
    var _S562 : StepControl_0 = step_control_0(_S557.xy, _S561);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_3 : u32 = u32(0);
    var distance_1 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        var _S563 : bool;
        if(count_3 < u32(1024))
        {
            _S563 = (_S556.z + _S560 * distance_1) < _S559;
        }
        else
        {
            _S563 = false;
        }
        if(_S563)
        {
        }
        else
        {
            break;
        }
        var _S564 : vec3<f32> = _S556 + _S557 * vec3<f32>(distance_1);
        var _S565 : Probe_0 = probe_0(_S554, _S564.x, _S564.y, _S558, _S562.right_0, _S562.up_0);
        var _S566 : f32 = _S564.z;
        var _S567 : f32 = _S566 - _S565.height_1;
        var _S568 : f32 = _S560 - _S565.slope_x_0 * _S557.x - _S565.slope_y_0 * _S557.y;
        var _S569 : bool;
        if(!_S565.hole_2)
        {
            _S569 = _S567 < 0.0f;
        }
        else
        {
            _S569 = false;
        }
        if(_S569)
        {
            return false;
        }
        var _S570 : f32 = way_back_to_dip_0(previous_3, _S567, _S568, last_step_0, _S565);
        if(_S570 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S570;
            distance_1 = distance_1 - _S570;
            last_step_0 = last_step_1;
            count_3 = count_3 + u32(1);
            continue;
        }
        var _S571 : bool = _S566 > (_S565.cell_max_0);
        var _S572 : PreviousSample_0 = after_sample_0(_S567, _S568, _S565, _S571);
        var last_step_2 : f32;
        if(_S571)
        {
            last_step_2 = max(StepControl_to_cell_exit_0(_S562, _S565.side_x_0, _S565.side_y_0), _S561);
        }
        else
        {
            last_step_2 = StepControl_to_next_sample_0(_S562, _S565, _S567, _S568);
        }
        var distance_2 : f32 = distance_1 + last_step_2;
        previous_3 = _S572;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_3 = count_3 + u32(1);
    }
    return true;
}

fn passes_through_0( _S573 : u32,  _S574 : SearchQuality_0,  _S575 : f32,  _S576 : f32,  _S577 : vec3<f32>,  _S578 : bool) -> bool
{
    if(!sample_at_0(_S573, _S575, _S576, _S578).shown_3.hole_1)
    {
        return false;
    }
    var _S579 : vec3<f32> = vec3<f32>(_S575, _S576, 0.0f);
    var passes_0 : bool = true;
    var side_0 : u32 = u32(0);
    for(;;)
    {
        var _S580 : bool;
        if(side_0 < u32(2))
        {
            _S580 = passes_0;
        }
        else
        {
            _S580 = false;
        }
        if(_S580)
        {
        }
        else
        {
            break;
        }
        var _S581 : vec3<f32>;
        if(side_0 == u32(0))
        {
            _S581 = _S577;
        }
        else
        {
            _S581 = vec3<f32>(- _S577.x, - _S577.y, _S577.z);
        }
        var _S582 : bool = is_free_0(_S573, _S574, _S579, _S581, _S578 != (side_0 == u32(1)), fabrics_0[_S573].height_high_0);
        var _S583 : u32 = side_0 + u32(1);
        passes_0 = _S582;
        side_0 = _S583;
    }
    return passes_0;
}

struct ViewRayEnd_0
{
     height_7 : f32,
     last_step_3 : f32,
     depth_1 : f32,
     rate_4 : f32,
     smooth_0 : bool,
     previous_4 : PreviousSample_0,
};

fn max_height_along_0( _S584 : u32,  _S585 : f32,  _S586 : f32,  _S587 : f32,  _S588 : vec3<f32>,  _S589 : bool) -> f32
{
    var _S590 : u32 = locate_0(fabrics_0[_S584].warp_0, _S585).thread_0 / u32(2);
    var _S591 : u32 = locate_0(fabrics_0[_S584].weft_0, _S586).thread_0 / u32(2);
    var _S592 : f32 = _S588.x;
    var _S593 : u32;
    if(_S592 > 0.0f)
    {
        _S593 = u32(1);
    }
    else
    {
        _S593 = u32(0);
    }
    var _S594 : f32 = _S588.y;
    var _S595 : u32;
    if(_S594 > 0.0f)
    {
        _S595 = u32(2);
    }
    else
    {
        _S595 = u32(0);
    }
    var _S596 : u32 = words_0[fabrics_0[_S584].max_heights_0 + u32(4) * (_S591 * fabrics_0[_S584].max_height_columns_0 + _S590) + (_S593 + _S595)];
    var number_3 : i32;
    if(_S589)
    {
        number_3 = i32(4);
    }
    else
    {
        number_3 = i32(0);
    }
    var _S597 : u32 = (_S596 >> (u32(number_3)));
    var _S598 : f32 = max(abs(_S592) * fabrics_0[_S584].threads_per_x_0, abs(_S594) * fabrics_0[_S584].threads_per_y_0) / _S588.z;
    var _S599 : f32 = fabrics_0[_S584].height_high_0;
    var max_height_0 : f32 = fabrics_0[_S584].height_high_0;
    number_3 = i32(3);
    for(;;)
    {
        if(number_3 >= i32(0))
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S587) * _S598) <= (PYRAMID_RADII_0[number_3]))
        {
            max_height_0 = min(max_height_0, f32((((_S597 >> (u32(i32(8) * number_3)))) & (u32(15)))) * 0.06666667014360428f * _S599);
        }
        number_3 = number_3 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S600 : u32,  _S601 : f32,  _S602 : f32,  _S603 : bool,  _S604 : bool,  _S605 : bool) -> vec3<f32>
{
    var _S606 : Crossing_0 = crossing_at_0(_S600, _S601, _S602, _S603);
    var _S607 : f32 = cell_maximum_0(_S600, _S606);
    var _S608 : f32;
    if(_S604)
    {
        _S608 = _S606.warp_4.above_0;
    }
    else
    {
        _S608 = _S606.warp_4.below_0;
    }
    var _S609 : f32;
    if(_S605)
    {
        _S609 = _S606.weft_4.above_0;
    }
    else
    {
        _S609 = _S606.weft_4.below_0;
    }
    return vec3<f32>(_S607, _S608, _S609);
}

fn first_sample_height_0( _S610 : u32,  _S611 : ViewRay_0,  _S612 : StepControl_0,  _S613 : bool) -> f32
{
    var _S614 : f32 = max_height_along_0(_S610, _S611.origin_0.x, _S611.origin_0.y, 0.0f, vec3<f32>(_S611.slope_1, 1.0f), _S613);
    var count_4 : u32 = u32(0);
    var height_8 : f32 = _S614;
    for(;;)
    {
        if(count_4 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S615 : vec2<f32> = ViewRay_at_0(_S611, height_8);
        var _S616 : vec3<f32> = cell_bounds_0(_S610, _S615.x, _S615.y, _S613, _S612.right_0, _S612.up_0);
        var _S617 : f32 = height_8 - _S616.x;
        var _S618 : f32 = StepControl_to_cell_exit_0(_S612, _S616.y, _S616.z);
        var height_9 : f32 = height_8 - clamp(_S617, 0.0f, _S618);
        if(_S617 <= _S618)
        {
            height_8 = height_9;
            break;
        }
        count_4 = count_4 + u32(1);
        height_8 = height_9;
    }
    return height_8;
}

fn search_down_0( _S619 : u32,  _S620 : ViewRay_0,  _S621 : StepControl_0,  _S622 : bool) -> ViewRayEnd_0
{
    var _S623 : f32 = fabrics_0[_S619].height_low_0 - (fabrics_0[_S619].height_high_0 - fabrics_0[_S619].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_7 = first_sample_height_0(_S619, _S620, _S621, _S622);
    end_1.last_step_3 = _S621.epsilon_0;
    end_1.previous_4 = no_previous_sample_0();
    end_1.depth_1 = 0.0f;
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
        var _S624 : vec2<f32> = ViewRay_at_0(_S620, end_1.height_7);
        var _S625 : Probe_0 = probe_0(_S619, _S624.x, _S624.y, _S622, _S621.right_0, _S621.up_0);
        var _S626 : f32 = end_1.height_7 - _S625.height_1;
        var _S627 : f32 = ViewRay_rate_0(_S620, _S625);
        end_1.depth_1 = - _S626;
        end_1.rate_4 = _S627;
        var _S628 : bool;
        if(end_1.previous_4.known_0)
        {
            _S628 = !_S625.hole_2;
        }
        else
        {
            _S628 = false;
        }
        var _S629 : bool;
        if(_S628)
        {
            _S629 = (end_1.previous_4.yarn_1) == (_S625.yarn_2);
        }
        else
        {
            _S629 = false;
        }
        end_1.smooth_0 = _S629;
        var _S630 : bool;
        if(!_S625.hole_2)
        {
            _S630 = _S626 <= 0.0f;
        }
        else
        {
            _S630 = false;
        }
        var _S631 : bool;
        if(_S630)
        {
            _S631 = true;
        }
        else
        {
            _S631 = (end_1.height_7) <= _S623;
        }
        if(_S631)
        {
            break;
        }
        var _S632 : f32 = way_back_to_dip_0(end_1.previous_4, _S626, _S627, end_1.last_step_3, _S625);
        if(_S632 >= 0.0f)
        {
            end_1.height_7 = end_1.height_7 + _S632;
            end_1.last_step_3 = end_1.last_step_3 - _S632;
            count_5 = count_5 + u32(1);
            continue;
        }
        var _S633 : f32 = min(StepControl_to_cell_exit_0(_S621, _S625.side_x_0, _S625.side_y_0), end_1.height_7 - _S625.cell_max_0);
        var _S634 : f32 = StepControl_to_next_sample_0(_S621, _S625, _S626, _S627);
        end_1.previous_4 = after_sample_0(_S626, _S627, _S625, _S633 > _S634);
        var _S635 : f32 = max(_S633, _S634);
        end_1.last_step_3 = _S635;
        end_1.height_7 = end_1.height_7 - _S635;
        count_5 = count_5 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S636 : u32,  _S637 : ViewRay_0,  _S638 : StepControl_0,  _S639 : bool,  _S640 : ViewRayEnd_0,  _S641 : u32) -> f32
{
    var _S642 : f32 = fabrics_0[_S636].height_high_0 - fabrics_0[_S636].height_low_0;
    var above_2 : f32 = _S640.height_7 + _S640.last_step_3;
    var above_gap_1 : f32 = clamp(_S640.previous_4.clearance_0, 0.0f, _S642);
    var under_gap_1 : f32 = clamp(_S640.depth_1, 0.0f, _S642);
    var _S643 : f32 = cubic_root_0(above_gap_1, - under_gap_1, _S640.previous_4.rate_0 * _S640.last_step_3, _S640.rate_4 * _S640.last_step_3);
    var middle_0 : f32;
    if(_S640.smooth_0)
    {
        middle_0 = above_2 - _S643 * _S640.last_step_3;
    }
    else
    {
        middle_0 = between_0(above_2, _S640.height_7, above_gap_1, under_gap_1);
    }
    var side_1 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S640.height_7;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < _S641)
        {
        }
        else
        {
            break;
        }
        var _S644 : vec2<f32> = ViewRay_at_0(_S637, middle_0);
        var _S645 : Probe_0 = probe_0(_S636, _S644.x, _S644.y, _S639, _S638.right_0, _S638.up_0);
        var _S646 : f32;
        if(_S645.hole_2)
        {
            _S646 = -1.0e+09f;
        }
        else
        {
            _S646 = _S645.height_1;
        }
        var _S647 : f32 = clamp(middle_0 - _S646, - _S642, _S642);
        var _S648 : f32;
        if(_S647 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S648 = 0.5f * above_gap_2;
            }
            else
            {
                _S648 = above_gap_2;
            }
            var _S649 : f32 = - _S647;
            under_1 = middle_0;
            above_gap_2 = _S648;
            under_gap_2 = _S649;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S648 = 0.5f * under_gap_2;
            }
            else
            {
                _S648 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S647;
            under_gap_2 = _S648;
            side_1 = -1.0f;
        }
        if(_S640.smooth_0)
        {
            middle_0 = clamp(middle_0 + _S647 / min(ViewRay_rate_0(_S637, _S645), -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + u32(1);
    }
    if(_S640.smooth_0)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

fn first_hit_of_yarn_0( _S650 : u32,  _S651 : SearchQuality_0,  _S652 : f32,  _S653 : f32,  _S654 : vec3<f32>,  _S655 : bool) -> Hit_0
{
    var _S656 : f32 = max(_S654.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S652, _S653);
    var _S657 : vec2<f32> = _S654.xy / vec2<f32>(_S656);
    ray_0.slope_1 = _S657;
    var _S658 : StepControl_0 = step_control_0((vec2<f32>(0) - _S657), 1.0f / max(steps_per_length_0(_S650, _S651, _S654) / _S656, 9.99999971718068537e-10f));
    var _S659 : ViewRayEnd_0 = search_down_0(_S650, ray_0, _S658, _S655);
    var hit_0 : Hit_0;
    hit_0.hole_5 = false;
    var _S660 : f32 = refined_height_0(_S650, ray_0, _S658, _S655, _S659, _S651.refinements_0);
    hit_0.height_5 = _S660;
    var _S661 : vec2<f32> = ViewRay_at_0(ray_0, _S660);
    hit_0.x_11 = _S661.x;
    hit_0.y_5 = _S661.y;
    return hit_0;
}

fn first_hit_0( _S662 : u32,  _S663 : SearchQuality_0,  _S664 : f32,  _S665 : f32,  _S666 : vec3<f32>,  _S667 : bool) -> Hit_0
{
    if(!passes_through_0(_S662, _S663, _S664, _S665, _S666, _S667))
    {
        return first_hit_of_yarn_0(_S662, _S663, _S664, _S665, _S666, _S667);
    }
    var hit_1 : Hit_0;
    hit_1.x_11 = _S664;
    hit_1.y_5 = _S665;
    hit_1.height_5 = 0.0f;
    hit_1.hole_5 = true;
    return hit_1;
}

fn surface_at_0( _S668 : u32,  _S669 : f32,  _S670 : f32,  _S671 : bool) -> SurfacePoint_0
{
    var _S672 : Sample_0 = sample_at_0(_S668, _S669, _S670, _S671);
    var _S673 : f32;
    if(_S672.shown_3.is_warp_0)
    {
        _S673 = _S672.crossing_2.warp_4.half_width_1;
    }
    else
    {
        _S673 = _S672.crossing_2.weft_4.half_width_1;
    }
    var _S674 : u32;
    if(_S672.shown_3.is_warp_0)
    {
        _S674 = fabrics_0[_S668].warp_0;
    }
    else
    {
        _S674 = fabrics_0[_S668].weft_0;
    }
    var _S675 : f32 = families_0[_S674].twist_sine_0;
    var _S676 : f32;
    if(_S671)
    {
        _S676 = -1.0f;
    }
    else
    {
        _S676 = 1.0f;
    }
    var _S677 : f32 = _S675 * _S676;
    var _S678 : f32 = families_0[_S674].twist_cosine_0;
    if(_S672.shown_3.is_warp_0)
    {
        _S676 = 1.0f;
    }
    else
    {
        _S676 = -1.0f;
    }
    var _S679 : vec2<f32> = fibre_direction_0(_S672.slope_across_0, _S676 * _S672.slope_along_0, _S677, _S678);
    var _S680 : f32;
    if(_S672.shown_3.is_warp_0)
    {
        _S680 = _S672.slope_x_1;
    }
    else
    {
        _S680 = _S672.slope_y_1;
    }
    var _S681 : f32;
    if(_S672.shown_3.is_warp_0)
    {
        _S681 = _S672.slope_y_1;
    }
    else
    {
        _S681 = _S672.slope_x_1;
    }
    var _S682 : f32 = _S679.x;
    var _S683 : f32 = _S679.y;
    var _S684 : f32 = _S680 * _S682 + _S676 * _S681 * _S683;
    var _S685 : f32 = _S673 * 1.0154266357421875f;
    var _S686 : f32 = _S685 * arc_sine_0(clamp(_S672.section_1.across_3 / _S685, -1.0f, 1.0f));
    if(_S672.shown_3.is_warp_0)
    {
        _S673 = _S670;
    }
    else
    {
        _S673 = - _S669;
    }
    var point_2 : SurfacePoint_0;
    point_2.hole_3 = _S672.shown_3.hole_1;
    point_2.is_warp_1 = _S672.shown_3.is_warp_0;
    point_2.warp_thread_0 = _S672.crossing_2.warp_4.thread_0;
    point_2.weft_thread_0 = _S672.crossing_2.weft_4.thread_0;
    point_2.height_3 = _S672.height_6;
    point_2.normal_2 = normalize(vec3<f32>(- _S672.slope_x_1, - _S672.slope_y_1, 1.0f));
    var _S687 : vec3<f32>;
    if(_S672.shown_3.is_warp_0)
    {
        _S687 = vec3<f32>(_S682, _S683, _S684);
    }
    else
    {
        _S687 = vec3<f32>(- _S683, _S682, _S684);
    }
    point_2.tangent_3 = normalize(_S687);
    point_2.across_5 = _S672.section_1.across_3;
    point_2.fibre_across_0 = _S686 * _S678 + _S673 * _S677;
    point_2.fibre_along_0 = _S673 * _S678 - _S686 * _S677;
    return point_2;
}

fn has_hairs_0( _S688 : u32) -> bool
{
    var _S689 : bool;
    if((families_0[fabrics_0[_S688].warp_0].hairiness_0) > 0.0f)
    {
        _S689 = true;
    }
    else
    {
        _S689 = (families_0[fabrics_0[_S688].weft_0].hairiness_0) > 0.0f;
    }
    return _S689;
}

fn hair_at_0( _S690 : u32,  _S691 : vec2<f32>,  _S692 : bool,  _S693 : f32) -> Hair_0
{
    var _S694 : f32 = fabrics_0[_S690].fibre_size_0;
    var _S695 : f32 = 17.0f * fabrics_0[_S690].fibre_size_0;
    var _S696 : f32 = fade_0(_S693, _S695);
    var _S697 : vec2<f32> = _S691 / vec2<f32>(_S695);
    var number_4 : u32;
    if(_S692)
    {
        number_4 = u32(1);
    }
    else
    {
        number_4 = u32(0);
    }
    var _S698 : u32 = hash_key_0(number_4, ((fabrics_0[_S690].seed_1) ^ (u32(1013904242))));
    var _S699 : f32 = 1.0f / max(_S693, 0.07999999821186066f * _S694);
    var _S700 : f32 = min(0.63999998569488525f * _S694 * _S699, 1.0f);
    const _S701 : vec2<f32> = vec2<f32>(0.0f, 1.0f);
    var cover_2 : f32 = 0.0f;
    var hair_away_0 : f32 = 0.0f;
    var hair_across_0 : vec2<f32> = _S701;
    number_4 = u32(0);
    for(;;)
    {
        var _S702 : bool;
        if(_S696 > 0.0f)
        {
            _S702 = number_4 < u32(18);
        }
        else
        {
            _S702 = false;
        }
        if(_S702)
        {
        }
        else
        {
            break;
        }
        var _S703 : u32 = number_4 / u32(9);
        var _S704 : u32 = number_4 / u32(3) - u32(3) * _S703;
        var _S705 : vec2<f32> = floor(_S697) + vec2<f32>(f32(number_4 - u32(3) * _S704 - u32(9) * _S703), f32(_S704)) - vec2<f32>(1.0f);
        var _S706 : u32 = hash_bits_0(_S698 + _S703, u32(i32(_S705.x)) * u32(65536) + u32(i32(_S705.y)));
        var _S707 : u32 = hash_bits_0(_S698, _S706);
        var _S708 : vec2<f32> = _S697 - _S705 - vec2<f32>(share_of_0(_S706), share_of_0((_S706 >> (u32(10)))));
        var _S709 : vec2<f32> = sine_cosine_0(3.14159274101257324f * share_of_0((_S706 >> (u32(20)))));
        var _S710 : f32 = mix(5.0f, 16.0f, share_of_0((_S707 >> (u32(10))))) / 17.0f;
        var _S711 : f32 = _S708.x;
        var _S712 : f32 = _S709.y;
        var _S713 : f32 = _S708.y;
        var _S714 : f32 = _S709.x;
        var _S715 : f32 = (_S711 * _S712 + _S713 * _S714) / _S710;
        var _S716 : f32 = 0.69999998807907104f * (2.0f * share_of_0((_S707 >> (u32(20)))) - 1.0f);
        var _S717 : f32 = 2.0f * _S716 * _S715;
        var _S718 : f32 = rsqrt_0(_S717 * _S717 + 1.0f);
        var _S719 : f32 = (_S713 * _S712 - _S711 * _S714 - _S716 * _S710 * _S715 * _S715) * _S718 * 17.0f;
        var _S720 : f32 = clamp((0.31999999284744263f - abs(_S719)) * _S694 * _S699 + 0.5f, 0.0f, _S700);
        var _S721 : u32;
        if(((((_S707 >> (u32(30)))) & (u32(1)))) == u32(1))
        {
            _S721 = fabrics_0[_S690].warp_0;
        }
        else
        {
            _S721 = fabrics_0[_S690].weft_0;
        }
        var _S722 : bool;
        if((share_of_0(_S707)) < (families_0[_S721].hairiness_0))
        {
            _S722 = (abs(_S715)) < 1.0f;
        }
        else
        {
            _S722 = false;
        }
        var _S723 : bool;
        if(_S722)
        {
            _S723 = _S720 > cover_2;
        }
        else
        {
            _S723 = false;
        }
        if(_S723)
        {
            var _S724 : vec2<f32> = vec2<f32>(- _S714 - _S717 * _S712, _S712 - _S717 * _S714) * vec2<f32>(_S718);
            cover_2 = _S720;
            hair_away_0 = _S719;
            hair_across_0 = _S724;
        }
        number_4 = number_4 + u32(1);
    }
    var _S725 : f32 = clamp(hair_away_0 * 2.5f, -0.80000001192092896f, 0.80000001192092896f);
    var hair_1 : Hair_0;
    hair_1.cover_0 = _S696 * cover_2;
    hair_1.normal_0 = vec3<f32>(vec2<f32>(_S725) * hair_across_0, sqrt(1.0f - _S725 * _S725));
    hair_1.tangent_1 = vec3<f32>(hair_across_0.y, - hair_across_0.x, 0.0f);
    return hair_1;
}

fn varies_at_0( _S726 : u32,  _S727 : f32) -> bool
{
    var _S728 : bool;
    if((fabrics_0[_S726].fibre_noise_0) > 0.0f)
    {
        _S728 = true;
    }
    else
    {
        _S728 = (fabrics_0[_S726].colour_noise_0) > 0.0f;
    }
    if(_S728)
    {
        _S728 = true;
    }
    else
    {
        if((fabrics_0[_S726].has_detail_0) != u32(0))
        {
            _S728 = _S727 >= 0.0f;
        }
        else
        {
            _S728 = false;
        }
    }
    return _S728;
}

fn thread_number_0( _S729 : u32,  _S730 : SurfacePoint_0,  _S731 : f32,  _S732 : f32) -> u32
{
    var _S733 : f32;
    if(_S730.is_warp_1)
    {
        _S733 = _S731;
    }
    else
    {
        _S733 = _S732;
    }
    var _S734 : f32 = _S733 - _S730.across_5;
    var _S735 : u32;
    if(_S730.is_warp_1)
    {
        _S735 = fabrics_0[_S729].warp_0;
    }
    else
    {
        _S735 = fabrics_0[_S729].weft_0;
    }
    var _S736 : f32 = families_0[_S735].period_0;
    var _S737 : i32 = i32(families_0[_S735].count_0);
    if(_S730.is_warp_1)
    {
        _S735 = _S730.warp_thread_0;
    }
    else
    {
        _S735 = _S730.weft_thread_0;
    }
    var _S738 : u32 = u32(i32(floor(_S734 / _S736)) * _S737 + i32(_S735)) * u32(2);
    if(_S730.is_warp_1)
    {
        _S735 = u32(1);
    }
    else
    {
        _S735 = u32(0);
    }
    return _S738 + _S735;
}

struct FibreNoise_0
{
     bundle_0 : vec2<f32>,
     bundle_weight_0 : f32,
     fibre_0 : vec2<f32>,
     fibre_weight_0 : f32,
     offset_4 : f32,
     slope_2 : f32,
};

fn fibre_noise_at_0( _S739 : u32,  _S740 : u32,  _S741 : SurfacePoint_0,  _S742 : u32,  _S743 : f32) -> FibreNoise_0
{
    var _S744 : f32 = 5.0f * fabrics_0[_S739].fibre_size_0;
    var _S745 : vec2<f32> = wave_noise_0(hash_key_0(_S742, ((fabrics_0[_S739].seed_1) ^ (u32(458671337)))), _S741.fibre_along_0 / (25.0f * fabrics_0[_S739].fibre_size_0));
    var _S746 : f32 = _S741.fibre_across_0 + families_0[_S740].fibre_tilt_0 * 0.5f * 25.0f * fabrics_0[_S739].fibre_size_0 * _S745.x;
    var _S747 : vec3<f32> = fibre_cell_0(_S746, _S741.fibre_along_0, fabrics_0[_S739].fibre_size_0);
    var noise_0 : FibreNoise_0;
    noise_0.bundle_0 = cell_noise_0(hash_key_0(_S742, ((fabrics_0[_S739].seed_1) ^ (u32(1757159915)))), fibre_cell_0(_S746, _S741.fibre_along_0, _S744));
    noise_0.bundle_weight_0 = fade_0(_S743, _S744);
    noise_0.fibre_0 = cell_noise_0(hash_key_0(_S742, ((fabrics_0[_S739].seed_1) ^ (u32(48610963)))), _S747);
    noise_0.fibre_weight_0 = fade_0(_S743, fabrics_0[_S739].fibre_size_0);
    noise_0.offset_4 = _S747.z;
    noise_0.slope_2 = 0.5f * _S745.y;
    return noise_0;
}

fn detail_gain_0( _S748 : u32,  _S749 : u32,  _S750 : SurfacePoint_0,  _S751 : vec2<f32>,  _S752 : bool,  _S753 : u32,  _S754 : f32) -> vec2<f32>
{
    var _S755 : vec2<f32> = vec2<f32>(0.0f);
    var gain_1 : vec2<f32>;
    if((families_0[_S749].has_plies_0) > 0.0f)
    {
        gain_1 = vec2<f32>((0.60000002384185791f * fade_0(_S754, 1.0f / families_0[_S749].plies_per_mm_0))) * vec2<f32>(0.20000000298023224f - square_1(square_1(ply_offset_0(_S749, _S750, _S752))), 0.20000000298023224f);
    }
    else
    {
        gain_1 = _S755;
    }
    if((families_0[_S749].fibre_tone_0) > 0.0f)
    {
        var _S756 : FibreNoise_0 = fibre_noise_at_0(_S748, _S749, _S750, _S753, _S754);
        gain_1 = gain_1 + vec2<f32>(families_0[_S749].fibre_tone_0) * vec2<f32>(_S756.bundle_weight_0 * _S756.bundle_0.y + _S756.fibre_weight_0 * _S756.fibre_0.y, _S756.bundle_weight_0 + _S756.fibre_weight_0);
    }
    if((families_0[_S749].slub_0) > 0.0f)
    {
        var _S757 : f32 = 0.25f * families_0[_S749].slub_0 * fade_0(_S754, 1.0f / families_0[_S749].slubs_per_mm_0);
        var _S758 : f32;
        if(_S750.is_warp_1)
        {
            _S758 = _S751.y;
        }
        else
        {
            _S758 = - _S751.x;
        }
        gain_1 = gain_1 + vec2<f32>(_S757) * vec2<f32>(wave_noise_0(hash_key_0(_S753, ((fabrics_0[_S748].seed_1) ^ (u32(1373058189)))), _S758 * families_0[_S749].slubs_per_mm_0).x * mix(0.40000000596046448f, 1.0f, min(square_1(_S750.across_5 * families_0[_S749].per_half_width_0), 1.0f)), 1.0f);
    }
    return gain_1;
}

fn vary_albedos_0( _S759 : u32,  _S760 : Albedos_0,  _S761 : u32,  _S762 : u32,  _S763 : vec2<f32>) -> Albedos_0
{
    var _S764 : vec3<f32> = max(_S760.specular_reflect_0, _S760.specular_transmit_0);
    var _S765 : vec3<f32> = _S760.diffuse_reflect_0 + _S760.diffuse_transmit_0;
    var _S766 : vec3<f32> = vec3<f32>(fabrics_0[_S759].layer_bound_0);
    var _S767 : vec3<f32> = vec3<f32>(1.0f);
    var _S768 : vec3<f32> = _S767 - _S766 * _S764;
    var colour_0 : f32 = bounded_gain_0(thread_gain_0(_S761, fabrics_0[_S759].colour_noise_0, fabrics_0[_S759].seed_1), _S765, _S768);
    var _S769 : vec3<f32> = vec3<f32>((colour_0 * (1.0f + flattened_0(_S763.y, vec3<f32>(colour_0) * _S765, _S768) * _S763.x)));
    var _S770 : f32 = bounded_gain_0(fibre_gain_0(_S761, _S762, fabrics_0[_S759].fibre_noise_0, fabrics_0[_S759].seed_1), _S764, min((_S767 - _S769 * _S765) / _S766, vec3<f32>(1.0f)));
    var varied_0 : Albedos_0;
    varied_0.diffuse_reflect_0 = _S769 * _S760.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S769 * _S760.diffuse_transmit_0;
    var _S771 : vec3<f32> = vec3<f32>(_S770);
    varied_0.specular_reflect_0 = _S771 * _S760.specular_reflect_0;
    varied_0.specular_transmit_0 = _S771 * _S760.specular_transmit_0;
    return varied_0;
}

fn varied_at_0( _S772 : u32,  _S773 : SurfacePoint_0,  _S774 : Albedos_0,  _S775 : f32,  _S776 : f32,  _S777 : bool,  _S778 : f32,  _S779 : f32) -> Albedos_0
{
    var _S780 : u32 = thread_number_0(_S772, _S773, _S775, _S776);
    var _S781 : vec3<f32> = fibre_cell_0(_S773.fibre_across_0, _S773.fibre_along_0, fabrics_0[_S772].fibre_size_0);
    var _S782 : vec2<f32> = vec2<f32>(0.0f);
    var _S783 : bool;
    if((fabrics_0[_S772].has_detail_0) != u32(0))
    {
        _S783 = _S778 >= 0.0f;
    }
    else
    {
        _S783 = false;
    }
    var gain_2 : vec2<f32>;
    if(_S783)
    {
        var _S784 : u32;
        if(_S773.is_warp_1)
        {
            _S784 = fabrics_0[_S772].warp_0;
        }
        else
        {
            _S784 = fabrics_0[_S772].weft_0;
        }
        gain_2 = detail_gain_0(_S772, _S784, _S773, vec2<f32>(_S775, _S776), _S777, _S780, _S778) * vec2<f32>(1.0f - _S779, 1.0f);
    }
    else
    {
        gain_2 = _S782;
    }
    return vary_albedos_0(_S772, _S774, _S780, u32(i32(_S781.x)) * u32(65536) + u32(i32(floor(_S781.y))), gain_2);
}

fn turned_frame_0( _S785 : u32,  _S786 : u32,  _S787 : SurfacePoint_0,  _S788 : bool,  _S789 : u32,  _S790 : f32) -> YarnFrame_0
{
    var frame_2 : YarnFrame_0;
    frame_2.normal_3 = _S787.normal_2;
    frame_2.tangent_4 = _S787.tangent_3;
    frame_2.loss_0 = 0.0f;
    if((families_0[_S786].has_plies_0) > 0.0f)
    {
        var _S791 : f32 = fade_0(_S790, 1.0f / families_0[_S786].plies_per_mm_0);
        var _S792 : f32 = _S791 * 0.41999998688697815f * ply_offset_0(_S786, _S787, _S788);
        var _S793 : f32 = sqrt(1.0f - _S792 * _S792);
        var _S794 : f32;
        if(_S788)
        {
            _S794 = - families_0[_S786].ply_sine_0;
        }
        else
        {
            _S794 = families_0[_S786].ply_sine_0;
        }
        var _S795 : vec3<f32> = cross(frame_2.tangent_4, frame_2.normal_3);
        var _S796 : vec3<f32> = vec3<f32>(families_0[_S786].ply_cosine_0);
        var _S797 : vec3<f32> = _S796 * _S795 + vec3<f32>(_S794) * frame_2.tangent_4;
        var _S798 : vec3<f32> = vec3<f32>(_S793);
        var _S799 : vec3<f32> = vec3<f32>(_S792);
        frame_2.tangent_4 = _S796 * (_S796 * frame_2.tangent_4 - vec3<f32>(_S794) * _S795) + vec3<f32>(_S794) * (_S798 * _S797 - _S799 * frame_2.normal_3);
        frame_2.normal_3 = _S798 * frame_2.normal_3 + _S799 * _S797;
        frame_2.loss_0 = _S791 * _S791 * 0.41999998688697815f * 0.41999998688697815f / 6.0f;
    }
    var _S800 : f32 = families_0[_S786].fibre_tilt_0;
    if((families_0[_S786].fibre_tilt_0) > 0.0f)
    {
        var _S801 : FibreNoise_0 = fibre_noise_at_0(_S785, _S786, _S787, _S789, _S790);
        var _S802 : f32 = 1.09858846664428711f * _S800 * (_S801.bundle_weight_0 * _S801.bundle_0.x + _S801.fibre_weight_0 * (_S801.fibre_0.x + _S801.offset_4));
        var _S803 : f32 = _S800 * (1.42099642753601074f * (_S801.bundle_weight_0 * _S801.bundle_0.y + _S801.fibre_weight_0 * _S801.fibre_0.y) - _S801.bundle_weight_0 * _S801.slope_2);
        var _S804 : f32 = square_1(_S801.fibre_weight_0);
        frame_2.loss_0 = frame_2.loss_0 + 0.5f * _S800 * _S800 * ((0.24761904776096344f * (square_1(_S801.bundle_weight_0) + _S804) + _S804 / 3.0f) * 1.09858846664428711f * 1.09858846664428711f);
        var _S805 : vec3<f32> = cross(frame_2.tangent_4, frame_2.normal_3);
        var _S806 : vec2<f32> = sine_cosine_0(_S802);
        var _S807 : vec2<f32> = sine_cosine_0(_S803);
        var _S808 : vec3<f32> = vec3<f32>(_S806.y);
        var _S809 : vec3<f32> = vec3<f32>(_S806.x);
        var _S810 : vec3<f32> = _S808 * _S805 - _S809 * frame_2.normal_3;
        frame_2.normal_3 = _S808 * frame_2.normal_3 + _S809 * _S805;
        frame_2.tangent_4 = vec3<f32>(_S807.y) * frame_2.tangent_4 + vec3<f32>(_S807.x) * _S810;
    }
    return frame_2;
}

fn yarn_point_of_0( _S811 : u32,  _S812 : SurfacePoint_0,  _S813 : f32,  _S814 : f32,  _S815 : bool,  _S816 : bool,  _S817 : f32) -> YarnPoint_0
{
    var _S818 : u32;
    if(_S812.is_warp_1)
    {
        _S818 = fabrics_0[_S811].warp_0;
    }
    else
    {
        _S818 = fabrics_0[_S811].weft_0;
    }
    var _S819 : bool;
    if((fabrics_0[_S811].has_detail_0) != u32(0))
    {
        _S819 = _S817 >= 0.0f;
    }
    else
    {
        _S819 = false;
    }
    var _S820 : vec3<f32> = vec3<f32>(0.0f);
    var _S821 : Hair_0 = Hair_x24init_0(0.0f, _S820, _S820);
    var _S822 : bool;
    if(_S819)
    {
        _S822 = has_hairs_0(_S811);
    }
    else
    {
        _S822 = false;
    }
    var hair_2 : Hair_0;
    if(_S822)
    {
        hair_2 = hair_at_0(_S811, vec2<f32>(_S813, _S814), _S815, _S817);
    }
    else
    {
        hair_2 = _S821;
    }
    var _S823 : u32;
    if(_S812.is_warp_1)
    {
        _S823 = _S812.warp_thread_0;
    }
    else
    {
        _S823 = _S812.weft_thread_0;
    }
    var albedos_8 : Albedos_0 = albedos_of_0(_S818, _S823);
    var albedos_9 : Albedos_0;
    if(varies_at_0(_S811, _S817))
    {
        albedos_9 = varied_at_0(_S811, _S812, albedos_8, _S813, _S814, _S815, _S817, hair_2.cover_0);
    }
    else
    {
        albedos_9 = albedos_8;
    }
    var point_3 : YarnPoint_0;
    point_3.back_8 = _S815;
    point_3.hole_4 = _S816;
    point_3.is_warp_2 = _S812.is_warp_1;
    point_3.x_10 = _S813;
    point_3.y_4 = _S814;
    point_3.height_4 = _S812.height_3;
    point_3.normal_7 = _S812.normal_2;
    point_3.tangent_8 = _S812.tangent_3;
    point_3.surface_normal_0 = _S812.normal_2;
    point_3.diffuse_gain_1 = 1.0f;
    if(_S819)
    {
        var _S824 : YarnFrame_0 = turned_frame_0(_S811, _S818, _S812, _S815, thread_number_0(_S811, _S812, _S813, _S814), _S817);
        var frame_3 : YarnFrame_0;
        if(has_hairs_0(_S811))
        {
            frame_3 = under_hair_0(_S824, hair_2);
        }
        else
        {
            frame_3 = _S824;
        }
        point_3.normal_7 = frame_3.normal_3;
        point_3.tangent_8 = frame_3.tangent_4;
        point_3.diffuse_gain_1 = diffuse_gain_0(frame_3, fabrics_0[_S811].diffuse_blend_0);
    }
    point_3.roughness_8 = families_0[_S818].roughness_0;
    point_3.albedos_7 = albedos_9;
    return point_3;
}

fn locate_yarn_0( _S825 : u32,  _S826 : SearchQuality_0,  _S827 : f32,  _S828 : f32,  _S829 : vec3<f32>,  _S830 : f32) -> YarnPoint_0
{
    var _S831 : bool = (_S829.z) < 0.0f;
    var _S832 : Hit_0 = first_hit_0(_S825, _S826, _S827, _S828, to_face_frame_0(_S829, _S831), _S831);
    return yarn_point_of_0(_S825, surface_at_0(_S825, _S832.x_11, _S832.y_5, _S831), _S832.x_11, _S832.y_5, _S831, _S832.hole_5, _S830);
}

fn locate_yarn_1( _S833 : u32,  _S834 : SearchQuality_0,  _S835 : f32,  _S836 : f32,  _S837 : vec3<f32>) -> YarnPoint_0
{
    return locate_yarn_0(_S833, _S834, _S835, _S836, _S837, -1.0f);
}

fn residual_point_0( _S838 : u32,  _S839 : ViewedBase_0,  _S840 : vec3<f32>,  _S841 : u32,  _S842 : u32) -> ResidualPoint_0
{
    var _S843 : u32 = _S841 + _S842 * u32(1663821227);
    var _S844 : vec2<f32> = vec2<f32>(uniform_of_0(_S843, u32(1)), uniform_of_0(_S843, u32(2)));
    var _S845 : vec2<f32> = _S839.box_2.corner_1 + _S844 * _S839.box_2.size_2;
    var result_3 : ResidualPoint_0;
    result_3.point_1 = locate_yarn_1(_S838, default_quality_0(), _S845.x, _S845.y, _S840);
    var _S846 : Clustered_std430_0 = fabrics_0[_S838].clustered_0;
    var _S847 : u32 = texel_of_0(&(_S846), _S839.box_2, _S844);
    result_3.texel_0 = _S847;
    return result_3;
}

fn clustered_at_texel_0( _S848 : u32,  _S849 : ViewedBase_0,  _S850 : u32,  _S851 : BaseTaps_0) -> Components_0
{
    var _S852 : Clustered_std430_0 = fabrics_0[_S848].clustered_0;
    var _S853 : u32 = _S849.face_1 * fabrics_0[_S848].clustered_0.columns_0 * fabrics_0[_S848].clustered_0.rows_0 + _S850;
    var _S854 : u32 = table_byte_0(fabrics_0[_S848].clustered_0.labels_0, _S853);
    var base_2 : Components_0 = no_components_0();
    if(_S854 >= (fabrics_0[_S848].clustered_0.clusters_0))
    {
        return base_2;
    }
    var _S855 : f32 = cluster_density_0(_S848, _S849, _S851, _S854, u32(0));
    var number_5 : u32 = u32(1);
    var density_2 : f32 = _S855;
    for(;;)
    {
        if(number_5 <= (_S852.rank_0))
        {
        }
        else
        {
            break;
        }
        var _S856 : i32 = i32(table_byte_0(_S852.coefficients_0, _S853 * _S852.rank_0 + number_5 - u32(1)));
        var _S857 : i32;
        if(_S856 > i32(127))
        {
            _S857 = _S856 - i32(256);
        }
        else
        {
            _S857 = _S856;
        }
        var density_3 : f32 = density_2 + f32(_S857) * cluster_density_0(_S848, _S849, _S851, _S854, number_5);
        number_5 = number_5 + u32(1);
        density_2 = density_3;
    }
    return with_cluster_0(_S848, base_2, cluster_terms_0(_S848, _S849, _S851, _S854), _S854, 1.0f, density_2);
}

fn unoccluded_0( _S858 : u32,  _S859 : SearchQuality_0,  _S860 : f32,  _S861 : f32,  _S862 : f32,  _S863 : vec3<f32>,  _S864 : bool) -> bool
{
    if((_S863.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S858, _S859, vec3<f32>(_S860, _S861, _S862 + fabrics_0[_S858].lift_0), _S863, _S864, max_height_along_0(_S858, _S860, _S861, _S862, _S863, _S864));
}

fn is_lit_0( _S865 : u32,  _S866 : SearchQuality_0,  _S867 : YarnPoint_0,  _S868 : vec3<f32>) -> bool
{
    if(_S867.hole_4)
    {
        return true;
    }
    var _S869 : vec3<f32> = to_face_frame_0(_S868, _S867.back_8);
    var _S870 : f32 = _S869.z;
    var _S871 : bool = _S870 < 0.0f;
    var normal_8 : vec3<f32>;
    var height_10 : f32;
    if(_S871)
    {
        var _S872 : SurfacePoint_0 = surface_at_0(_S865, _S867.x_10, _S867.y_4, !_S867.back_8);
        normal_8 = _S872.normal_2;
        height_10 = _S872.height_3;
    }
    else
    {
        normal_8 = _S867.surface_normal_0;
        height_10 = _S867.height_4;
    }
    var _S873 : vec3<f32> = vec3<f32>(_S869.xy, abs(_S870));
    if((dot(normal_8, _S873)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S865, _S866, _S867.x_10, _S867.y_4, height_10, _S873, (_S867.back_8) != _S871);
}

fn components_of_point_0( _S874 : u32,  _S875 : SearchQuality_0,  _S876 : YarnPoint_0,  _S877 : vec3<f32>,  _S878 : vec3<f32>) -> Components_0
{
    var result_4 : Components_0 = no_components_0();
    var _S879 : f32;
    if(_S876.hole_4)
    {
        _S879 = 1.0f;
    }
    else
    {
        _S879 = 0.0f;
    }
    result_4.hole_0 = _S879;
    var _S880 : bool;
    if(_S876.hole_4)
    {
        _S880 = true;
    }
    else
    {
        _S880 = !is_lit_0(_S874, _S875, _S876, _S877);
    }
    if(_S880)
    {
        return result_4;
    }
    var _S881 : vec3<f32> = to_face_frame_0(_S877, _S876.back_8);
    var _S882 : vec3<f32> = to_face_frame_0(_S878, _S876.back_8);
    var _S883 : bool = (_S881.z) < 0.0f;
    var _S884 : vec3<f32>;
    if(_S883)
    {
        _S884 = (vec3<f32>(0) - _S881);
    }
    else
    {
        _S884 = _S881;
    }
    var _S885 : f32 = _S876.diffuse_gain_1 * diffuse_reflection_0(_S884, _S876.normal_7, fabrics_0[_S874].diffuse_blend_0);
    if(_S883)
    {
        _S879 = transmission_1(_S881, _S882, _S876.normal_7, _S876.tangent_8, _S876.roughness_8, fabrics_0[_S874].optical_depth_0);
    }
    else
    {
        _S879 = reflection_0(_S881, _S882, _S876.normal_7, _S876.tangent_8, _S876.roughness_8, fabrics_0[_S874].optical_depth_0);
    }
    var _S886 : f32;
    if(_S876.is_warp_2)
    {
        _S886 = _S885;
    }
    else
    {
        _S886 = 0.0f;
    }
    result_4.diffuse_warp_0 = _S886;
    if(_S876.is_warp_2)
    {
        _S886 = 0.0f;
    }
    else
    {
        _S886 = _S885;
    }
    result_4.diffuse_weft_0 = _S886;
    if(_S876.is_warp_2)
    {
        _S886 = _S879;
    }
    else
    {
        _S886 = 0.0f;
    }
    result_4.specular_warp_0 = _S886;
    if(_S876.is_warp_2)
    {
        _S879 = 0.0f;
    }
    result_4.specular_weft_0 = _S879;
    result_4.light_visibility_1 = 1.0f;
    return result_4;
}

fn clustered_residual_0( _S887 : u32,  _S888 : ClusteredView_0,  _S889 : ResidualPoint_0,  _S890 : vec3<f32>,  _S891 : vec3<f32>) -> vec3<f32>
{
    var _S892 : BaseTaps_0 = base_taps_0(_S888.base_0, _S891);
    var _S893 : Components_0 = clustered_at_texel_0(_S887, _S888.base_0, _S889.texel_0, _S892);
    var _S894 : Components_0 = components_of_point_0(_S887, default_quality_0(), _S889.point_1, _S891, _S888.view_11);
    var own_2 : FamilyAlbedos_0;
    var _S895 : Albedos_0 = tinted_0(_S889.point_1.albedos_7, _S890);
    own_2.warp_3 = _S895;
    own_2.weft_3 = _S895;
    return under_sheen_0(_S887, _S888, shaded_0(_S894, own_2, _S892.transmits_1) - shaded_0(_S893, _S888.albedos_5, _S892.transmits_1) - vec3<f32>(_S894.hole_0) * bounced_value_0(_S888.bounced_2, _S891, _S888.view_11), _S894.light_visibility_1 + _S894.hole_0 - _S893.light_visibility_1, _S891);
}

fn passed_by_sheen_0( _S896 : u32,  _S897 : f32,  _S898 : vec3<f32>) -> f32
{
    var _S899 : f32 = fabrics_0[_S896].sheen_strength_0;
    if((fabrics_0[_S896].sheen_strength_0) <= 0.0f)
    {
        return _S897;
    }
    return _S897 * (1.0f - _S899 * sheen_lobe_0(abs(_S898.z), fabrics_0[_S896].sheen_roughness_0).z);
}

fn clustered_value_0( _S900 : u32,  _S901 : Footprint_0,  _S902 : vec3<f32>,  _S903 : vec3<f32>,  _S904 : u32,  _S905 : u32) -> vec4<f32>
{
    var _S906 : vec3<f32> = vec3<f32>(1.0f);
    var _S907 : bool = _S905 == u32(0);
    var _S908 : ClusteredView_0 = clustered_view_0(_S900, _S901, _S903, _S906, _S904, _S907);
    var hole_6 : f32;
    if(_S907)
    {
        hole_6 = clustered_hole_0(_S900, _S908.base_0);
    }
    else
    {
        hole_6 = 0.0f;
    }
    var _S909 : vec3<f32> = clustered_base_value_0(_S900, _S908, hole_6, _S902);
    var number_6 : u32 = u32(0);
    var value_1 : vec3<f32> = _S909;
    for(;;)
    {
        if(number_6 < _S905)
        {
        }
        else
        {
            break;
        }
        var _S910 : ResidualPoint_0 = residual_point_0(_S900, _S908.base_0, _S903, _S904, number_6);
        var _S911 : f32 = f32(_S905);
        var value_2 : vec3<f32> = value_1 + clustered_residual_0(_S900, _S908, _S910, _S906, _S902) / vec3<f32>(_S911);
        var _S912 : f32;
        if(_S910.point_1.hole_4)
        {
            _S912 = 1.0f;
        }
        else
        {
            _S912 = 0.0f;
        }
        var hole_7 : f32 = hole_6 + _S912 / _S911;
        number_6 = number_6 + u32(1);
        value_1 = value_2;
        hole_6 = hole_7;
    }
    return vec4<f32>(value_1, passed_by_sheen_0(_S900, hole_6, _S903));
}

fn cloth_value_0( fabric_1 : u32,  centre_3 : vec2<f32>,  dx_2 : vec2<f32>,  dy_2 : vec2<f32>,  light_9 : vec3<f32>,  view_12 : vec3<f32>) -> vec4<f32>
{
    var _S913 : Footprint_0 = footprint_of_0(centre_3, dx_2, dy_2);
    return clustered_value_0(fabric_1, _S913, light_9, view_12, hashed_0(_S913, view_12, vec2<f32>(fabrics_0[fabric_1].clustered_0.texel_width_0 * f32(fabrics_0[fabric_1].clustered_0.columns_0), fabrics_0[fabric_1].clustered_0.texel_height_0 * f32(fabrics_0[fabric_1].clustered_0.rows_0))), u32(0));
}

fn cloth_estimate_0( fabric_2 : u32,  centre_4 : vec2<f32>,  dx_3 : vec2<f32>,  dy_3 : vec2<f32>,  light_10 : vec3<f32>,  view_13 : vec3<f32>,  seed_5 : u32) -> vec4<f32>
{
    return clustered_value_0(fabric_2, footprint_of_0(centre_4, dx_3, dy_3), light_10, view_13, mixed_0(seed_5), max(fabrics_0[fabric_2].clustered_0.samples_0, u32(1)));
}

@compute
@workgroup_size(64, 1, 1)
fn clustered_queries(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S914 : u32 = id_0.x;
    if(_S914 >= query_count_0[i32(0)])
    {
        return;
    }
    var _S915 : Query_std430_0 = queries_0[_S914];
    var _S916 : vec2<f32> = vec2<f32>(_S915.centre_x_0, _S915.centre_y_0);
    var _S917 : vec2<f32> = vec2<f32>(_S915.dx_x_0, _S915.dx_y_0);
    var _S918 : vec2<f32> = vec2<f32>(_S915.dy_x_0, _S915.dy_y_0);
    var _S919 : vec3<f32> = vec3<f32>(_S915.light_x_0, _S915.light_y_0, _S915.light_z_0);
    var _S920 : vec3<f32> = vec3<f32>(_S915.view_x_0, _S915.view_y_0, _S915.view_z_0);
    if((_S915.seed_0) == u32(0))
    {
        answers_0[_S914] = cloth_value_0(_S915.fabric_0, _S916, _S917, _S918, _S919, _S920);
    }
    else
    {
        answers_0[_S914] = cloth_estimate_0(_S915.fabric_0, _S916, _S917, _S918, _S919, _S920, _S915.seed_0);
    }
    return;
}

