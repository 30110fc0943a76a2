using System;
using System.Collections.Generic;
using Alate.Catalogue;
using Unity.Collections;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>A right wing of a species at its cruising speed, baked once: what tests of time and wind fly.</summary>
    internal sealed class SpeciesFlight : IDisposable
    {
        private const float k_Gravity = 9.81f, k_CruiseShare = 0.65f;

        private readonly float m_GravityShare;

        /// <param name="wing">Which wing.</param>
        /// <param name="variant">In which variant.</param>
        /// <param name="patches">Of the rig.</param>
        public SpeciesFlight(WingDefinition wing, InsectVariant variant = InsectVariant.Standard, int patches = 64)
        {
            WingPreset preset = wing.CreatePreset(ModelReading.Physical, variant);
            parameters = preset.ToParameters();
            Length = preset.WingLength;
            TopSpeed = preset.Beat.maxSpeed;
            Speed = k_CruiseShare * TopSpeed;
            m_GravityShare = preset.Size.gravityShare;
            UnityEngine.Object.DestroyImmediate(preset);
            SurfaceMesh mesh = wing.CreateSurface(WingSide.Right);
            Rig = TestWings.Bake(wing.CreateSkeleton(WingSide.Right), mesh, patches);
            Rest = Array.ConvertAll(mesh.positions, position => Rig.Frame.ToWing(position));
            Triangles = mesh.triangles;
        }

        /// <summary>Another wing that beats as that of a species does.</summary>
        /// <param name="skeleton">Its skeleton.</param>
        /// <param name="surface">Its mesh.</param>
        /// <param name="preset">How it beats, and how large it is.</param>
        public SpeciesFlight(WingSkeleton skeleton, SurfaceMesh surface, WingPreset preset)
        {
            parameters = preset.ToParameters();
            Length = preset.WingLength;
            TopSpeed = preset.Beat.maxSpeed;
            Speed = k_CruiseShare * TopSpeed;
            m_GravityShare = preset.Size.gravityShare;
            Rig = TestWings.Bake(skeleton, surface, 64);
            Rest = Array.ConvertAll(surface.positions, position => Rig.Frame.ToWing(position));
            Triangles = surface.triangles;
        }

        /// <summary>Parameters of the wing; tests change them.</summary>
        public WingParameters parameters;

        public WingRig Rig { get; }

        /// <summary>[vertex] Rest positions, wing lengths.</summary>
        public float3[] Rest { get; }

        public int[] Triangles { get; }

        /// <summary>Wing length, metres.</summary>
        public float Length { get; }

        /// <summary>Of the body as it cruises, m/s.</summary>
        public float Speed { get; }

        /// <summary>Of the body at its fastest, m/s.</summary>
        public float TopSpeed { get; }

        /// <summary>
        /// Parameters of version 0.1's standard wings: backward Euler in 24 substeps, chains that bend each by itself, wind as it is.
        /// </summary>
        public static WingParameters FirstOrder(WingParameters parameters)
        {
            parameters.options.timeScheme = TimeScheme.BackwardEuler;
            parameters.options.coupling = MembraneCoupling.OneWay;
            parameters.substepsPerBeat = 24;
            return parameters;
        }

        /// <summary>Surroundings of the wing in a wind on top of its own speed.</summary>
        /// <param name="wind">Metres a second.</param>
        /// <param name="speed">Of the body, metres a second.</param>
        public WingSurroundings Air(float3 wind, float speed) => new WingSurroundings
        {
            wind = (wind + new float3(0f, 0f, -speed)) / Length,
            gravity = new float3(0f, -k_Gravity * m_GravityShare / Length, 0f),
            speed = speed,
        };

        /// <inheritdoc cref="Air(float3, float)"/>
        public WingSurroundings Air(float3 wind = default) => Air(wind, Speed);

        /// <summary>Positions of all joints, wing lengths.</summary>
        public static float3[] Joints(in WingReading reading)
        {
            var joints = new float3[reading.ChainCount * reading.JointsPerChain];
            for (int k = 0; k < joints.Length; k++)
                joints[k] = reading.JointPosition(k / reading.JointsPerChain, k % reading.JointsPerChain);
            return joints;
        }

        /// <summary>Root of the mean square distance of joints.</summary>
        public static double Distance(float3[] a, float3[] b)
        {
            double sum = 0.0;
            for (int k = 0; k < a.Length; k++)
                sum += math.distancesq(a[k], b[k]);
            return Math.Sqrt(sum / a.Length);
        }

        /// <summary>The last of some beats in steps of equal length, still air.</summary>
        /// <param name="flown">How it beats.</param>
        /// <param name="steps">Steps of a beat; more than its substeps make finer substeps.</param>
        /// <param name="beats">How many to fly.</param>
        public BeatPath Fly(in WingParameters flown, int steps, int beats)
        {
            using (var world = new WingWorld())
            {
                WingHandle wing = world.Add(Rig, flown, Air());
                float dt = 1f / (steps * world.Read(wing).Frequency);
                var path = new BeatPath();
                for (int k = 0; k < beats * steps; k++)
                {
                    world.Step(dt);
                    if (k >= (beats - 1) * steps)
                        path.Add(world.Read(wing).Phase, Joints(world.Read(wing)));
                }

                return path;
            }
        }

        /// <summary>The skin as drawn last, wing lengths.</summary>
        public float3[] Vertices(WingWorld world, WingHandle wing)
        {
            NativeArray<SkinnedVertex> vertices = world.Vertices(wing);
            var positions = new float3[vertices.Length];
            for (int k = 0; k < positions.Length; k++)
                positions[k] = Rig.Frame.ToWing(vertices[k].position);
            return positions;
        }

        public void Dispose() => Rig.Release();
    }

    /// <summary>Positions of the joints of a wing over a beat.</summary>
    internal sealed class BeatPath
    {
        private readonly List<float> m_Phases = new List<float>();
        private readonly List<float3[]> m_Joints = new List<float3[]>();

        /// <summary>Adds a moment; phases may wrap once.</summary>
        public void Add(float phase, float3[] joints)
        {
            int at = m_Phases.FindIndex(other => other > phase);
            m_Phases.Insert(at < 0 ? m_Phases.Count : at, phase);
            m_Joints.Insert(at < 0 ? m_Joints.Count : at, joints);
        }

        /// <summary>Root of the mean square distance of the joints from those of a finer path at the same phases.</summary>
        public double DistanceTo(BeatPath finer)
        {
            double sum = 0.0;
            for (int k = 0; k < m_Phases.Count; k++)
            {
                double distance = SpeciesFlight.Distance(m_Joints[k], finer.At(m_Phases[k]));
                sum += distance * distance;
            }

            return Math.Sqrt(sum / m_Phases.Count);
        }

        private float3[] At(float phase)
        {
            int after = m_Phases.FindIndex(other => other > phase), before = after <= 0 ? m_Phases.Count - 1 : after - 1;
            after = math.max(after, 0);
            float span = Wrapped(m_Phases[after] - m_Phases[before]), share = span > 0f ? Wrapped(phase - m_Phases[before]) / span : 0f;
            var joints = new float3[m_Joints[0].Length];
            for (int k = 0; k < joints.Length; k++)
                joints[k] = math.lerp(m_Joints[before][k], m_Joints[after][k], share);
            return joints;
        }

        private static float Wrapped(float angle) => angle < 0f ? angle + 2f * math.PI : angle;
    }
}
