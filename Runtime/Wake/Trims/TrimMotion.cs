using System;
using System.Collections.Generic;
using Alate.Flight;
using Unity.Collections;
using Unity.Mathematics;

namespace Alate.Wake
{
    /// <summary>
    /// Motion of the right wings in a trim, as flown in a wind tunnel, with the bob of the body. Lengths are those of the longest wing,
    /// axes those of the world about the trim's steady motion: X to the right, Y up, Z ahead.
    /// </summary>
    internal sealed class TrimMotion
    {
        /// <summary>Beats until the wings are settled in their trim.</summary>
        private const int k_SettledBeats = 6;

        private readonly FlightModel m_Model;
        private readonly TrimState m_Trim;
        private readonly List<int> m_Right = new List<int>();
        private readonly List<SurfaceGrid> m_Grids = new List<SurfaceGrid>();
        private readonly List<WakeWing> m_Wings = new List<WakeWing>();

        /// <summary>Flies a beat of a trim.</summary>
        /// <param name="model">The insect.</param>
        /// <param name="trim">The trim, with the air that its wings meet.</param>
        /// <param name="condition">Of the trim.</param>
        /// <param name="mostWings">Most right wings that are taken.</param>
        /// <param name="finer">Factor on the substeps of flights.</param>
        /// <exception cref="ArgumentException">A wing has no surface, or one that sheds no wake.</exception>
        public TrimMotion(FlightModel model, TrimState trim, in FlightCondition condition, int mostWings, int finer = 1)
        {
            m_Model = model;
            m_Trim = trim;
            for (int k = 0; k < model.Wings.Count && m_Right.Count < mostWings; k++)
            {
                FlightWing wing = model.Wings[k];
                if (wing.IsLeft)
                    continue;
                if (wing.Surface == null)
                    throw new ArgumentException("A wing without a surface sheds no wake: set FlightWing.Surface.", nameof(model));
                m_Right.Add(k);
                m_Grids.Add(new SurfaceGrid(
                    Array.ConvertAll(wing.Surface.positions, place => wing.Rig.Frame.ToWing(place)), wing.Surface.triangles));
            }

            double frequency = model.Frequency * trim.FrequencyScale;
            Period = (float)(1.0 / frequency);
            Fly(condition, finer * FlightTunnel.Substeps(model, frequency));
        }

        /// <summary>Seconds of a beat.</summary>
        public float Period { get; }

        /// <summary>Mean force of the air on the wings and their mirror images, N.</summary>
        public float3 Force { get; private set; }

        /// <summary>The wings, in the order of the model.</summary>
        public IReadOnlyList<WakeWing> Wings => m_Wings;

        /// <summary>Turns a velocity into the frame of a wing as it lies on the body at a time.</summary>
        /// <param name="wing">Number of the wing.</param>
        /// <param name="beats">Time, beats.</param>
        /// <param name="velocity">Reference lengths a beat.</param>
        /// <returns>Wing lengths per second.</returns>
        public float3 ToWing(int wing, double beats, float3 velocity)
        {
            FlightWing flown = m_Model.Wings[m_Right[wing]];
            float3 body = math.rotate(math.conjugate(m_Trim.RotationAt(beats)), velocity) * (m_Model.Length / Period);
            return m_Model.Place(flown).ToWing(body) / flown.Length;
        }

        private void Fly(in FlightCondition condition, int substeps)
        {
            using var tunnel = new FlightTunnel(m_Model, 1);
            tunnel.Set(0, m_Trim, condition);
            tunnel.Restart();
            float h = Period / substeps;
            for (int step = 0; step < k_SettledBeats * substeps; step++)
                tunnel.World.StepOnce(h);
            double start = tunnel.Wing(0).Phase / (2.0 * Math.PI);
            List<float3[][]> samples = m_Right.ConvertAll(_ => new float3[substeps][]);
            for (int step = 0; step < substeps; step++)
            {
                tunnel.World.Skin();
                for (int k = 0; k < m_Right.Count; k++)
                    samples[k][step] = m_Grids[k].Evaluate(Places(tunnel, m_Right[k], start + (double)step / substeps));
                tunnel.World.StepOnce(h);
                Force += ForceNow(tunnel, start + (step + 0.5) / substeps) / substeps;
            }

            for (int k = 0; k < m_Right.Count; k++)
            {
                m_Wings.Add(new WakeWing(
                    FourierMotion.Through(samples[k], m_Grids[k].Across, m_Grids[k].Along, start),
                    m_Model.Wings[m_Right[k]].Parameters.options));
            }
        }

        // Mean over the last step: of right wings and, as their mirror images push the other way across, twice what is left.
        private float3 ForceNow(FlightTunnel tunnel, double beats)
        {
            float3 sum = default;
            foreach (int index in m_Right)
            {
                BodyWing place = m_Model.Place(m_Model.Wings[index]);
                sum += place.mass * place.length * place.ToBody(tunnel.World.Read(tunnel.Wings(0)[index]).AirForce);
            }

            return new float3(0f, 2f, 2f) * math.rotate(m_Trim.RotationAt(beats), sum);
        }

        // [vertex] Places of a wing that has just been skinned.
        private float3[] Places(FlightTunnel tunnel, int index, double beats)
        {
            FlightWing wing = m_Model.Wings[index];
            BodyWing place = m_Model.Place(wing);
            quaternion rotation = m_Trim.RotationAt(beats);
            float3 middle = m_Trim.PlaceAt(beats, Period);
            NativeArray<SkinnedVertex> vertices = tunnel.World.Vertices(tunnel.Wings(0)[index]);
            var places = new float3[vertices.Length];
            for (int k = 0; k < places.Length; k++)
            {
                float3 onBody = place.hinge + wing.Length * place.ToBody(wing.Rig.Frame.ToWing(vertices[k].position));
                places[k] = (middle + math.rotate(rotation, onBody)) / m_Model.Length;
            }

            return places;
        }
    }
}
