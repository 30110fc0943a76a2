using System.Collections.Generic;
using Alate.Flight;

namespace Alate.Tests.FreeFlights
{
    /// <summary>
    /// Force and moment of the air on a body, summed over the patches of all its wings in double precision. A patch meets the air before
    /// the wing has answered it: where the beat has got to in the substep, with a deformation that goes on as it did in the last one. The
    /// joints' places are made of readings and the rest pose alone.
    /// </summary>
    internal sealed unsafe class PatchSums
    {
        private readonly FlightModel m_Model;
        private readonly WingWorld m_World;
        private readonly IReadOnlyList<WingHandle> m_Wings;
        private readonly Vector[][] m_Deformed, m_DeformedBefore;

        public PatchSums(FlightModel model, WingWorld world, IReadOnlyList<WingHandle> wings)
        {
            m_Model = model;
            m_World = world;
            m_Wings = wings;
            m_Deformed = new Vector[wings.Count][];
            m_DeformedBefore = new Vector[wings.Count][];
            foreach (WingHandle wing in wings)
                world.RecordPatches(wing, true);
        }

        /// <summary>Steps of which the deformation is known: from two on <see cref="Read"/> holds.</summary>
        public int Steps { get; private set; }

        /// <summary>Reads a step of one substep: force, N, and moment about the centre of mass, N m, in body axes.</summary>
        public void Read(out Vector force, out Vector moment)
        {
            force = moment = default;
            for (int k = 0; k < m_Wings.Count; k++)
            {
                WingReading reading = m_World.Read(m_Wings[k]);
                Vector[] driven = Driven(m_Model.Wings[k].Rig, reading), deformed = Deformed(reading, driven);
                if (Steps >= 2)
                    Add(k, reading, Met(k, driven), ref force, ref moment);
                m_DeformedBefore[k] = m_Deformed[k];
                m_Deformed[k] = deformed;
            }

            Steps++;
        }

        private void Add(int wing, in WingReading reading, Vector[] met, ref Vector force, ref Vector moment)
        {
            FlightWing flown = m_Model.Wings[wing];
            var hinge = new Vector(flown.Hinge - m_Model.Centre);
            double unit = (double)flown.Mass * flown.Length;
            ref readonly RigView rig = ref flown.Rig.View;
            for (int cell = 0; cell < rig.cellCount; cell++)
            {
                int joint = cell + cell / (rig.jointsPerChain - 1), next = joint + rig.jointsPerChain;
                PatchCell patches = rig.patchCells[cell];
                for (int patch = patches.firstPatch; patch < patches.firstPatch + patches.patchCount; patch++)
                {
                    double u = rig.patchU[patch], v = rig.patchV[patch];
                    Vector at = (1 - u) * ((1 - v) * met[joint] + v * met[joint + 1]) + u * ((1 - v) * met[next] + v * met[next + 1]);
                    Vector load = unit * Vector.Transform(flown.Axes, new Vector(reading.PatchForce(patch)));
                    force += load;
                    moment += Vector.Cross(hinge + flown.Length * Vector.Transform(flown.Axes, at), load);
                }
            }
        }

        private Vector[] Met(int wing, Vector[] driven)
        {
            var met = new Vector[driven.Length];
            for (int joint = 0; joint < met.Length; joint++)
                met[joint] = driven[joint] + 2.0 * m_Deformed[wing][joint] - m_DeformedBefore[wing][joint];
            return met;
        }

        private static Vector[] Deformed(in WingReading reading, Vector[] driven)
        {
            var deformed = new Vector[driven.Length];
            for (int joint = 0; joint < driven.Length; joint++)
            {
                deformed[joint] = new Vector(reading.JointPosition(joint / reading.JointsPerChain, joint % reading.JointsPerChain))
                    - driven[joint];
            }
            return deformed;
        }

        // Bone by bone from the hinge as the muscles turn them; roots turn with the first bone of all.
        private static Vector[] Driven(WingRig rig, in WingReading reading)
        {
            var driven = new Vector[rig.JointCount];
            for (int chain = 0; chain < reading.ChainCount; chain++)
            {
                int root = chain * reading.JointsPerChain;
                driven[root] = Vector.Rotate(reading.DrivenRotation(0, 0), new Vector(rig.RestJoints[root]));
                for (int bone = 0; bone < reading.JointsPerChain - 1; bone++)
                {
                    Vector rest = new Vector(rig.RestJoints[root + bone + 1]) - new Vector(rig.RestJoints[root + bone]);
                    driven[root + bone + 1] = driven[root + bone] + Vector.Rotate(reading.DrivenRotation(chain, bone), rest);
                }
            }

            return driven;
        }
    }
}
