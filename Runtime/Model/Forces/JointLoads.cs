using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Evaluates all forces on the joints: inertia of the beat (Eq. 5, 8), gravity, air (Eq. 9–11), and their torques (Eq. 4).
    /// </summary>
    internal static unsafe class JointLoads
    {
        /// <summary>Fills forces, those of the air alone, airDamping and torques.</summary>
        public static void Evaluate(in WingPack pack, in StepScratch scratch, in ImplicitStep step)
        {
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                scratch.forces[joint] = default;
                scratch.airDamping[joint] = default;
                if (pack.recordedLoads != null)
                    pack.RecordedJointForces[joint] = default;
            }

            Aerodynamics.Apply(pack, scratch);
            if (pack.options.addedMass)
                AddedMass.Apply(pack, scratch, step);
            AddInertiaAndGravity(pack, scratch);
            if (pack.options.torqueArm == TorqueArm.OwnLoadAboutRoot)
                TorquesAboutRoot(pack, scratch);
            else
                TorquesOfDistalJoints(pack, scratch);
        }

        // Eq. 5, 8 in the wing's own frame: the load of the driven motion, −κ m a; and m g of Eq. 4.
        private static void AddInertiaAndGravity(in WingPack pack, in StepScratch scratch)
        {
            SoaFloat3 gravity = pack.surroundings->gravity;
            float4 inertia = pack.parameters->numbers.inertia;
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                float4 mass = pack.rig.jointMasses[joint];
                scratch.airForces[joint] = scratch.forces[joint];
                scratch.forces[joint] += (gravity - scratch.drivenAccelerations[joint] * inertia) * mass;
            }
        }

        // Eq. 4 on the carried positions; the printed scheme takes those of the last substep.
        private static SoaFloat3* Arms(in WingPack pack, in StepScratch scratch)
        {
            if (pack.options.timeScheme != TimeScheme.BackwardEuler)
                return scratch.carriedPositions;
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
                scratch.arms[joint] = pack.pose[joint].position;
            return scratch.arms;
        }

        // Eq. 4 over all loads further out on the chain, about the joint that bends: Σ (r_k − r_j) × F_k.
        private static void TorquesOfDistalJoints(in WingPack pack, in StepScratch scratch)
        {
            SoaFloat3* r = Arms(pack, scratch);
            int joints = pack.rig.jointsPerChain;
            for (int i = 0; i < pack.rig.chainCount; i++)
            {
                SoaFloat3 force = default, moment = default;
                for (int j = joints - 1; j > 0; j--)
                {
                    int joint = i * joints + j;
                    force += scratch.forces[joint];
                    moment += SoaFloat3.Cross(r[joint], scratch.forces[joint]);
                    scratch.torques[joint - 1 - i] = moment - SoaFloat3.Cross(r[joint - 1], force);
                }
            }
        }

        // Eq. 4 as printed: the joint's own load on the arm between the joint and its chain's root.
        private static void TorquesAboutRoot(in WingPack pack, in StepScratch scratch)
        {
            SoaFloat3* r = Arms(pack, scratch);
            int joints = pack.rig.jointsPerChain;
            for (int i = 0; i < pack.rig.chainCount; i++)
            {
                SoaFloat3 root = r[i * joints];
                for (int j = 0; j < joints - 1; j++)
                {
                    int joint = i * joints + j;
                    scratch.torques[joint - i] = SoaFloat3.Cross(r[joint] - root, scratch.forces[joint]);
                }
            }
        }
    }
}
