using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Eq. 9–11 over the whole wing: the surface of the last substep is carried along with the driven motion, each patch meets the
    /// air, and its load goes to the four joints of its cell. A patch is a point (u, v) of its cell, so what varies over a cell is a
    /// small polynomial whose coefficients are made once a cell.
    /// </summary>
    internal static unsafe class Aerodynamics
    {
        /// <summary>Adds the air's forces and damping to the joints' and returns the force on the whole wing.</summary>
        public static SoaFloat3 Apply(in WingPack pack, in StepScratch scratch)
        {
            Carry(pack, scratch);
            PatchLoad* loads = pack.recordedLoads != null ? pack.recordedLoads : scratch.loads;
            SoaFloat3 total = default;
            CellMotion motion;
            CellSheet sheet;
            int bonesPerChain = pack.rig.jointsPerChain - 1;
            for (int cell = 0; cell < pack.rig.cellCount; cell++)
            {
                PatchCell* patches = pack.rig.patchCells + cell;
                if (patches->patchCount == 0)
                    continue;
                int joint = cell / bonesPerChain * pack.rig.jointsPerChain + cell % bonesPerChain;
                CellMotion.Fill(&motion, pack, scratch, *patches, joint);
                MeetAir(pack, scratch, patches, &motion);
                CellSheet.Fill(&sheet, pack, scratch, joint);
                Normals(pack, scratch, patches, &sheet);
                Forces(pack, scratch, patches, loads);
                total += Distribute(pack, scratch, patches, joint, loads);
            }

            return total;
        }

        // Joint frames and positions moved on by what the driven pose has moved since the last substep.
        private static void Carry(in WingPack pack, in StepScratch scratch)
        {
            int joints = pack.rig.jointsPerChain;
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                int i = joint / joints;
                int bone = i * (joints - 1) + math.min(joint - i * joints, joints - 2);
                SoaQuaternion turned = scratch.drivenRotations[bone] * SoaQuaternion.Conjugate(pack.drivenRotations[bone]);
                scratch.carriedFrames[joint] = new SoaFloat3x3(turned * pack.pose[joint].rotation);
                scratch.carriedPositions[joint] =
                    pack.pose[joint].position + scratch.drivenPositions[joint] - pack.drivenPositions[joint];
            }
        }

        private static void MeetAir(in WingPack pack, in StepScratch scratch, PatchCell* cell, CellMotion* motion)
        {
            SoaFloat3 wind = pack.surroundings->wind;
            int end = cell->firstPatch + cell->patchCount;
            for (int patch = cell->firstPatch; patch < end; patch++)
            {
                scratch.relativeWind[patch] = wind - CellMotion.At(
                    motion, pack.rig.patchU[patch], pack.rig.patchV[patch], pack.rig.patchSpan[patch], pack.rig.patchChord[patch]);
            }
        }

        private static void Normals(in WingPack pack, in StepScratch scratch, PatchCell* cell, CellSheet* sheet)
        {
            bool keepSpan = pack.options.tangent == AirTangent.BaseToTip;
            int end = cell->firstPatch + cell->patchCount;
            for (int patch = cell->firstPatch; patch < end; patch++)
            {
                float4 u = pack.rig.patchU[patch], v = pack.rig.patchV[patch];
                SoaFloat3 normal = SoaFloat3.NormalizeSafe(CellSheet.NormalAt(sheet, u, v));
                SoaFloat3 span = BilinearField.At(&sheet->span, u, v);
                span -= normal * SoaFloat3.Dot(span, normal);
                SoaFloat3 wind = scratch.relativeWind[patch];
                scratch.normals[patch] = normal;
                if (keepSpan)
                    scratch.alongSpan[patch] = math.abs(SoaFloat3.Dot(wind, SoaFloat3.NormalizeSafe(span)));
                else
                    scratch.relativeWind[patch] = PatchAir.WithoutSpan(wind, span);
            }
        }

        private static void Forces(in WingPack pack, in StepScratch scratch, PatchCell* cell, PatchLoad* loads)
        {
            float4 halfDensity = 0.5f * pack.parameters->airDensity;
            int end = cell->firstPatch + cell->patchCount;
            for (int patch = cell->firstPatch; patch < end; patch++)
            {
                loads[patch] = PatchAir.Load(
                    pack.options, scratch.relativeWind[patch], scratch.normals[patch], scratch.alongSpan[patch],
                    halfDensity * pack.rig.patchAreas[patch]);
            }
        }

        // Weighted sums of the loads, then once a cell to its joints: the weights of a patch are (1−u)(1−v), (1−u)v, u(1−v), uv.
        private static SoaFloat3 Distribute(in WingPack pack, in StepScratch scratch, PatchCell* cell, int joint, PatchLoad* loads)
        {
            SoaFloat3 f = default, fu = default, fv = default, fuv = default;
            float4 b = default, bu = default, bv = default, buv = default;
            int end = cell->firstPatch + cell->patchCount;
            for (int patch = cell->firstPatch; patch < end; patch++)
            {
                float4 u = pack.rig.patchU[patch], v = pack.rig.patchV[patch], uv = u * v;
                SoaFloat3 force = loads[patch].force;
                float4 damping = loads[patch].damping;
                f += force;
                fu += force * u;
                fv += force * v;
                fuv += force * uv;
                b += damping;
                bu += damping * u;
                bv += damping * v;
                buv += damping * uv;
            }

            int next = joint + pack.rig.jointsPerChain;
            Add(scratch, joint, f - fu - fv + fuv, b - bu - bv + buv);
            Add(scratch, joint + 1, fv - fuv, bv - buv);
            Add(scratch, next, fu - fuv, bu - buv);
            Add(scratch, next + 1, fuv, buv);
            return f;
        }

        private static void Add(in StepScratch scratch, int joint, SoaFloat3 force, float4 damping)
        {
            scratch.forces[joint] += force;
            scratch.airDamping[joint] += damping;
        }
    }
}
