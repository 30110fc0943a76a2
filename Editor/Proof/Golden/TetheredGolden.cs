using System;
using System.Collections.Generic;
using Alate.Catalogue;
using Unity.Mathematics;

namespace Alate.Proof
{
    /// <summary>All joints of an insect's right wings over four beats, in the air of a level flight at 0.65 of its top speed.</summary>
    internal sealed class TetheredGolden : IDisposable
    {
        private const int k_Beats = 4, k_SamplesPerBeat = 8;
        private const float k_CruiseShare = 0.65f;

        /// <summary>
        /// Distance of a joint that is allowed, wing lengths. Another order of the same sums moves joints by a hundredth of it; a stiffness
        /// that is wrong by a thousandth moves some by three times as much.
        /// </summary>
        private const float k_Allowed = 2e-5f;

        private readonly WingWorld m_World = new WingWorld();
        private readonly InsectDefinition m_Insect;
        private readonly List<WingRig> m_Rigs = new List<WingRig>();
        private readonly List<WingHandle> m_Wings = new List<WingHandle>();

        public TetheredGolden(InsectDefinition insect)
        {
            m_Insect = insect;
            foreach (WingDefinition wing in insect.Wings)
            {
                WingPreset preset = wing.CreatePreset();
                WingParameters parameters = preset.ToParameters();
                float cruise = k_CruiseShare * parameters.maxSpeed;
                m_Rigs.Add(WingRig.Bake(wing.CreateSkeleton(WingSide.Right), wing.CreateSurface(WingSide.Right), WingRigSettings.Default));
                m_Wings.Add(m_World.Add(m_Rigs[m_Rigs.Count - 1], parameters, new WingSurroundings
                {
                    wind = new float3(0f, 0f, -cruise / preset.WingLength),
                    gravity = new float3(0f, -EarthGravity.Size / preset.WingLength, 0f),
                    speed = cruise,
                }));
            }
        }

        /// <summary>Flies.</summary>
        /// <returns>A track a wing.</returns>
        public IEnumerable<GoldenTrack> Run()
        {
            float step = 1f / (k_SamplesPerBeat * m_World.Read(m_Wings[0]).Frequency);
            var values = new List<float>[m_Wings.Count];
            for (int wing = 0; wing < values.Length; wing++)
                values[wing] = new List<float>();
            for (int sample = 0; sample < k_Beats * k_SamplesPerBeat; sample++)
            {
                m_World.Step(step);
                for (int wing = 0; wing < values.Length; wing++)
                    AddJoints(values[wing], m_World.Read(m_Wings[wing]));
            }

            for (int wing = 0; wing < values.Length; wing++)
            {
                string name = $"{m_Insect.Name}, {m_Insect.Wings[wing].Name.ToLowerInvariant()}: joints over {k_Beats} beats, wing lengths";
                yield return new GoldenTrack(name, Joints(m_World.Read(m_Wings[wing])), k_Allowed, values[wing].ToArray());
            }
        }

        public void Dispose()
        {
            m_World.Dispose();
            foreach (WingRig rig in m_Rigs)
                rig.Release();
        }

        private static void AddJoints(List<float> values, in WingReading wing)
        {
            for (int chain = 0; chain < wing.ChainCount; chain++)
            {
                for (int joint = 0; joint < wing.JointsPerChain; joint++)
                    GoldenTrack.Add(values, wing.JointPosition(chain, joint));
            }
        }

        private static string[] Joints(in WingReading wing)
        {
            string[] names = new string[wing.ChainCount * wing.JointsPerChain];
            for (int k = 0; k < names.Length; k++)
                names[k] = $"chain {k / wing.JointsPerChain}, joint {k % wing.JointsPerChain}";
            return names;
        }
    }
}
