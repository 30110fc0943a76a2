using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>Writes down a flight while it is flown.</summary>
    internal sealed class FlightRecorder
    {
        private quaternion m_Rotation;
        private float3 m_Velocity, m_Spin;

        /// <summary>Flight so far.</summary>
        public FlightRecording Recording { get; } = new FlightRecording();

        /// <summary>False before the flight has begun.</summary>
        public bool HasBegun { get; private set; }

        /// <summary>Reason why no more is recorded, in words for people; null while it is.</summary>
        public string Ended { get; private set; }

        /// <summary>Writes down the start.</summary>
        public void Begin(FlightModel model, in FlightStart start)
        {
            HasBegun = true;
            Recording.Key = model.Key;
            Recording.Start = start;
            foreach (FlightWing wing in model.Wings)
                Recording.Wings.Add(new RecordedPlace { hinge = wing.Hinge, axes = wing.Axes });
        }

        /// <summary>Keeps the motion with which a step has ended, before others change it.</summary>
        public void Keep(in FlyingBody body)
        {
            m_Rotation = body.rotation;
            m_Velocity = body.velocity;
            m_Spin = body.spin;
        }

        /// <summary>Writes down what others have made of the motion since <see cref="Keep"/>.</summary>
        /// <param name="body">The body.</param>
        /// <param name="turn">Turn of the reference, radians.</param>
        public void Pushed(in FlyingBody body, float turn)
        {
            bool same = body.rotation.value.Equals(m_Rotation.value) && body.velocity.Equals(m_Velocity) && body.spin.Equals(m_Spin);
            if (!HasBegun || Ended != null || same && turn == 0f)
                return;
            Recording.Pushes.Add(new RecordedPush
            {
                step = Recording.Steps.Count,
                rotation = body.rotation,
                velocity = body.velocity,
                spin = body.spin,
                turn = turn,
            });
        }

        /// <summary>Writes down a step that is about to be flown.</summary>
        /// <param name="body">The body with its air and gravity.</param>
        /// <param name="command">Command of the pilot.</param>
        /// <param name="isGuarded">Whether it is kept within what the insect flies.</param>
        /// <param name="length">Seconds of a step of the wings.</param>
        /// <param name="count">Number of steps of the wings.</param>
        public void Add(in FlyingBody body, in FlightCommand command, bool isGuarded, float length, int count)
        {
            if (!HasBegun || Ended != null)
                return;
            if (Recording.Steps.Count >= FlightRecording.MostSteps)
            {
                End("it has become too long");
                return;
            }

            Recording.Steps.Add(new RecordedStep(command, length, count)
            {
                wind = body.wind,
                gravity = body.gravity,
                aid = body.aid,
                isUnguarded = !isGuarded,
            });
        }

        /// <summary>Ends the recording; the first reason counts.</summary>
        public void End(string why) => Ended ??= why;
    }
}
