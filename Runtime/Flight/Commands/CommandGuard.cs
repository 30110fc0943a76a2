using Alate.Geometry;
using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>
    /// Keeps commands within what insects fly: ahead. A fast insect that is to fly back brakes first; a slow one turns its nose, then
    /// flies; sideways, backwards and down it flies slowly, and its nose turns no farther from its way than that allows. Measured on the
    /// monarch, which tumbles from 0.2 m/s backwards, 0.3 m/s sideways and 0.3 m/s straight down.
    /// </summary>
    internal static class CommandGuard
    {
        /// <summary>Fastest flight across the nose, m/s.</summary>
        public const float MostAside = 0.12f;

        /// <summary>Fastest flight backwards, and down where it is slow, m/s.</summary>
        private const float k_Back = 0.06f, k_Sink = 0.15f;

        /// <summary>
        /// Fastest climb of a slow insect, and fastest flight while the nose turns, m/s: hovering leaves no power for more.
        /// </summary>
        private const float k_SlowClimb = 0.03f, k_TurningSpeed = 0.05f;

        /// <summary>Growth of climb and sink with the speed beyond slow flight.</summary>
        private const float k_MoreClimb = 0.6f, k_MoreSink = 0.5f;

        /// <summary>Speed above which the insect flies where it flies, whatever its nose, m/s.</summary>
        private const float k_Slow = 0.25f;

        /// <summary>Least speed wanted that has a direction, m/s.</summary>
        private const float k_Least = 0.02f;

        /// <summary>Speed wanted aside from which the nose is turned, m/s, and the angle of it, radians.</summary>
        private const float k_Turning = 0.2f, k_TurningAngle = 0.5f;

        /// <summary>
        /// Angle by which the wanted heading of a slow insect is ahead of its heading, radians: it turns at little more than 1 rad/s.
        /// </summary>
        private const float k_Ahead = 0.3f;

        /// <summary>Largest angle between the way and the wanted way, radians: an arc; and that from which the insect brakes.</summary>
        private const float k_Arc = 1f, k_Brake = 1.6f;

        /// <summary>Limits what is wanted to what comes next on the way to it. All velocities are those through the air, m/s.</summary>
        /// <param name="velocity">Wanted velocity.</param>
        /// <param name="wanted">Wanted heading, radians; not a number follows the way.</param>
        /// <param name="way">Velocity that is flown.</param>
        /// <param name="heading">Heading that is flown, radians.</param>
        /// <param name="share">Share of the speeds along the ground that count for insects which fly: less for those that swim.</param>
        public static void Limit(ref float3 velocity, ref float wanted, float3 way, float heading, float share)
        {
            velocity.xz /= share;
            way.xz /= share;
            float speed = math.length(velocity.xz), flown = math.length(way.xz);
            wanted = BesideTheWay(wanted, way.xz, flown);
            if (speed > k_Least && flown > k_Slow)
                velocity.xz = OnTheWay(velocity.xz, way.xz, speed, flown);
            else if (speed > k_Least)
                wanted = Turn(ref velocity, wanted, heading, speed);
            bool turns = flown <= k_Slow && math.abs(Headings.Wrap(wanted - heading)) > k_TurningAngle;
            if (turns)
                velocity.xz *= math.min(1f, k_TurningSpeed / math.max(math.length(velocity.xz), 1e-6f));
            float turn = Headings.Wrap(wanted - heading);
            if (flown <= k_Slow && math.abs(turn) > k_Ahead)
                wanted = heading + k_Ahead * math.sign(turn);
            velocity.y = math.clamp(velocity.y, -Sink(flown, turns), k_SlowClimb + k_MoreClimb * math.max(flown - k_Slow, 0f));
            velocity.xz *= share;
        }

        // The nose turns so far from the way that the flight across it is no faster than allowed.
        private static float BesideTheWay(float wanted, float2 way, float flown)
        {
            if (flown <= MostAside || !math.isfinite(wanted))
                return wanted;
            float sin = MostAside / flown, course = Elementary.Atan2(way.x, way.y);
            float most = Elementary.Atan2(sin, math.sqrt(1f - sin * sin));
            return course + math.clamp(Headings.Wrap(wanted - course), -most, most);
        }

        private static float Sink(float flown, bool turns) => turns ? k_SlowClimb : math.max(k_Sink, k_MoreSink * (flown - 2f * k_Slow));

        private static float2 OnTheWay(float2 wanted, float2 way, float speed, float flown)
        {
            float course = Elementary.Atan2(way.x, way.y), off = Headings.Wrap(Elementary.Atan2(wanted.x, wanted.y) - course);
            if (math.abs(off) > k_Brake)
                return default;
            if (math.abs(off) <= k_Arc)
                return wanted;
            Elementary.SinCos(course + k_Arc * math.sign(off), out float sin, out float cos);
            return math.min(speed, flown) * new float2(sin, cos);
        }

        // Back, aside and down at once it flies less of each: what bounds them is an ellipsoid.
        private static float Turn(ref float3 velocity, float wantedHeading, float heading, float speed)
        {
            Elementary.SinCos(heading, out float sin, out float cos);
            float ahead = velocity.x * sin + velocity.z * cos, aside = velocity.x * cos - velocity.z * sin;
            float off = Headings.Wrap(Elementary.Atan2(velocity.x, velocity.z) - heading);
            float course = Elementary.Atan2(velocity.x, velocity.z);
            bool turns = speed > k_Turning && math.abs(off) > k_TurningAngle;
            float most = turns ? k_TurningSpeed : MostAside;
            ahead = math.max(turns ? math.min(ahead, most) : ahead, -math.min(most, k_Back));
            aside = math.clamp(aside, -most, most);
            velocity.x = ahead * sin + aside * cos;
            velocity.z = ahead * cos - aside * sin;
            float back = math.min(ahead, 0f) * (1f / k_Back);
            aside *= 1f / MostAside;
            velocity.y = math.max(velocity.y, -math.max(k_Sink * math.sqrt(math.max(1f - back * back - aside * aside, 0f)), k_SlowClimb));
            return speed > k_Turning ? course : wantedHeading;
        }
    }
}
