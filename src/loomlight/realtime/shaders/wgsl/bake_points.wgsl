struct Bake_std430_0
{
    @align(4) fabric_0 : u32,
    @align(4) per_family_0 : u32,
    @align(4) packs_0 : u32,
    @align(4) max_clusters_0 : u32,
    @align(4) rays_0 : u32,
    @align(4) ends_0 : f32,
    @align(4) picks_0 : f32,
    @align(4) spacing_x_0 : f32,
    @align(4) spacing_y_0 : f32,
    @align(4) columns_0 : u32,
    @align(4) rows_0 : u32,
    @align(4) face_nodes_0 : u32,
    @align(4) texels_across_0 : u32,
    @align(4) texels_along_0 : u32,
    @align(4) texel_x_0 : f32,
    @align(4) texel_y_0 : f32,
    @align(4) far_weight_0 : f32,
    @align(4) moments_table_0 : u32,
    @align(4) record_warp_packs_0 : u32,
    @align(4) record_hole_weights_0 : u32,
    @align(4) facts_0 : u32,
    @align(4) gaps_0 : u32,
    @align(4) gap_nulls_0 : u32,
    @align(4) lit_0 : u32,
    @align(4) lists_0 : u32,
    @align(4) points_0 : u32,
    @align(4) clusters_0 : u32,
    @align(4) cluster_means_0 : u32,
    @align(4) cluster_errors_0 : u32,
    @align(4) centroids_0 : u32,
    @align(4) view_sums_0 : u32,
    @align(4) light_sums_0 : u32,
    @align(4) group_moments_0 : u32,
    @align(4) areas_0 : u32,
    @align(4) area_scales_0 : u32,
    @align(4) row_totals_0 : u32,
    @align(4) row_largest_0 : u32,
    @align(4) coverage_means_0 : u32,
    @align(4) coverage_scales_0 : u32,
    @align(4) hole_bytes_0 : u32,
};

@binding(15) @group(0) var<storage, read> bakes_0 : array<Bake_std430_0>;

struct SurfaceHit_std430_0
{
    @align(4) x_0 : f32,
    @align(4) y_0 : f32,
    @align(4) flags_0 : u32,
    @align(4) normal_x_0 : f32,
    @align(4) normal_y_0 : f32,
    @align(4) normal_z_0 : f32,
    @align(4) tangent_x_0 : f32,
    @align(4) tangent_y_0 : f32,
    @align(4) tangent_z_0 : f32,
};

@binding(17) @group(0) var<storage, read_write> hits_0 : array<SurfaceHit_std430_0>;

@binding(18) @group(0) var<storage, read_write> scratch_0 : array<u32>;

var<workgroup> offsets_0 : array<u32, i32(256)>;

fn sample_index_0( _S1 : i32,  _S2 : u32,  _S3 : bool,  _S4 : u32) -> u32
{
    var _S5 : u32 = _S2 % u32(4) / u32(2);
    if(_S3)
    {
        return (_S5 * u32(256) + _S4 / u32(32)) * bakes_0[_S1].rays_0 + _S4 % u32(32) * (bakes_0[_S1].rays_0 / u32(32));
    }
    return u32(512) * bakes_0[_S1].rays_0 + _S5 * u32(8192) + _S4;
}

fn is_member_0( _S6 : i32,  _S7 : ptr<function, SurfaceHit_std430_0>,  _S8 : u32,  _S9 : bool) -> bool
{
    var _S10 : u32 = (*_S7).flags_0;
    var _S11 : bool;
    if(((((*_S7).flags_0) & (u32(2)))) != u32(0))
    {
        _S11 = true;
    }
    else
    {
        if(_S9)
        {
            _S11 = ((_S10 & (u32(4)))) != u32(0);
        }
        else
        {
            _S11 = false;
        }
    }
    if(_S8 == u32(4))
    {
        return _S11;
    }
    if(!_S11)
    {
        _S11 = (((_S10 & (u32(1)))) != u32(0)) == ((_S8 % u32(2)) == u32(0));
    }
    else
    {
        _S11 = false;
    }
    return _S11;
}

