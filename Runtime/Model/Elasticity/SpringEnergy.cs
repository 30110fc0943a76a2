using System.Runtime.CompilerServices;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Function that the implicit step minimises (Eq. 12, 15), with its gradient and Hessian: mass against the anchor point of each joint,
    /// and the springs.
    /// </summary>
    internal static unsafe class SpringEnergy
    {
        /// <summary>F of Eq. 15 at the given positions.</summary>
        public static float4 Value(in WingPack pack, in StepScratch scratch, SoaFloat3* positions)
        {
            float4 value = default;
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
                value += 0.5f * scratch.inertia[joint] * SoaFloat3.LengthSquared(positions[joint] - scratch.anchors[joint]);
            float4 stiffness = pack.parameters->springStiffness;
            float4 hold = pack.parameters->foldStiffness;
            for (int s = 0; s < pack.rig.springCount; s++)
                value += SpringValue(pack.rig.springs[s], scratch, positions, stiffness, hold);
            return value;
        }

        // Eq. 12: E = ½ k (l − L)². And ½ hold |d − d̂|².
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static float4 SpringValue(Spring spring, in StepScratch scratch, SoaFloat3* positions, float4 stiffness, float4 hold)
        {
            SoaFloat3 difference = positions[spring.a] - positions[spring.b];
            float4 stretch = math.sqrt(math.max(SoaFloat3.LengthSquared(difference), 1e-20f)) - spring.length;
            SoaFloat3 turned = difference - scratch.targets[spring.a] + scratch.targets[spring.b];
            return 0.5f * (stiffness * stretch * stretch + hold * SoaFloat3.LengthSquared(turned));
        }

        /// <summary>Gradient and Hessian at the given positions.</summary>
        /// <param name="pack">Rig, whose springs are ordered by their first joint, and spring stiffness.</param>
        /// <param name="scratch">
        /// Anchors and inertia are read; gradient, blocks and band are written: the Hessian's rows are those of the joints that are no
        /// roots, chain by chain.
        /// </param>
        /// <param name="positions">Per joint.</param>
        /// <param name="convex">Wings whose transversal curvature is kept from going negative.</param>
        public static void Linearise(in WingPack pack, in StepScratch scratch, SoaFloat3* positions, bool4 convex)
        {
            LineariseMasses(pack, scratch, positions);
            UnsafeUtility.MemClear(scratch.band, (long)pack.rig.BandBlocks * sizeof(SoaFloat3x3));
            float4 stiffness = pack.parameters->springStiffness;
            float4 hold = pack.parameters->foldStiffness;
            float4 least = math.select(float.NegativeInfinity, 0f, convex);
            int joints = pack.rig.jointsPerChain, chain = 0, root = 0;
            for (int s = 0; s < pack.rig.springCount; s++)
            {
                Spring spring = pack.rig.springs[s];
                for (; spring.a >= root + joints; root += joints)
                    chain++;
                int across = spring.b >= root + joints ? 1 : 0;
                SymmetricBlock* first = spring.a == root ? null : scratch.blocks + spring.a - chain - 1;
                SymmetricBlock* second = spring.b == root + joints ? null : scratch.blocks + spring.b - chain - across - 1;
                SoaFloat3x3* between = first == null || second == null
                    ? null
                    : scratch.band + (spring.a - chain - 1) * joints + spring.b - across - spring.a - 1;
                AddSpring(spring, scratch, positions, stiffness, hold, least, first, second, between);
            }
        }

        private static void LineariseMasses(in WingPack pack, in StepScratch scratch, SoaFloat3* positions)
        {
            SymmetricBlock* block = scratch.blocks;
            for (int joint = 0, left = 0; joint < pack.rig.jointCount; joint++, left--)
            {
                float4 inertia = scratch.inertia[joint];
                scratch.gradient[joint] = (positions[joint] - scratch.anchors[joint]) * inertia;
                if (left == 0)
                    left = pack.rig.jointsPerChain;
                else
                    *block++ = SymmetricBlock.Diagonal(inertia);
            }
        }

        // Of Eq. 12 k [d dᵀ + (1 − L/l)(I − d dᵀ)], of what holds against folding hold·I. Negative between the joints; a root has neither
        // row nor column.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static void AddSpring(
            Spring spring, in StepScratch scratch, SoaFloat3* positions, float4 stiffness, float4 hold, float4 least,
            SymmetricBlock* first, SymmetricBlock* second, SoaFloat3x3* between)
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
            scratch.gradient[spring.a] += force;
            scratch.gradient[spring.b] -= force;

            SoaFloat3 pull = axis * axial;
            float4 xx = pull.x * axis.x + transversal, yy = pull.y * axis.y + transversal, zz = pull.z * axis.z + transversal;
            float4 xy = pull.x * axis.y, xz = pull.x * axis.z, yz = pull.y * axis.z;
            if (first != null)
                SymmetricBlock.Add(first, xx, yy, zz, xy, xz, yz);
            if (second != null)
                SymmetricBlock.Add(second, xx, yy, zz, xy, xz, yz);
            if (between != null)
                SymmetricBlock.Negate(between, xx, yy, zz, xy, xz, yz);
        }

        /// <summary>Gradient alone at the given positions.</summary>
        public static void Gradient(in WingPack pack, in StepScratch scratch, SoaFloat3* positions)
        {
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
                scratch.gradient[joint] = (positions[joint] - scratch.anchors[joint]) * scratch.inertia[joint];
            float4 stiffness = pack.parameters->springStiffness;
            float4 hold = pack.parameters->foldStiffness;
            for (int s = 0; s < pack.rig.springCount; s++)
                AddForce(pack.rig.springs[s], scratch, positions, stiffness, hold);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static void AddForce(Spring spring, in StepScratch scratch, SoaFloat3* positions, float4 stiffness, float4 hold)
        {
            SoaFloat3 difference = positions[spring.a] - positions[spring.b];
            float4 length = math.sqrt(math.max(SoaFloat3.LengthSquared(difference), 1e-20f));
            SoaFloat3 turned = difference - scratch.targets[spring.a] + scratch.targets[spring.b];
            SoaFloat3 force = difference * (stiffness * (length - spring.length) * (1f / length)) + turned * hold;
            scratch.gradient[spring.a] += force;
            scratch.gradient[spring.b] -= force;
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
