using Unity.Mathematics;

namespace Alate.Crowds
{
    /// <summary>Space that a camera sees of a crowd, and that from which insects cast shadows into its picture.</summary>
    internal struct CrowdView
    {
        /// <summary>Eye, world.</summary>
        public float3 eye;

        /// <summary>Direction of sight, of length 1.</summary>
        public float3 ahead;

        /// <summary>World units across half the picture's height at a distance of one; 0 for a camera without perspective.</summary>
        public float halfHeight;

        /// <summary>World units of half the picture's height without perspective.</summary>
        public float flatHeight;

        /// <summary>Space that is seen, by the left eye where there are two.</summary>
        public CrowdFrustum frustum;

        /// <summary>Space that the right eye sees where <see cref="isStereo"/>.</summary>
        public CrowdFrustum rightFrustum;

        /// <summary>True for a camera of two eyes.</summary>
        public bool isStereo;

        /// <summary>Way of a shadow through the scene, world units; 0 where insects cast none or their light is not known.</summary>
        public float3 shadow;

        /// <summary>Distance from the eye within which everything counts as seen, world units.</summary>
        public float around;

        /// <summary>Returns true where an insect is in the picture, or may cast a shadow into it.</summary>
        /// <param name="sphere">Middle and radius of a sphere around it, world; none of radius 0 is seen.</param>
        public bool Sees(float4 sphere)
        {
            float reach = around + sphere.w;
            return sphere.w > 0f
                && (frustum.MayMeet(sphere, shadow)
                    || (isStereo && rightFrustum.MayMeet(sphere, shadow))
                    || (around > 0f && math.distancesq(eye, sphere.xyz) < reach * reach));
        }

        /// <summary>Height of a sphere in the picture, as a share of it.</summary>
        /// <param name="sphere">Its middle and radius, world.</param>
        public float HeightOf(float4 sphere) => sphere.w / (flatHeight + halfHeight * math.distance(eye, sphere.xyz));
    }
}