fn compact_0( _S12 : i32,  _S13 : u32,  _S14 : u32,  _S15 : bool) -> u32
{
    var other_0 : u32;
    var i_0 : u32 = u32(0);
    var count_0 : u32 = u32(0);
    for(;;)
    {
        if(i_0 < u32(32))
        {
        }
        else
        {
            break;
        }
        var _S16 : SurfaceHit_std430_0 = hits_0[sample_index_0(_S12, _S13, _S15, _S14 * u32(32) + i_0)];
        var _S17 : bool = is_member_0(_S12, &(_S16), _S13, _S15);
        if(_S17)
        {
            other_0 = u32(1);
        }
        else
        {
            other_0 = u32(0);
        }
        var count_1 : u32 = count_0 + other_0;
        i_0 = i_0 + u32(1);
        count_0 = count_1;
    }
    offsets_0[_S14] = count_0;
    storageBarrier(); textureBarrier(); workgroupBarrier();;
    other_0 = u32(0);
    var before_0 : u32 = u32(0);
    var total_0 : u32 = u32(0);
    for(;;)
    {
        if(other_0 < u32(256))
        {
        }
        else
        {
            break;
        }
        if(other_0 < _S14)
        {
            i_0 = offsets_0[other_0];
        }
        else
        {
            i_0 = u32(0);
        }
        var before_1 : u32 = before_0 + i_0;
        var total_1 : u32 = total_0 + offsets_0[other_0];
        other_0 = other_0 + u32(1);
        before_0 = before_1;
        total_0 = total_1;
    }
    i_0 = u32(0);
    for(;;)
    {
        if(i_0 < u32(32))
        {
        }
        else
        {
            break;
        }
        var _S18 : u32 = sample_index_0(_S12, _S13, _S15, _S14 * u32(32) + i_0);
        var _S19 : SurfaceHit_std430_0 = hits_0[_S18];
        var _S20 : bool = is_member_0(_S12, &(_S19), _S13, _S15);
        if(_S20)
        {
            scratch_0[bakes_0[_S12].lists_0 + _S13 * u32(8192) + before_0] = _S18;
            before_0 = before_0 + u32(1);
        }
        i_0 = i_0 + u32(1);
    }
    storageBarrier(); textureBarrier(); workgroupBarrier();;
    return total_0;
}

@compute
@workgroup_size(256, 1, 1)
fn bake_gaps(@builtin(local_invocation_id) thread_0 : vec3<u32>)
{
    var _S21 : u32 = thread_0.x;
    var _S22 : u32 = compact_0(i32(0), u32(4), _S21, false);
    var _S23 : u32 = max(_S22 / u32(128), u32(1));
    var _S24 : u32 = (_S22 + _S23 - u32(1)) / _S23;
    var _S25 : u32 = min(_S24, u32(128));
    var i_1 : u32 = _S21;
    for(;;)
    {
        if(i_1 < _S25)
        {
        }
        else
        {
            break;
        }
        var _S26 : SurfaceHit_std430_0 = hits_0[scratch_0[bakes_0[i32(0)].lists_0 + u32(32768) + i_1 * _S23]];
        var _S27 : u32 = bakes_0[i32(0)].gaps_0 + u32(2) * i_1;
        scratch_0[_S27] = (bitcast<u32>((hits_0[scratch_0[bakes_0[i32(0)].lists_0 + u32(32768) + i_1 * _S23]].x_0)));
        scratch_0[_S27 + u32(1)] = (bitcast<u32>((_S26.y_0)));
        i_1 = i_1 + u32(256);
    }
    if(_S21 == u32(0))
    {
        var _S28 : u32 = bakes_0[i32(0)].facts_0;
        scratch_0[bakes_0[i32(0)].facts_0 + u32(8)] = _S22;
        scratch_0[_S28 + u32(9)] = _S25;
    }
    return;
}

