using Unity.Mathematics;
using UnityEngine;

namespace Alate.Crowds
{
    /// <summary>One wing that is to be baked: its rig, and how its mesh lies in the insect.</summary>
    internal sealed class DrawnWing
    {
        private readonly float3x3 m_Axes;

        public DrawnWing(Wing wing, RiggedPart part, in Matrix4x4 toInsect)
        {
            Wing = wing;
            Selection = part.Selection;
            Rig = part.Rig;
            ToInsect = toInsect;
            Placed = new PlacedWing(toInsect, part.Rig.Frame);
            Normals = new NormalTransform(toInsect);
            m_Axes = new float3x3(Placed.span, Placed.up, Placed.forward);
        }

        public Wing Wing { get; }

        public MeshRenderer Renderer => Wing.Renderer;

        public MeshSelection Selection { get; }

        public WingRig Rig { get; }

        /// <summary>Mesh space to the insect's space.</summary>
        public Matrix4x4 ToInsect { get; }

        /// <summary>The wing's axes in the insect's space.</summary>
        public PlacedWing Placed { get; }

        /// <summary>Turns normals of the mesh to the insect's space.</summary>
        public NormalTransform Normals { get; }

        /// <summary>Writes the joints of a wing as it is now.</summary>
        /// <param name="reading">Its state.</param>
        /// <param name="wing">Its joints among those of the frame.</param>
        /// <param name="frame">Where to.</param>
        public void Write(in WingReading reading, BakedWing wing, BakedFrame frame)
        {
            for (int joint = 0; joint < wing.RestJoints.Length; joint++)
            {
                int chain = joint / wing.JointsPerChain, along = joint % wing.JointsPerChain;
                frame.Joints[wing.FirstJoint + joint] = new BakedJoint(
                    PointOf(reading.JointPosition(chain, along)), RotationOf(reading.JointRotation(chain, along)));
            }
        }

        /// <summary>A point of the wing frame in the insect's space.</summary>
        public float3 PointOf(float3 wing) => ToInsect.MultiplyPoint3x4(Rig.Frame.ToMesh(wing));

        /// <summary>A joint's rotation out of rest in the insect's space; a mirror image turns the other way.</summary>
        public quaternion RotationOf(quaternion wing) =>
            math.normalize(new quaternion(math.mul(math.mul(m_Axes, new float3x3(wing)), math.transpose(m_Axes))));
    }
}
