using System.Collections.Generic;
using Alate.Flight;

namespace Alate.Tests.FreeFlights
{
    /// <summary>
    /// Force and moment of the air on a body, summed in double precision over the patches of all its wings, and over the joints with what
    /// the deformation has changed in the substep; at the places where the joints are at the end of it.
    /// </summary>
    internal sealed unsafe class PatchSums
    {
        private readonly FlightModel m_Model;
        private readonly WingWorld m_World;
        private readonly IReadOnlyList<WingHandle> m_Wings;

        public PatchSums(FlightModel model, WingWorld world, IReadOnlyList<WingHandle> wings)
        {
            m_Model = model;
            m_World = world;
            m_Wings = wings;
            foreach (WingHandle wing in wings)
                world.RecordPatches(wing, true);
        }

        /// <summary>Reads a step of one substep: force, N, and moment about the centre of mass, N m, in body axes.</summary>
        public void Read(out Vector force, out Vector moment)
        {
            force = moment = default;
            for (int k = 0; k < m_Wings.Count; k++)
                Add(m_Model.Wings[k], m_World.Read(m_Wings[k]), ref force, ref moment);
        }

        private void Add(FlightWing wing, in WingReading reading, ref Vector force, ref Vector moment)
        {
            var hinge = new Vector(wing.Hinge - m_Model.Centre);
            double unit = (double)wing.Mass * wing.Length;
            ref readonly RigView rig = ref wing.Rig.View;
            var joints = new Vector[rig.jointCount];
            for (int joint = 0; joint < joints.Length; joint++)
            {
                joints[joint] = new Vector(reading.JointPosition(joint / rig.jointsPerChain, joint % rig.jointsPerChain));
                Add(joints[joint], new Vector(reading.JointForce(joint)), ref force, ref moment);
            }

            for (int cell = 0; cell < rig.cellCount; cell++)
            {
                int joint = cell + cell / (rig.jointsPerChain - 1), next = joint + rig.jointsPerChain;
                PatchCell patches = rig.patchCells[cell];
                for (int patch = patches.firstPatch; patch < patches.firstPatch + patches.patchCount; patch++)
                {
                    double u = rig.patchU[patch], v = rig.patchV[patch];
                    Vector at = (1 - u) * ((1 - v) * joints[joint] + v * joints[joint + 1])
                        + u * ((1 - v) * joints[next] + v * joints[next + 1]);
                    Add(at, new Vector(reading.PatchForce(patch)), ref force, ref moment);
                }
            }

            void Add(Vector at, Vector load, ref Vector force, ref Vector moment)
            {
                load = unit * Vector.Transform(wing.Axes, load);
                force += load;
                moment += Vector.Cross(hinge + wing.Length * Vector.Transform(wing.Axes, at), load);
            }
        }
    }
}
