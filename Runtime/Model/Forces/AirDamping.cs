namespace Alate
{
    /// <summary>
    /// Damping of the body's motion by the air through the wings: K = Σ b g gᵀ over the joints, g = (n, (r + h) × n) with the normal n of
    /// the carried frame.
    /// </summary>
    internal static unsafe class AirDamping
    {
        /// <summary>Fills the pack's damping; after <see cref="JointLoads"/>, before the joints move.</summary>
        public static void Evaluate(in WingPack pack, in StepScratch scratch)
        {
            SoaFloat3 hinge = pack.surroundings->hinge;
            LaneAir* air = pack.air;
            SoaFloat3x3 uu = default, uw = default, ww = default;
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                SoaFloat3 n = scratch.carriedFrames[joint].c1;
                var c = SoaFloat3.Cross(scratch.carriedPositions[joint] + hinge, n);
                SoaFloat3 bn = n * scratch.airDamping[joint], bc = c * scratch.airDamping[joint];
                uu.c0 += bn * n.x;
                uu.c1 += bn * n.y;
                uu.c2 += bn * n.z;
                uw.c0 += bn * c.x;
                uw.c1 += bn * c.y;
                uw.c2 += bn * c.z;
                ww.c0 += bc * c.x;
                ww.c1 += bc * c.y;
                ww.c2 += bc * c.z;
            }

            air->uu = uu;
            air->uw = uw;
            air->ww = ww;
        }
    }
}
