using System;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>
    /// A flat rectangular wing that neither beats nor bends, and what the air does to it: by the package, and summed over its triangles
    /// here, in double precision and in the body's own axes, for a right and for a left wing.
    /// </summary>
    internal static class RigidPlate
    {
        public const float k_Chord = 0.5f;
        public const int k_Columns = 12, k_Rows = 6;

        /// <summary>One patch a triangle.</summary>
        /// <param name="chord">Of the skeleton; the plate overhangs a narrower one.</param>
        public static WingRig Rig(float chord = k_Chord) =>
            TestWings.Bake(TestWings.Lattice(chord: chord), TestWings.Rectangle(k_Columns, k_Rows), 0);

        public static WingParameters Parameters
        {
            get
            {
                WingParameters parameters = Monarch.Parameters;
                parameters.amplitude = float3.zero;
                parameters.meanFlap = 0f;
                parameters.jointLimit = 0f;
                parameters.strongestWind = 1000f;
                return parameters;
            }
        }

        /// <summary>Force and moment that a reading tells of the plate.</summary>
        public static void Read(in WingSurroundings air, out float3 force, out float3 moment, float chord = k_Chord)
        {
            WingRig rig = Rig(chord);
            using (var world = new WingWorld())
            {
                WingHandle wing = world.Add(rig, Parameters, air);
                rig.Release();
                world.Step(1e-3f);
                force = world.Read(wing).AirForce;
                moment = world.Read(wing).AirMoment;
            }
        }

        /// <summary>Sums Eq. 9 and 10 over the triangles.</summary>
        /// <param name="side">1 for a right wing, along +X; −1 for a left one, along −X.</param>
        /// <param name="wind">At the body's reference point, L/s, body axes.</param>
        /// <param name="spin">Of the body, rad/s, body axes.</param>
        /// <param name="hinge">From the reference point, wing lengths, body axes.</param>
        public static void Sum(int side, float3 wind, float3 spin, float3 hinge, out float3 force, out float3 moment)
        {
            double density = Parameters.airDensity, area = 0.5 / k_Columns * k_Chord / k_Rows;
            double[] sumOfForces = new double[3];
            double[] sumOfMoments = new double[3];
            SurfaceMesh plate = TestWings.Rectangle(k_Columns, k_Rows);
            for (int k = 0; k < plate.triangles.Length; k += 3)
            {
                Vector3 centre = (plate.positions[plate.triangles[k]] + plate.positions[plate.triangles[k + 1]]
                    + plate.positions[plate.triangles[k + 2]]) / 3f;
                float3 r = new float3(side * centre.x, centre.y, centre.z) + hinge;

                // The stream without its part along the span, x; the plate's normal is y.
                double vy = wind.y - (spin.z * (double)r.x - spin.x * (double)r.z),
                    vz = wind.z - (spin.x * (double)r.y - spin.y * (double)r.x);
                double speed = Math.Sqrt(vy * vy + vz * vz);
                double angle = Math.Atan2(Math.Abs(vy), Math.Abs(vz)) * 180.0 / Math.PI;
                double lift = 0.225 + 1.58 * Math.Sin((2.13 * angle - 7.20) * Math.PI / 180.0);
                double drag = 1.92 - 1.55 * Math.Cos((2.04 * angle - 9.82) * Math.PI / 180.0);
                double pressure = 0.5 * density * area * speed * speed, dy = vy / speed, dz = vz / speed;

                // Lift along the part of the normal that is square to the stream: (−dy dz, dz²)/|dz|, on the side that the stream comes to.
                double sign = Math.Sign(vy) * pressure * lift;
                double fy = pressure * drag * dy + sign * Math.Abs(dz), fz = pressure * drag * dz - sign * dy * Math.Sign(dz);
                sumOfForces[1] += fy;
                sumOfForces[2] += fz;
                sumOfMoments[0] += r.y * fz - r.z * fy;
                sumOfMoments[1] += -r.x * fz;
                sumOfMoments[2] += r.x * fy;
            }

            force = new float3((float)sumOfForces[0], (float)sumOfForces[1], (float)sumOfForces[2]);
            moment = new float3((float)sumOfMoments[0], (float)sumOfMoments[1], (float)sumOfMoments[2]);
        }
    }
}
