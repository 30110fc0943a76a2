using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Flight;
using Unity.Mathematics;

namespace Alate.Crowds
{
    /// <summary>An insect that has an Insect Flight, as a body that flies: for motions that are flown by its trims.</summary>
    internal sealed class FlownInsect : IDisposable
    {
        private readonly InsectWings m_Insect;
        private readonly FlightModel m_Model;
        private readonly TrimTable m_Table;

        private FlownInsect(InsectWings insect, InsectFlight flight, IReadOnlyList<DrawnWing> wings)
        {
            m_Insect = insect;
            var values = wings.Select(wing => new PresetValues(wing.Wing.Preset == null ? insect.Preset : wing.Wing.Preset)).ToList();
            float units = SceneModel.UnitsPerMetre(wings[0].Placed, values[0]);
            PresetSize size = values[0].size;
            try
            {
                var described = wings
                    .Select((wing, k) => SceneModel.Describe(wing.Rig, wing.Placed, quaternion.identity, float3.zero, values[k], units))
                    .ToList();
                m_Model = new FlightModel(described, flight.Parts, size.insectMass, size.fluidDensity, size.gravityShare);
            }
            catch (ArgumentException problem)
            {
                throw new BakeException($"'{insect.name}' cannot fly: {problem.Message}");
            }

            m_Table = flight.Trims == null ? null : flight.Trims.Open(m_Model.Key);
        }

        /// <summary>Makes it; null where the insect has no Insect Flight.</summary>
        /// <exception cref="BakeException">Its body cannot fly.</exception>
        public static FlownInsect Of(InsectWings insect, IReadOnlyList<DrawnWing> wings) =>
            insect.TryGetComponent(out InsectFlight flight) ? new FlownInsect(insect, flight, wings) : null;

        /// <summary>Flies a motion; null where it is one in which the body is held.</summary>
        /// <exception cref="BakeException">There are no trims for it, or the insect is lost.</exception>
        public SteadyFlight Fly(BakeMotion motion)
        {
            if (!motion.IsFlown)
                return null;
            if (m_Table == null)
            {
                throw new BakeException(
                    $"Clip '{motion.Name}' is flown by trims, and '{m_Insect.name}' has none for its numbers; without trims it has: "
                    + $"{string.Join(", ", BakeMotion.All.Where(known => !known.IsFlown).Select(known => known.Name))}.");
            }

            return SteadyFlight.Fly(m_Model, m_Table, motion);
        }

        /// <inheritdoc/>
        public void Dispose()
        {
            if (m_Table != null)
                FlightTrims.Return(m_Table);
            m_Model.Dispose();
        }
    }
}
