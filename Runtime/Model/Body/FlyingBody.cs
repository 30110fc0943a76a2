using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// A body that its wings carry: what it is, how it moves, what it follows. SI units; world axes unless said otherwise.
    /// </summary>
    /// <remarks>
    /// 752 bytes a body: what it is, how it moves and what its feedback remembers in one piece, because a substep of one body reads most of
    /// it. Bodies are few beside wings, and each turns differently: they are not laid out in lanes.
    /// </remarks>
    internal unsafe struct FlyingBody
    {
        /// <summary>Tilt beyond which the body tumbles, radians.</summary>
        private const float k_TumblingTilt = 70f * math.PI / 180f;

        /// <summary>1 for a body in use.</summary>
        public int used;

        public BodyMode mode;

        /// <summary>Mass, wings and all, kilograms.</summary>
        public float mass;

        /// <summary>Inertia about the centre of mass in body axes, kg m².</summary>
        public float3x3 inertia;

        /// <summary>1 where the inertia of the wings moves the body.</summary>
        public int reacts;

        /// <summary>Masses of the body without its wings and what swings of it.</summary>
        public BodyMasses hull;

        /// <summary>The abdomen, where it swings.</summary>
        public BodyAbdomen abdomen;

        /// <summary>Masses of body and wings at the end of the last substep, and 1 where they are known.</summary>
        public BodyMasses masses;
        public int knowsMasses;

        /// <summary>½ρA along each axis of the body, kg/m.</summary>
        public float3 drag;

        /// <summary>Weight over mass and gravity of the wings, m/s².</summary>
        public float3 weight, gravity;

        /// <summary>Velocity of the air, m/s.</summary>
        public float3 wind;

        /// <summary>F0, hertz: the frequency that the units of the commands go by.</summary>
        public float frequency;

        /// <summary>Strength of the outer help towards the wanted velocity and attitude, 0 to 1.</summary>
        public float aid;

        /// <summary>Lengths by which aid is bounded: that of the longest wing, metres.</summary>
        public float length;

        public BodyReference reference;
        public TrimTableView table;

        /// <summary>First of its wings in the list of the job, and how many.</summary>
        public int firstWing, wingCount;

        /// <summary>Centre of mass, metres, and what rounding has left out of it.</summary>
        public float3 position, positionRest;
        public quaternion rotation;
        public float3 velocity;

        /// <summary>Angular velocity in body axes, rad/s.</summary>
        public float3 spin;

        /// <summary>Rates of velocity and spin in body axes in the last substep.</summary>
        public float3 acceleration, spinRate;

        /// <summary>Integral of the velocity's error along the heading's axes, metres.</summary>
        public float3 integral;

        /// <summary>Last commands, in units.</summary>
        public fixed float last[FlightCommands.Count];

        /// <summary>1 where the command of the coming beat has been made.</summary>
        public int latched;

        /// <summary>1 where the feedback makes commands; otherwise the trim holds.</summary>
        public int steered;

        /// <summary>1 where a body that tumbles rights itself before it follows its reference again.</summary>
        public int recovers;

        /// <summary>1 while the body rights itself, from a tumble until it flies as a steady flight does.</summary>
        public int rights;

        /// <summary>
        /// Above 0 while the body follows its reference, because its wings are not computed, or still settle: beats left and 1.
        /// </summary>
        public int follows;

        /// <summary>Seconds since the last sample.</summary>
        public float sinceSample;

        /// <summary>Errors at the last sample along the heading's axes: velocity, turn out of the trimmed attitude, rates.</summary>
        public float3 velocityError, turnError, rateError;

        /// <summary>Turn of the body's up out of the trimmed attitude less the bob at the last beat, radians.</summary>
        public float tilt;

        /// <summary>Beats latched.</summary>
        public int beats;

        /// <summary>Commands that were clipped at the last sample.</summary>
        public int clipped;

        /// <summary>
        /// Mean force of the wings, N, moment in body axes, N m, aid's force and moment and power, W, over the last step.
        /// </summary>
        public float3 force, moment, aidForce, aidMoment;
        public float aidPower;

        /// <summary>Mean power that the wings give to the air over the last step, W.</summary>
        public float power;

        /// <summary>
        /// Mean damping of a held body's velocities up and ahead and of turning about X over the last step; columns are what they are
        /// damped by.
        /// </summary>
        public float3x3 damping;

        /// <summary>Values of the substep: middle of it.</summary>
        public quaternion middleRotation;
        public float3 middleVelocity, middleSpin;

        /// <summary>True where the body has turned so far that its wings must turn it back.</summary>
        public readonly bool Tumbles => tilt > k_TumblingTilt;

        /// <summary>Last command, in units.</summary>
        public readonly float Last(int command) => last[command];

        /// <summary>Forgets what the feedback has measured and commanded.</summary>
        public void Forget()
        {
            for (int k = 0; k < FlightCommands.Count; k++)
                last[k] = 0f;
            integral = velocityError = turnError = rateError = force = moment = default;
            tilt = aidPower = power = sinceSample = 0f;
            latched = clipped = rights = 0;
        }

        /// <summary>Height over the reach of the float: position to add, without losing what is small.</summary>
        public void Move(float3 by)
        {
            float3 step = by - positionRest;
            float3 next = position + step;
            positionRest = (next - position) - step;
            position = next;
        }
    }
}
