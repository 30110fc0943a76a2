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
        /// <summary>Adds forces and damping of the air to the joints'; call after <see cref="CarriedSurface"/>.</summary>
        public static void Apply(in WingPack pack, in StepScratch scratch)
        {
            CellMotion.Evaluate(pack, scratch);
            CellSheet.Evaluate(pack, scratch);
            PatchLoad* loads = pack.recordedLoads != null ? pack.recordedLoads : scratch.loads;
            CellMotion motion;
            CellSheet sheet;
            int bonesPerChain = pack.rig.jointsPerChain - 1;
            SoaFloat3 wind = pack.surroundings->boundWind + pack.inflow->velocity;
            for (int cell = 0; cell < pack.rig.cellCount; cell++)
            {
                PatchCell* patches = pack.rig.patchCells + cell;
                if (patches->patchCount == 0)
                    continue;
                int joint = cell + cell / bonesPerChain;
                int next = joint + pack.rig.jointsPerChain;
                CellMotion.Gather(&motion, scratch, joint, next);
                MeetAir(pack, scratch, patches, &motion, wind);
                CellSheet.Gather(&sheet, pack, scratch, joint, next);
                Normals(pack, scratch, patches, &sheet);
                DropSpanwiseFlow(pack, scratch, patches, &sheet);
                if (pack.options.attachedRotation)
                    Rotate(pack, scratch, patches, &motion);
                Forces(pack, scratch, patches, loads);
                Distribute(pack, scratch, patches, joint, loads);
            }
        }

        private static void MeetAir(in WingPack pack, in StepScratch scratch, PatchCell* cell, CellMotion* motion, in SoaFloat3 wind)
        {
            int end = cell->firstPatch + cell->patchCount;
            for (int patch = cell->firstPatch; patch < end; patch++)
            {
                scratch.relativeWind[patch] = wind - CellMotion.At(
                    motion, pack.rig.patchU[patch], pack.rig.patchV[patch], pack.rig.patchSpan[patch], pack.rig.patchChord[patch]);
            }
        }

        // Unit normals, and ½ρ* times the deformed areas: |x_u × x_v| is what an area has grown to.
        private static void Normals(in WingPack pack, in StepScratch scratch, PatchCell* cell, CellSheet* sheet)
        {
            float4 halfDensity = 0.5f * pack.parameters->numbers.airDensity;
            int end = cell->firstPatch + cell->patchCount;
            for (int patch = cell->firstPatch; patch < end; patch++)
                scratch.normals[patch] = CellSheet.NormalAt(sheet, pack.rig.patchU[patch], pack.rig.patchV[patch]);

            for (int patch = cell->firstPatch; patch < end; patch++)
            {
                SoaFloat3 normal = scratch.normals[patch];
                float4 length = math.sqrt(math.max(SoaFloat3.LengthSquared(normal), 1e-20f));
                scratch.normals[patch] = normal * (1f / length);
                scratch.halfDensityAreas[patch] = halfDensity * (pack.rig.patchAreas[patch] * pack.rig.patchMeasures[patch] * length);
            }
        }

        // The stream that makes the force has no part along the span: that flows off without turning. The printed tangent (base to
        // tip) keeps the stream and measures the angle of attack against its part along the span.
        private static void DropSpanwiseFlow(in WingPack pack, in StepScratch scratch, PatchCell* cell, CellSheet* sheet)
        {
            bool keep = pack.options.tangent == AirTangent.BaseToTip;
            int end = cell->firstPatch + cell->patchCount;
            for (int patch = cell->firstPatch; patch < end; patch++)
            {
                SoaFloat3 normal = scratch.normals[patch], wind = scratch.relativeWind[patch];
                SoaFloat3 span = CellSheet.SpanAt(sheet, pack.rig.patchU[patch], pack.rig.patchV[patch]);
                span -= normal * SoaFloat3.Dot(span, normal);
                float4 square = math.max(SoaFloat3.LengthSquared(span), 1e-12f);
                float4 along = SoaFloat3.Dot(wind, span);
                if (keep)
                    scratch.alongSpan[patch] = math.abs(along) / math.sqrt(square);
                else
                    scratch.relativeWind[patch] = wind - span * (along / square);
            }
        }

        // The wing meets across its surface what its three-quarter chord does: a quarter of the chord behind the middle the surface moves
        // by a quarter chord times the rate of the chord's direction. cos²α of the attached flow is 1 − (w·n)²/w².
        private static void Rotate(in WingPack pack, in StepScratch scratch, PatchCell* cell, CellMotion* motion)
        {
            int end = cell->firstPatch + cell->patchCount;
            for (int patch = cell->firstPatch; patch < end; patch++)
            {
                SoaFloat3 normal = scratch.normals[patch], wind = scratch.relativeWind[patch];
                SoaFloat3 rate = CellMotion.ChordRateAt(motion, pack.rig.patchU[patch], pack.rig.patchV[patch]);
                float4 speed2 = math.max(SoaFloat3.LengthSquared(wind), 1e-12f), across = SoaFloat3.Dot(wind, normal);
                float4 attached = 1f - across * across / speed2;
                scratch.relativeWind[patch] =
                    wind + normal * (SoaFloat3.Dot(rate, normal) * attached * pack.rig.patchQuarterChords[patch]);
            }
        }

        private static void Forces(in WingPack pack, in StepScratch scratch, PatchCell* cell, PatchLoad* loads)
        {
            bool alongSpan = pack.options.tangent == AirTangent.BaseToTip;
            int first = cell->firstPatch, end = first + cell->patchCount;
            for (int patch = first; patch < end; patch++)
            {
                scratch.streams[patch] = PatchAir.Evaluate(scratch.relativeWind[patch], scratch.normals[patch]);
                if (alongSpan)
                    scratch.streams[patch].tangential = scratch.alongSpan[patch];
            }

            Coefficients.Evaluate(pack.options, scratch.streams + first, cell->patchCount);
            for (int patch = first; patch < end; patch++)
            {
                loads[patch].force = PatchAir.Force(
                    scratch.streams[patch], scratch.relativeWind[patch], scratch.normals[patch], scratch.halfDensityAreas[patch]);
            }

            for (int patch = first; patch < end; patch++)
            {
                loads[patch].damping = PatchAir.Damping(
                    scratch.streams[patch], scratch.halfDensityAreas[patch], out loads[patch].sinAttack);
            }
        }

        // Weighted sums of the loads, then once a cell to its joints: the weights of a patch are (1−u)(1−v), (1−u)v, u(1−v), uv.
        private static void Distribute(in WingPack pack, in StepScratch scratch, PatchCell* cell, int joint, PatchLoad* loads)
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
        }

        private static void Add(in StepScratch scratch, int joint, SoaFloat3 force, float4 damping)
        {
            scratch.forces[joint] += force;
            scratch.airDamping[joint] += damping;
        }
    }
}
