using System;
using System.Collections.Generic;
using Alate.Catalogue;
using Alate.Flight;
using Unity.Mathematics;

namespace Alate.Proof
{
    /// <summary>An insect that flies ahead by its own wings for two seconds, and meets a gust in the middle.</summary>
    internal sealed class FreeGolden : IDisposable
    {
        private const int k_Frames = 120, k_GustFrom = 40, k_GustTo = 60;
        private const float k_FrameTime = 1f / 60f, k_SpeedShare = 0.5f, k_ClimbShare = 0.2f, k_Aid = 0.5f;

        /// <summary>Distance that is allowed, m and m/s: the feedback holds flights together that began a bit apart.</summary>
        private const float k_Allowed = 2e-4f;

        private static readonly string[] s_Things = { "place", "velocity", "nose", "back" };
        private static readonly float3 s_Gust = new float3(0.4f, 0f, -0.3f);

        private readonly WingWorld m_World = new WingWorld();
        private readonly InsectDefinition m_Insect;
        private readonly FlightModel m_Model;
        private readonly TrimTable m_Table;
        private readonly BodyHandle m_Body;
        private FlightReference m_Reference;

        public FreeGolden(InsectDefinition insect)
        {
            m_Insect = insect;
            m_Model = CatalogueFlight.CreateModel(insect);
            m_Table = CatalogueFlight.CreateTable(insect, m_Model);
            float3 velocity = m_Table.Speeds[0] * new float3(0f, 0f, 1f);
            FlyingBody body = m_Model.CreateBody();
            body.table = m_Table.View;
            body.steered = 1;
            body.aid = k_Aid;
            body.reference = new BodyReference { velocity = velocity, airSpeed = m_Table.Speeds[0] };
            m_Reference = new FlightReference(velocity, 0f, default);
            var wings = new List<WingHandle>();
            m_Body = m_Model.AddTo(m_World, body, wings);
            WingDrive drive = m_Table.DriveNear(m_Table.Speeds[0], 0f);
            foreach (WingHandle wing in wings)
            {
                m_World.SetDrive(wing, drive);
                m_World.Reset(wing);
            }

            m_World.PlaceOnBob(m_Body);
        }

        /// <summary>Flies.</summary>
        public GoldenTrack Run()
        {
            var wanted = new float3(0f, k_ClimbShare * m_Table.Limits.MostClimb, k_SpeedShare * m_Table.TopSpeed);
            var values = new List<float>();
            for (int frame = 0; frame < k_Frames; frame++)
            {
                ref FlyingBody body = ref m_World.Body(m_Body);
                float3 wind = frame >= k_GustFrom && frame < k_GustTo ? s_Gust : default;
                body.wind = wind;
                body.reference = m_Reference.Step(wanted, 0f, wind, body.velocityError, m_Table, true, k_FrameTime);
                m_World.Step(k_FrameTime);
                AddBody(values, m_World.Body(m_Body));
            }

            return new GoldenTrack($"{m_Insect.Name}: free flight of 2 s through a gust, m and m/s", s_Things, k_Allowed, values.ToArray());
        }

        public void Dispose()
        {
            m_World.Dispose();
            m_Table.Dispose();
            m_Model.Dispose();
        }

        private static void AddBody(List<float> values, in FlyingBody body)
        {
            GoldenTrack.Add(values, body.position);
            GoldenTrack.Add(values, body.velocity);
            GoldenTrack.Add(values, math.rotate(body.rotation, new float3(0f, 0f, 1f)));
            GoldenTrack.Add(values, math.rotate(body.rotation, new float3(0f, 1f, 0f)));
        }
    }
}
