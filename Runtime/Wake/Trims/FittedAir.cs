using Alate.Flight;
using Unity.Mathematics;

namespace Alate.Wake
{
    /// <summary>
    /// Air of a wake whose mean is moved until, replayed at the wings, it gives the mean force of the wake itself. Mean and two harmonics
    /// for a whole wing lose what is local where wings meet the wakes of their last strokes.
    /// </summary>
    internal sealed class FittedAir
    {
        /// <summary>Most moves, and force that may be left, over the weight.</summary>
        private const int k_Moves = 4;
        private const float k_Closed = 0.003f;

        /// <summary>Move by which the derivatives are taken, and the largest one in all, over the root mean square of the air.</summary>
        private const float k_Step = 0.1f, k_Most = 1f;

        private readonly FlightModel m_Model;
        private readonly TrimState m_Trim;
        private readonly FlightCondition m_Condition;
        private readonly WingInflow[] m_Air;
        private readonly int m_Finer;

        /// <param name="model">The insect.</param>
        /// <param name="trim">The trim.</param>
        /// <param name="condition">Of the trim.</param>
        /// <param name="air">[pair] Of the wake, wing lengths per second.</param>
        /// <param name="finer">Factor on the substeps of flights.</param>
        public FittedAir(FlightModel model, TrimState trim, in FlightCondition condition, WingInflow[] air, int finer)
        {
            m_Model = model;
            m_Trim = trim;
            m_Condition = condition;
            m_Air = air;
            m_Finer = finer;
        }

        /// <summary>Moves the air until it gives a force.</summary>
        /// <param name="force">Mean force of the wake on the wings, N.</param>
        /// <returns>[pair] The air; null where none nearby gives it.</returns>
        public WingInflow[] Give(float3 force)
        {
            float speed = 0f;
            foreach (WingInflow air in m_Air)
                speed = math.max(speed, m_Model.Length * math.sqrt(air.MeanSquare));
            float2 moved = default;
            for (int move = 0; move <= k_Moves; move++)
            {
                float2 left = Left(moved, force);
                if (math.cmax(math.abs(left)) < k_Closed)
                    return Moved(moved);
                float step = k_Step * speed;
                float2 up = Left(moved + new float2(step, 0f), force) - left, ahead = Left(moved + new float2(0f, step), force) - left;
                moved -= step / (up.x * ahead.y - ahead.x * up.y)
                    * new float2(left.x * ahead.y - ahead.x * left.y, up.x * left.y - left.x * up.y);
                if (!(math.length(moved) < k_Most * speed))
                    break;
            }

            return null;
        }

        // Up and ahead, over the weight.
        private float2 Left(float2 moved, float3 force)
        {
            TrimState trim = m_Trim.Copy();
            WingInflow[] air = Moved(moved);
            for (int pair = 0; pair < trim.inflow.Length; pair++)
                trim.inflow[pair] = pair < air.Length ? air[pair] : default;
            var motion = new TrimMotion(m_Model, trim, m_Condition, air.Length, m_Finer);
            return (motion.Force - force).yz / (float)m_Model.TrimForce(m_Condition);
        }

        // m/s up and ahead, about the mean attitude.
        private WingInflow[] Moved(float2 moved)
        {
            float3 body = math.rotate(math.conjugate(m_Trim.MeanRotation), new float3(0f, moved));
            var air = (WingInflow[])m_Air.Clone();
            int pair = 0;
            foreach (FlightWing wing in m_Model.Wings)
            {
                if (!wing.IsLeft && pair < air.Length)
                    air[pair++].mean += m_Model.Place(wing).ToWing(body) / wing.Length;
            }

            return air;
        }
    }
}
