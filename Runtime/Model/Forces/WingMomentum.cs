using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Momentum of a wing's joints against the body, and where their masses lie, at the end of a substep: what moves the body by reaction.
    /// </summary>
    internal static unsafe class WingMomentum
    {
        /// <summary>Fills the pack's momentum; after the new pose, before its motions replace those of the substep before.</summary>
        public static void Evaluate(in WingPack pack, in StepScratch scratch, float4 dt)
        {
            var rates = new EndRates(pack, dt);
            SoaFloat3 hinge = pack.surroundings->hinge;
            LaneMomentum sum = default;
            for (int joint = 0; joint < pack.rig.jointCount; joint++)
            {
                SoaFloat3 position = scratch.pose[joint].position;
                SoaFloat3 velocity = scratch.drivenVelocities[joint] + rates.Of(pack, scratch, joint);
                float mass = pack.rig.jointMasses[joint];
                SoaFloat3 x = position + hinge, moved = velocity * mass, placed = x * mass;
                sum.first += placed;
                sum.squares += new SoaFloat3(placed.x * x.x, placed.y * x.y, placed.z * x.z);
                sum.products += new SoaFloat3(placed.y * x.z, placed.z * x.x, placed.x * x.y);
                sum.linear += moved;
                sum.angular += SoaFloat3.Cross(x, moved);
            }

            *pack.momentum = sum;
        }
    }
}