fn thinned_0( number_0 : u32,  size_0 : u32) -> u32
{
    if(size_0 <= u32(2048))
    {
        return min(number_0, max(size_0, u32(1)) - u32(1));
    }
    var _S29 : u32 = number_0 * u32(2654435769);
    return ((((_S29 >> (u32(16)))) * size_0 + (((((_S29 & (u32(65535)))) * size_0) >> (u32(16))))) >> (u32(16)));
}

fn hit_normal_0( hit_0 : ptr<function, SurfaceHit_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*hit_0).normal_x_0, (*hit_0).normal_y_0, (*hit_0).normal_z_0);
}

fn hit_tangent_0( hit_1 : ptr<function, SurfaceHit_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*hit_1).tangent_x_0, (*hit_1).tangent_y_0, (*hit_1).tangent_z_0);
}

fn point_row_0( _S30 : i32,  _S31 : u32,  _S32 : u32) -> u32
{
    return bakes_0[_S30].points_0 + (_S31 * u32(2048) + _S32) * u32(6);
}

@compute
@workgroup_size(256, 1, 1)
fn bake_points(@builtin(workgroup_id) group_0 : vec3<u32>, @builtin(local_invocation_id) thread_1 : vec3<u32>)
{
    var _S33 : u32 = group_0.x;
    var _S34 : u32 = thread_1.x;
    var _S35 : u32 = bakes_0[i32(0)].lists_0 + _S33 * u32(8192);
    var _S36 : u32 = compact_0(i32(0), _S33, _S34, false);
    var from_top_0 : array<u32, i32(8)>;
    var i_2 : u32 = u32(0);
    for(;;)
    {
        if(i_2 < u32(8))
        {
        }
        else
        {
            break;
        }
        from_top_0[i_2] = scratch_0[_S35 + thinned_0(_S34 * u32(8) + i_2, _S36)];
        i_2 = i_2 + u32(1);
    }
    storageBarrier(); textureBarrier(); workgroupBarrier();;
    var _S37 : u32 = compact_0(i32(0), _S33, _S34, true);
    var _S38 : bool;
    if(_S36 > u32(0))
    {
        _S38 = _S37 >= u32(64);
    }
    else
    {
        _S38 = false;
    }
    if(_S38)
    {
        i_2 = _S37;
    }
    else
    {
        i_2 = _S36;
    }
    var i_3 : u32 = u32(0);
    for(;;)
    {
        if(i_3 < u32(8))
        {
        }
        else
        {
            break;
        }
        var _S39 : u32 = _S34 * u32(8) + i_3;
        if(_S39 < i_2)
        {
            var _S40 : u32;
            if(_S38)
            {
                _S40 = scratch_0[_S35 + thinned_0(_S39, _S37)];
            }
            else
            {
                _S40 = from_top_0[i_3];
            }
            var _S41 : SurfaceHit_std430_0 = hits_0[_S40];
            var _S42 : u32 = point_row_0(i32(0), _S33, _S39);
            var _S43 : vec3<f32> = hit_normal_0(&(_S41));
            var _S44 : vec3<f32> = vec3<f32>(10000.0f);
            var _S45 : vec3<f32> = round(vec3<f32>(0.5f) * _S43 * _S44);
            var _S46 : vec3<f32> = hit_tangent_0(&(_S41));
            var _S47 : vec3<f32> = round(_S46 * _S44);
            var k_0 : u32 = u32(0);
            for(;;)
            {
                if(k_0 < u32(3))
                {
                }
                else
                {
                    break;
                }
                scratch_0[_S42 + k_0] = (bitcast<u32>((_S45[k_0])));
                scratch_0[_S42 + u32(3) + k_0] = (bitcast<u32>((_S47[k_0])));
                k_0 = k_0 + u32(1);
            }
        }
        i_3 = i_3 + u32(1);
    }
    if(_S34 == u32(0))
    {
        var _S48 : u32 = bakes_0[i32(0)].facts_0;
        scratch_0[bakes_0[i32(0)].facts_0 + _S33] = _S37;
        scratch_0[_S48 + u32(4) + _S33] = min(i_2, u32(2048));
    }
    return;
}

