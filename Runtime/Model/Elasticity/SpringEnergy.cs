using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Function that the implicit step minimises (Eq. 12, 15), with its gradient and Hessian: mass against the anchor point of each joint,
    /// and the springs.
    /// </summary>
    internal static unsafe class SpringEnergy
    {
        /// <summary>Value, gradient, diagonal blocks and spring linearisations at the given positions.</summary>
        /// <param name="pack">Rig and spring stiffness.</param>
        /// <param name="scratch">Anchors and inertia are read; gradient, blocks and springs are written.</param>
        /// <param name="positions">Per joint.</param>
        /// <param name="convex">Wings whose transversal curvature is kept from going negative.</param>
        /// <returns>F of Eq. 15.</returns>
        public static float4 Linearise(in WingPack pack, in StepScratch scratch, SoaFloat3* positions, bool4 convex)
        {
            float4 value = default;
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                float4 inertia = scratch.inertia[joint];
                SoaFloat3 offset = positions[joint] - scratch.anchors[joint];
                scratch.gradient[joint] = offset * inertia;
                scratch.blocks[joint] = SymmetricBlock.Diagonal(inertia);
                value += 0.5f * inertia * SoaFloat3.LengthSquared(offset);
            }

            float4 stiffness = pack.parameters->springStiffness;
            float4 hold = pack.parameters->foldStiffness;
            float4 least = math.select(float.NegativeInfinity, 0f, convex);
            for (int s = 0; s < pack.rig.springCount; s++)
                value += AddSpring(pack.rig.springs[s], scratch, positions, stiffness, hold, least, scratch.springs + s);
            return value;
        }

        // Eq. 12: E = ½ k (l − L)²; Hessian k [d dᵀ + (1 − L/l)(I − d dᵀ)]. And ½ hold |d − d̂|²: its Hessian is hold·I.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static float4 AddSpring(
            Spring spring, in StepScratch scratch, SoaFloat3* positions, float4 stiffness, float4 hold, float4 least,
            SpringLinearisation* linear)
        {
            SoaFloat3 difference = positions[spring.a] - positions[spring.b];
            float4 length = math.sqrt(math.max(SoaFloat3.LengthSquared(difference), 1e-20f));
            float4 inverse = 1f / length;
            SoaFloat3 axis = difference * inverse;
            float4 stretch = length - spring.length;
            SoaFloat3 turned = difference - scratch.targets[spring.a] + scratch.targets[spring.b];
            float4 transversal = math.max(stiffness * stretch * inverse, least) + hold;
            float4 axial = stiffness + hold - transversal;
            SoaFloat3 force = axis * (stiffness * stretch) + turned * hold;

            linear->axis = axis;
            linear->axial = axial;
            linear->transversal = transversal;
            scratch.gradient[spring.a] += force;
            scratch.gradient[spring.b] -= force;
            SymmetricBlock.AddSpring(scratch.blocks + spring.a, axis, axial, transversal);
            SymmetricBlock.AddSpring(scratch.blocks + spring.b, axis, axial, transversal);
            return 0.5f * (stiffness * stretch * stretch + hold * SoaFloat3.LengthSquared(turned));
        }

        /// <summary>Elastic energy of the springs alone (Eq. 12), wing mass · L²/s².</summary>
        /// <param name="pack">Rig and spring stiffness.</param>
        /// <param name="pose">[joint]</param>
        /// <param name="largest">Largest |l/L − 1| of any spring.</param>
        public static float4 Elastic(in WingPack pack, JointPose* pose, out float4 largest)
        {
            float4 sum = default;
            largest = default;
            for (int s = 0; s < pack.rig.springCount; s++)
            {
                Spring spring = pack.rig.springs[s];
                float4 stretch = math.sqrt(SoaFloat3.LengthSquared(pose[spring.a].position - pose[spring.b].position)) - spring.length;
                sum += stretch * stretch;
                largest = math.max(largest, math.abs(stretch) * (1f / spring.length));
            }

            return 0.5f * pack.parameters->springStiffness * sum;
        }
    }
}
