using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>
    /// A wind tunnel for several insects of one kind at once: each is held in its own steady motion, bob and all, or let free from there.
    /// </summary>
    internal sealed class FlightTunnel : IDisposable
    {
        /// <summary>Substeps of a beat of the parameters, over those of the wing: what flights of the games' steps take.</summary>
        private const double k_Substeps = 1.3;

        private readonly FlightModel m_Model;
        private readonly WingWorld m_World = new WingWorld();
        private readonly List<Subject> m_Subjects = new List<Subject>();
        private readonly float[] m_Point = new float[TrimPoint.Floats];

        public FlightTunnel(FlightModel model, int count)
        {
            m_Model = model;
            for (int k = 0; k < count; k++)
            {
                var subject = new Subject();
                FlyingBody body = model.CreateBody();
                body.mode = BodyMode.Held;
                body.table = subject.table.View;
                subject.body = model.AddTo(m_World, body, subject.wings);
                m_Subjects.Add(subject);
            }
        }

        /// <summary>Number of substeps of a beat of some frequency, Hz, with which an insect is measured.</summary>
        public static int Substeps(FlightModel model, double frequency) =>
            (int)Math.Ceiling(k_Substeps * model.Wings[0].Parameters.substepsPerBeat * model.Frequency / frequency);

        /// <summary>The world of the insects.</summary>
        public WingWorld World => m_World;

        /// <summary>Number of insects.</summary>
        public int Count => m_Subjects.Count;

        /// <summary>Wings of an insect, in the order of its model.</summary>
        public IReadOnlyList<WingHandle> Wings(int insect) => m_Subjects[insect].wings;

        /// <summary>The body of an insect.</summary>
        public BodyHandle Body(int insect) => m_Subjects[insect].body;

        /// <summary>Holds an insect in a trim at a condition and commands its beat; gains are 0 where none are given.</summary>
        public void Set(int insect, TrimState trim, in FlightCondition condition, float[] gains = null)
        {
            Subject subject = m_Subjects[insect];
            Array.Clear(m_Point, 0, m_Point.Length);
            if (gains != null)
                Array.Copy(gains, m_Point, m_Point.Length);
            trim.Write(m_Point, m_Model.Frequency);
            subject.table.Write(0, 0, m_Point);
            ref FlyingBody body = ref m_World.Body(subject.body);
            body.reference = new BodyReference
            {
                velocity = new float3(0f, condition.Climb, condition.Speed),
                airSpeed = condition.Speed,
                climb = condition.Climb,
            };
            foreach (WingHandle wing in subject.wings)
                m_World.SetDrive(wing, trim.Drive(m_Model.Frequency));
        }

        /// <summary>Commands of one wing beat after another for one side's wings.</summary>
        public void Drive(int insect, Func<float, WingDrive> ofSide)
        {
            Subject subject = m_Subjects[insect];
            for (int k = 0; k < subject.wings.Count; k++)
                m_World.SetDrive(subject.wings[k], ofSide(m_Model.Wings[k].IsLeft ? -1f : 1f));
        }

        /// <summary>Restarts the beat of all wings.</summary>
        public void Restart()
        {
            foreach (Subject subject in m_Subjects)
            {
                foreach (WingHandle wing in subject.wings)
                    m_World.Reset(wing);
            }
        }

        /// <summary>Lets the beat of all wings run on by some time, seconds.</summary>
        public void Resume(float seconds)
        {
            foreach (Subject subject in m_Subjects)
            {
                foreach (WingHandle wing in subject.wings)
                    m_World.Resume(wing, seconds);
            }
        }

        /// <summary>Beat of an insect's first wing.</summary>
        public WingReading Wing(int insect) => m_World.Read(m_Subjects[insect].wings[0]);

        public void Dispose()
        {
            m_World.Dispose();
            foreach (Subject subject in m_Subjects)
                subject.table.Dispose();
        }

        private sealed class Subject
        {
            public readonly TrimTableMemory table = new TrimTableMemory(new float[1], new float[1]);
            public readonly List<WingHandle> wings = new List<WingHandle>();
            public BodyHandle body;
        }
    }
}
