using Unity.Mathematics;

namespace Alate
{
    /// <summary>How much of the body's motion the air takes away through the wings: K = Σ b g gᵀ over the joints, g = (n, (r + h) × n) with the normal n of the carried frame.</summary>
    internal static unsafe class AirDamping
    {
        /// <summary>Fills the pack's damping and power; after <see cref="JointLoads"/>, before the joints move.</summary>
        public static void Evaluate(in WingPack pack, in StepScratch scratch)
        {
            SoaFloat3 hinge = pack.surroundings->hinge;
            float4* g = stackalloc float4[6];
            float4* k = stackalloc float4[LaneAir.Entries];
            for (int entry = 0; entry < LaneAir.Entries; entry++)
                k[entry] = 0f;
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                SoaFloat3 normal = scratch.carriedFrames[joint].c1;
                SoaFloat3 turn = SoaFloat3.Cross(scratch.carriedPositions[joint] + hinge, normal);
                float4 b = scratch.airDamping[joint];
                g[0] = normal.x;
                g[1] = normal.y;
                g[2] = normal.z;
                g[3] = turn.x;
                g[4] = turn.y;
                g[5] = turn.z;
                for (int i = 0, entry = 0; i < 6; i++)
                {
                    float4 weighted = b * g[i];
                    for (int j = i; j < 6; j++, entry++)
                        k[entry] += weighted * g[j];
                }
            }

            var damping = pack.air->damping;
            for (int entry = 0; entry < LaneAir.Entries; entry++)
                ((float4*)damping)[entry] = k[entry];
        }
    }
}
