using Unity.Mathematics;

namespace Alate.Crowds
{
    /// <summary>Sphere around a baked insect in all its frames, in its own space.</summary>
    internal struct CrowdShape
    {
        /// <summary>Middle of the sphere.</summary>
        public float3 centre;

        /// <summary>Radius of the sphere.</summary>
        public float radius;

        /// <summary>Middle and radius of the sphere of a placed insect, world; 0 for one without a size or a place.</summary>
        public float4 Around(in CrowdPose pose)
        {
            float3 middle = pose.position + math.rotate(pose.rotation, centre * pose.scale);
            float reach = radius * math.abs(pose.scale);
            return reach > 0f && math.all(math.isfinite(middle)) ? new float4(middle, reach) : float4.zero;
        }
    }
}
