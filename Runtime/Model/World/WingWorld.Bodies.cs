using System;
using Unity.Mathematics;

namespace Alate
{
    public sealed partial class WingWorld
    {
        /// <summary>
        /// Commands a wing's beat from its next one on, in place of the one that follows the speed of its surroundings; light enough for
        /// every beat: nothing else is derived from it.
        /// </summary>
        /// <exception cref="ArgumentException">No such wing, or a drive out of range.</exception>
        public unsafe void SetDrive(WingHandle wing, in WingDrive drive)
        {
            if (!drive.IsValid)
            {
                throw new ArgumentException(
                    $"A drive of {drive.frequency} Hz, {drive.amplitude} times the amplitude, flap "
                    + $"{drive.meanFlap}, sweep {drive.meanSweep}, feather "
                    + $"{drive.meanFeather}, tilt {drive.tilt} radians is out of range: 0.1 to 1000 Hz, 0 to 2, −π to π.",
                    nameof(drive));
            }
            WriteDrive(Entry(wing), drive, true);
        }

        /// <summary>Lets a wing's beat follow the speed of its surroundings again, from its next beat on.</summary>
        /// <exception cref="ArgumentException">No such wing.</exception>
        public void ReleaseDrive(WingHandle wing) => WriteDrive(Entry(wing), default, false);

        /// <summary>The beat that a wing was last commanded to, by a script or the body's feedback.</summary>
        internal unsafe WingDrive Drive(WingHandle wing)
        {
            WingEntry entry = Entry(wing);
            return entry.pack.view.parameters->drive.Of(entry.lane);
        }

        /// <summary>Adds a body that wings are to carry.</summary>
        internal BodyHandle AddBody(in FlyingBody body)
        {
            CompleteUse();
            return m_Bodies.Add(body);
        }

        /// <summary>Lets a wing carry a body; the step writes its surroundings from then on.</summary>
        internal void Attach(WingHandle wing, BodyHandle body, in BodyWing place)
        {
            WingEntry entry = Entry(wing);
            m_Arrays.Download(m_Packs.Packs, m_Entries);
            m_Bodies.Detach(entry);
            m_Bodies.Attach(body, entry, place);
        }

        /// <summary>Returns true where there is such a body.</summary>
        internal bool Contains(BodyHandle body) => !m_Disposed && m_Bodies.Contains(body);

        /// <summary>Takes a body out; its wings stay, and beat as they were last commanded.</summary>
        internal void RemoveBody(BodyHandle body)
        {
            CompleteUse();
            if (!m_Bodies.Contains(body))
                return;
            m_Arrays.Download(m_Packs.Packs, m_Entries);
            m_Bodies.Remove(body);
        }

        /// <summary>A body, to be read and written between steps; valid until the next one is added.</summary>
        internal ref FlyingBody Body(BodyHandle body)
        {
            CompleteUse();
            if (!m_Bodies.Contains(body))
                throw new ArgumentException("This world has no such body.", nameof(body));
            return ref m_Bodies[body];
        }

        /// <summary>One step of one substep for all wings that carry a body, for measurements.</summary>
        internal void StepOnce(float h)
        {
            ScheduleStep(ClockTimes.All(new ClockTime { length = h, count = 1, substeps = 1, inUse = true }));
            Complete();
        }

        /// <summary>Puts a body where its table has it at the phase that its wings have in so many seconds.</summary>
        internal unsafe void PlaceOnBob(BodyHandle handle, float later = 0f)
        {
            ref FlyingBody body = ref Body(handle);
            Upload();
            var wing = new WingReading(m_Arrays, m_Bodies.FirstWing(handle));
            float* point = stackalloc float[TrimPoint.Floats];
            body.table.Read(body.reference.airSpeed, body.reference.climb, point);
            float rate = 2f * math.PI * wing.Frequency;
            BodyMotion.PlaceOnBob(ref body, point, wing.Phase + rate * later, rate, body.reference.velocity);
            body.knowsMasses = 0;
            if (body.table.HasWake)
                m_Bodies.MeetWake(handle, point);
        }

        /// <summary>Sets a body's last command, in units.</summary>
        internal unsafe void SetLast(BodyHandle handle, int command, float units)
        {
            ref FlyingBody body = ref Body(handle);
            body.last[command] = units;
        }

        /// <summary>
        /// Departs a body's motion: velocity, turn and angular velocity, each along the world's axes; a turn does not turn the angular
        /// velocity with it.
        /// </summary>
        internal void Depart(BodyHandle handle, float3 velocity, float3 turn, float3 rate)
        {
            ref FlyingBody body = ref Body(handle);
            float3 spin = math.rotate(body.rotation, body.spin) + rate, acceleration = math.rotate(body.rotation, body.acceleration);
            body.rotation = math.normalize(math.mul(BodyMotion.Turn(turn), body.rotation));
            quaternion back = math.conjugate(body.rotation);
            body.velocity += velocity;
            body.spin = math.rotate(back, spin);
            body.acceleration = math.rotate(back, acceleration);
        }

        /// <summary>Measures how far a body is off its reference, trim and bob; fills its errors.</summary>
        /// <returns>Phase of its wings, radians, with the beats before.</returns>
        internal unsafe double MeasureErrors(BodyHandle handle)
        {
            ref FlyingBody body = ref Body(handle);
            var wing = new WingReading(m_Arrays, m_Bodies.FirstWing(handle));
            float* point = stackalloc float[TrimPoint.Floats];
            body.table.Read(body.reference.airSpeed, body.reference.climb, point);
            BodyFeedback.Errors(ref body, point, BodyBob.At(point, wing.Phase));
            return wing.Phase + 2.0 * math.PI_DBL * wing.Beats;
        }

        private unsafe void WriteDrive(WingEntry entry, in WingDrive drive, bool commanded)
        {
            for (int lane = 0; lane < WingPack.Lanes; lane++)
            {
                if (entry.pack.Writes(entry.lane, lane))
                    entry.pack.view.parameters->drive.Set(lane, drive, commanded);
            }
        }
    }
}
