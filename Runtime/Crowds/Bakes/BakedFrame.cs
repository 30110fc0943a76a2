using Unity.Mathematics;

namespace Alate.Crowds
{
    /// <summary>An insect at one phase of a clip, in its own space.</summary>
    public sealed class BakedFrame
    {
        internal BakedFrame(int vertices, int joints)
        {
            Positions = new float3[vertices];
            Normals = new float3[vertices];
            Joints = new BakedJoint[joints];
        }

        /// <summary>[vertex] Position.</summary>
        public float3[] Positions { get; }

        /// <summary>[vertex] Unit normal.</summary>
        public float3[] Normals { get; }

        /// <summary>[joint of all wings, then of abdomens] Position, and rotation out of the rest pose.</summary>
        public BakedJoint[] Joints { get; }
    }
}
