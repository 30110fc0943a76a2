using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Eq. 9–11 over the whole wing: the surface of the last substep is carried along with the driven motion, each patch meets the
    /// air, and its load goes to the four joints of its cell. A patch is a point (u, v) of its cell, so what varies over a cell is
    /// bilinear: four coefficients per quantity, made once a cell.
    /// </summary>
    internal static unsafe class Aerodynamics
    {
        /// <summary>Adds the air's forces and damping to the joints' and returns the force on the whole wing.</summary>
        public static SoaFloat3 Apply(in WingPack pack, in StepScratch scratch)
        {
            CarryFrames(pack, scratch);
            PatchLoad* loads = pack.recordedLoads != null ? pack.recordedLoads : scratch.loads;
            SoaFloat3 total = default;
            CellField field;
            int bonesPerChain = pack.rig.jointsPerChain - 1;
            for (int cell = 0; cell < pack.rig.cellCount; cell++)
            {
                PatchCell* patches = pack.rig.patchCells + cell;
                if (patches->patchCount == 0)
                    continue;
                int joint = cell / bonesPerChain * pack.rig.jointsPerChain + cell % bonesPerChain;
                Velocities(pack, scratch, patches, joint, &field);
                MeetAir(pack, scratch, patches, &field);
                Frames(pack, scratch, patches, joint, &field);
                Normals(pack, scratch, patches, &field);
                Forces(pack, scratch, patches, loads);
                total += Distribute(pack, scratch, patches, joint, loads);
            }

            return total;
        }

        /// <summary>Bilinear field over a cell: value(u, v) = c + u·cu + v·(cv + u·cuv), for up to three vectors at once.</summary>
        private struct CellField
        {
            public Bilinear a;
            public Bilinear b;
            public Bilinear c;
        }

        private struct Bilinear
        {
            public SoaFloat3 c;
            public SoaFloat3 cu;
            public SoaFloat3 cv;
            public SoaFloat3 cuv;

            public void Set(SoaFloat3 at00, SoaFloat3 at01, SoaFloat3 at10, SoaFloat3 at11)
            {
                c = at00;
                cu = at10 - at00;
                cv = at01 - at00;
                cuv = at11 - at10 - cv;
            }

            [MethodImpl(MethodImplOptions.AggressiveInlining)]
            public static SoaFloat3 At(Bilinear* f, float4 u, float4 v) => f->c + f->cu * u + (f->cv + f->cuv * u) * v;
        }

        // Joint frames turned on by what the driven rotation turned since the last substep.
        private static void CarryFrames(in WingPack pack, in StepScratch scratch)
        {
            JointPose* poses = pack.pose;
            int joints = pack.rig.jointsPerChain;
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                int i = joint / joints;
                int bone = i * (joints - 1) + math.min(joint - i * joints, joints - 2);
                SoaQuaternion turned = scratch.drivenRotations[bone] * SoaQuaternion.Conjugate(pack.drivenRotations[bone]);
                scratch.carriedFrames[joint] = new SoaFloat3x3(turned * poses[joint].rotation);
            }
        }

        // Velocity of the surface at the cell's origin and its slopes along the cell's span and chord.
        private static void Velocities(in WingPack pack, in StepScratch scratch, PatchCell* cell, int joint, CellField* field)
        {
            int next = joint + pack.rig.jointsPerChain;
            field->a.Set(VelocityAt(pack, scratch, joint, cell->origin), VelocityAt(pack, scratch, joint + 1, cell->origin),
                VelocityAt(pack, scratch, next, cell->origin), VelocityAt(pack, scratch, next + 1, cell->origin));
            JointMotion* m = pack.motions;
            field->b.Set(SoaFloat3x3.Mul(m[joint].rate, cell->span), SoaFloat3x3.Mul(m[joint + 1].rate, cell->span),
                SoaFloat3x3.Mul(m[next].rate, cell->span), SoaFloat3x3.Mul(m[next + 1].rate, cell->span));
            field->c.Set(SoaFloat3x3.Mul(m[joint].rate, cell->chord), SoaFloat3x3.Mul(m[joint + 1].rate, cell->chord),
                SoaFloat3x3.Mul(m[next].rate, cell->chord), SoaFloat3x3.Mul(m[next + 1].rate, cell->chord));
        }

        // The joint's frame moved so in the last substep, and the driven velocity has changed since.
        private static SoaFloat3 VelocityAt(in WingPack pack, in StepScratch scratch, int joint, float3 point)
        {
            JointMotion* motion = pack.motions + joint;
            SoaFloat3 carried = scratch.drivenVelocities[joint] - pack.drivenVelocities[joint];
            return motion->velocity + carried + SoaFloat3x3.Mul(motion->rate, point - pack.rig.restJoints[joint]);
        }

        private static void MeetAir(in WingPack pack, in StepScratch scratch, PatchCell* cell, CellField* field)
        {
            SoaFloat3 wind = pack.surroundings->wind;
            int end = cell->firstPatch + cell->patchCount;
            for (int patch = cell->firstPatch; patch < end; patch++)
            {
                float4 u = pack.rig.patchU[patch], v = pack.rig.patchV[patch];
                SoaFloat3 surface = Bilinear.At(&field->a, u, v)
                    + Bilinear.At(&field->b, u, v) * pack.rig.patchSpan[patch]
                    + Bilinear.At(&field->c, u, v) * pack.rig.patchChord[patch];
                scratch.relativeWind[patch] = wind - surface;
            }
        }

        private static void Frames(in WingPack pack, in StepScratch scratch, PatchCell* cell, int joint, CellField* field)
        {
            int next = joint + pack.rig.jointsPerChain;
            SoaFloat3x3* f = scratch.carriedFrames;
            field->a.Set(SoaFloat3x3.Mul(f[joint], cell->normal), SoaFloat3x3.Mul(f[joint + 1], cell->normal),
                SoaFloat3x3.Mul(f[next], cell->normal), SoaFloat3x3.Mul(f[next + 1], cell->normal));
            field->b.Set(SoaFloat3x3.Mul(f[joint], cell->span), SoaFloat3x3.Mul(f[joint + 1], cell->span),
                SoaFloat3x3.Mul(f[next], cell->span), SoaFloat3x3.Mul(f[next + 1], cell->span));
        }

        private static void Normals(in WingPack pack, in StepScratch scratch, PatchCell* cell, CellField* field)
        {
            bool keepSpan = pack.options.tangent == AirTangent.BaseToTip;
            int end = cell->firstPatch + cell->patchCount;
            for (int patch = cell->firstPatch; patch < end; patch++)
            {
                float4 u = pack.rig.patchU[patch], v = pack.rig.patchV[patch];
                SoaFloat3 normal = Bilinear.At(&field->a, u, v);
                scratch.normals[patch] = normal * (1f / math.sqrt(math.max(SoaFloat3.LengthSquared(normal), 1e-12f)));
                SoaFloat3 span = Bilinear.At(&field->b, u, v);
                SoaFloat3 wind = scratch.relativeWind[patch];
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
