using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>An insect as a body that flies: its wings, its mass and where the mass lies, its drag.</summary>
    public sealed class FlightModel : IDisposable
    {
        /// <summary>Frontal area along the body counts for so much: a slender body drags less than its shadow.</summary>
        private const float k_EndOnDrag = 0.4f;

        /// <summary>Speed below which the drag of a body that floats is no measure, m/s.</summary>
        private const float k_LeastSwim = 0.05f;

        /// <summary>Share of the drag at top speed by which a body that floats is sped up.</summary>
        private const float k_SwimShare = 0.25f;

        private readonly BodyMasses m_Hull;
        private readonly BodyAbdomen m_Abdomen;

        /// <summary>Makes the model; flies the wings some beats on the spot to see where their mass lies on average.</summary>
        /// <param name="wings">All wings, right and left.</param>
        /// <param name="parts">Parts of the body.</param>
        /// <param name="mass">Of the whole insect, kilograms.</param>
        /// <param name="fluidDensity">kg/m³.</param>
        /// <param name="gravityShare">Share of its weight that the insect has to carry, 0 to 1: 0 for a fish that floats.</param>
        /// <exception cref="ArgumentException">No wings, no parts, a mass below that of the wings; names what and what is
        /// allowed.</exception>
        public FlightModel(
            IReadOnlyList<FlightWing> wings, IReadOnlyList<BodyEllipsoid> parts, float mass, float fluidDensity, float gravityShare = 1f)
        {
            Check(wings, parts, mass);
            foreach (FlightWing wing in wings)
                wing.Rig.Retain();
            Wings = wings;
            Mass = mass;
            GravityShare = gravityShare;
            FluidDensity = fluidDensity;
            foreach (FlightWing wing in wings)
                Length = math.max(Length, wing.Length);
            Frequency = wings[0].Parameters.maxFrequency;
            Key = KeyOf(parts);
            Drag = DragOf(parts);
            var sum = new MassSum();
            foreach (FlightWing wing in wings)
                sum.Add(wing.Mass, WingMass.Of(wing), wing.Length * wing.Axes, wing.Hinge);
            double wingMass = sum.Mass;
            AddParts(sum, parts, mass - wingMass, _ => true);
            Centre = sum.Centre;
            Inertia = sum.Inertia;
            var hull = new MassSum();
            AddParts(hull, parts, mass - wingMass, part => part.swing == 0f);
            m_Hull = hull.About(Centre);
            m_Abdomen = AbdomenOf(parts, mass - wingMass);
        }

        /// <summary>All wings.</summary>
        public IReadOnlyList<FlightWing> Wings { get; }

        /// <summary>Mass of the whole insect, kilograms.</summary>
        public float Mass { get; }

        /// <summary>Share of its weight that the wings have to carry.</summary>
        public float GravityShare { get; }

        /// <summary>Density of the air or water, kg/m³.</summary>
        public float FluidDensity { get; }

        /// <summary>Length of the longest wing, metres.</summary>
        public float Length { get; }

        /// <summary>F0: frequency of the parameters, hertz.</summary>
        public float Frequency { get; }

        /// <summary>Centre of mass from the middle of the thorax, metres.</summary>
        public float3 Centre { get; }

        /// <summary>Inertia about the centre of mass in body axes, kg m², wings at their mean places.</summary>
        public float3x3 Inertia { get; }

        /// <summary>½ρA along each axis, kg/m.</summary>
        public float3 Drag { get; }

        /// <summary>Number that changes with anything that a trim table of this insect depends on.</summary>
        internal uint Key { get; }

        /// <summary>Weight, N, as it would be in air.</summary>
        public float Weight => Mass * EarthGravity.Size;

        /// <summary>True where the fluid carries the body: its fins only balance its drag.</summary>
        public bool Floats => GravityShare <= 0f;

        /// <summary>Force by which residuals of a trim are measured, N: the weight, or the drag of a body that floats.</summary>
        internal double TrimForce(in FlightCondition condition)
        {
            float speed = math.max(k_LeastSwim, math.length(new float2(condition.Speed, condition.Climb)));
            return Floats ? Drag.z * speed * speed : Weight;
        }

        /// <summary>
        /// Largest change of velocity that a reference may ask for, m/s²: 2.5 of what flies; of what floats a share of that with which it
        /// slows down from its top speed by its own drag, for its fins push no harder.
        /// </summary>
        internal float AccelerationAt(float topSpeed) =>
            Floats
            ? math.min(FlightLimits.FlyersAcceleration, k_SwimShare * Drag.z * topSpeed * topSpeed / Mass)
            : FlightLimits.FlyersAcceleration;

        /// <summary>Releases the rigs.</summary>
        public void Dispose()
        {
            foreach (FlightWing wing in Wings)
                wing.Rig.Release();
        }

        /// <summary>A body of this kind at rest.</summary>
        internal FlyingBody CreateBody() => new FlyingBody
        {
            mass = Mass,
            inertia = Inertia,
            hull = m_Hull,
            abdomen = m_Abdomen,
            reacts = AllReact() ? 1 : 0,
            drag = Drag,
            weight = EarthGravity.Down * GravityShare,
            gravity = EarthGravity.Down,
            frequency = Frequency,
            length = Length,
            rotation = quaternion.identity,
        };

        /// <summary>Adds a body with its wings to a world.</summary>
        internal BodyHandle AddTo(WingWorld world, in FlyingBody body, List<WingHandle> handles)
        {
            BodyHandle handle = world.AddBody(body);
            foreach (FlightWing wing in Wings)
            {
                WingHandle added = world.Add(wing.Rig, wing.Parameters);
                world.Attach(added, handle, Place(wing));
                handles.Add(added);
            }

            return handle;
        }

        /// <summary>Returns the place of a wing on the body.</summary>
        internal BodyWing Place(FlightWing wing) => new BodyWing
        {
            axes = wing.Axes,
            handedness = wing.IsLeft ? -1f : 1f,
            hinge = wing.Hinge - Centre,
            length = wing.Length,
            mass = wing.Mass,
            gravityShare = wing.GravityShare,
            side = wing.IsLeft ? -1f : 1f,
            pair = PairOf(wing),
        };

        // Number of a wing among those of its side.
        private int PairOf(FlightWing wing)
        {
            int pair = 0;
            for (int k = 0; k < Wings.Count && Wings[k] != wing; k++)
                pair += Wings[k].IsLeft == wing.IsLeft ? 1 : 0;
            return pair;
        }

        // Masses of a wing without the option would be missing.
        private bool AllReact()
        {
            foreach (FlightWing wing in Wings)
            {
                if (!wing.Parameters.options.bodyReaction)
                    return false;
            }

            return true;
        }

        private uint KeyOf(IReadOnlyList<BodyEllipsoid> parts)
        {
            FlightKey key = FlightKey.Empty;
            key.Add(Mass);
            key.Add(GravityShare);
            key.Add(FluidDensity);
            foreach (BodyEllipsoid part in parts)
            {
                key.Add(part.centre);
                key.Add(part.halfAxes);
                key.Add(part.share);
                // A body that does not feel its masses move does not feel the swing either.
                if (part.swing != 0f && AllReact())
                {
                    key.Add(part.swing);
                    key.Add(part.lowestPhase);
                }
            }

            foreach (FlightWing wing in Wings)
                key.Add(wing);
            return key.Value;
        }

        private static void AddParts(MassSum sum, IReadOnlyList<BodyEllipsoid> parts, double mass, Predicate<BodyEllipsoid> counts)
        {
            double whole = 0.0;
            foreach (BodyEllipsoid part in parts)
                whole += part.share;
            foreach (BodyEllipsoid part in parts)
            {
                if (counts(part))
                    sum.Add(mass * part.share / whole, part.centre, part.halfAxes);
            }
        }

        private BodyAbdomen AbdomenOf(IReadOnlyList<BodyEllipsoid> parts, double mass)
        {
            var own = new MassSum();
            AddParts(own, parts, mass, part => part.swing != 0f);
            foreach (BodyEllipsoid part in parts)
            {
                if (part.swing == 0f)
                    continue;
                return new BodyAbdomen
                {
                    mass = (float)own.Mass,
                    inertia = own.Inertia,
                    hinge = (float3)part.Hinge - Centre,
                    arm = part.centre - part.Hinge,
                    amplitude = math.radians(part.swing),
                    lowest = math.radians(part.lowestPhase),
                };
            }

            return default;
        }

        private float3 DragOf(IReadOnlyList<BodyEllipsoid> parts)
        {
            float3 area = default;
            foreach (BodyEllipsoid part in parts)
            {
                float3 a = part.halfAxes;
                area = math.max(area, new float3(0f, 0f, math.PI * a.x * a.y));
                area += new float3(math.PI * a.y * a.z, math.PI * a.x * a.z, 0f);
            }

            // Parts stand behind one another seen from ahead, side by side seen from elsewhere.
            return 0.5f * FluidDensity * area * new float3(1f, 1f, k_EndOnDrag);
        }

        private static void Check(IReadOnlyList<FlightWing> wings, IReadOnlyList<BodyEllipsoid> parts, float mass)
        {
            if (wings == null || wings.Count == 0)
            {
                throw new ArgumentException(
                    "An insect without wings cannot fly: give it at least one right and one left wing.", nameof(wings));
            }
            if (parts == null || parts.Count == 0)
                throw new ArgumentException("A body needs at least one part with mass.", nameof(parts));
            float carried = 0f, shares = 0f;
            int swinging = 0;
            foreach (FlightWing wing in wings)
                carried += wing.Mass;
            foreach (BodyEllipsoid part in parts)
            {
                shares += part.share;
                if (!(part.share >= 0f) || !math.all((float3)part.halfAxes > 0f) || !math.all(math.isfinite((float3)part.centre)))
                {
                    throw new ArgumentException(
                        "A part of the body needs a finite centre, half axes above 0 and a share of at least 0.", nameof(parts));
                }

                if (!(part.swing >= 0f && part.swing <= BodyEllipsoid.MostSwing) || !math.isfinite(part.lowestPhase))
                {
                    throw new ArgumentException(
                        $"A part of the body swings by {part.swing}°, lowest at {part.lowestPhase}°; allowed are 0 to "
                        + $"{BodyEllipsoid.MostSwing}° and any finite phase.", nameof(parts));
                }

                swinging += part.swing == 0f ? 0 : 1;
            }

            if (swinging > 1)
                throw new ArgumentException($"{swinging} parts of the body swing; only the abdomen can: give the others 0.", nameof(parts));
            if (!(shares > 0f))
                throw new ArgumentException("The parts of the body have no mass: their shares must sum to more than 0.", nameof(parts));
            if (!(mass > carried) || float.IsInfinity(mass))
            {
                throw new ArgumentException(
                    $"The insect's mass is {mass} kg; it must be finite and above that of its wings, {carried} kg.", nameof(mass));
            }
        }
    }
}
