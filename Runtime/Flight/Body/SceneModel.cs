using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Flight
{
    /// <summary>Makes flight models of insects in a scene.</summary>
    internal static class SceneModel
    {
        /// <summary>Describes a wing as the flight sees it.</summary>
        /// <param name="rig">Rig of the wing.</param>
        /// <param name="placed">The wing.</param>
        /// <param name="rotation">Of the insect in the space of <paramref name="placed"/>.</param>
        /// <param name="position">Of the insect.</param>
        /// <param name="values">Of the wing's preset.</param>
        /// <param name="units">World units of a metre of the insect.</param>
        public static FlightWing Describe(
            WingRig rig, in PlacedWing placed, quaternion rotation, float3 position, PresetValues values, float units)
        {
            quaternion back = math.conjugate(rotation);
            var axes = new float3x3(math.rotate(back, placed.span), math.rotate(back, placed.up), math.rotate(back, placed.forward));
            return new FlightWing
            {
                Rig = rig,
                Parameters = values.parameters,
                Hinge = math.rotate(back, placed.hinge - position) / units,
                Axes = axes,
                Length = values.size.wingLength,
                Mass = values.size.wingMass,
                GravityShare = values.size.gravityShare,
                IsLeft = math.dot(math.cross(axes.c0, axes.c1), axes.c2) < 0f,
            };
        }

        /// <summary>World units of a metre of an insect, by the size at which its first wing is drawn.</summary>
        public static float UnitsPerMetre(in PlacedWing first, PresetValues values) =>
            first.isValid ? first.length / values.size.wingLength : 1f;

        /// <summary>Makes a model of the authored meshes; the insect need not play.</summary>
        /// <exception cref="InvalidOperationException">The wings have a problem, or the body is not possible; the message is one
        /// line.</exception>
        public static FlightModel Create(InsectWings insect, IReadOnlyList<BodyEllipsoid> parts)
        {
            InsectProblem problem = insect.FindProblem();
            if (problem.IsProblem)
                throw new InvalidOperationException(problem.Of(insect.name).Message);
            var rigs = new List<WingRig>();
            try
            {
                var wings = new List<FlightWing>();
                PresetValues first = null;
                float units = 1f;
                foreach (Wing wing in insect.Wings)
                {
                    MeshFilter filter = InsectCheck.FilterOf(wing);
                    WingRig rig = Rig(insect, wing, filter, rigs.Count, out SurfaceMesh surface);
                    rigs.Add(rig);
                    var placed = new PlacedWing(filter.transform.localToWorldMatrix, rig.Frame);
                    var values = new PresetValues(wing.Preset == null ? insect.Preset : wing.Preset);
                    if (first == null)
                        units = UnitsPerMetre(placed, first = values);
                    FlightWing described = Describe(rig, placed, insect.transform.rotation, insect.transform.position, values, units);
                    described.Surface = surface;
                    wings.Add(described);
                }

                return new FlightModel(wings, parts, first.size.insectMass, first.size.fluidDensity, first.size.gravityShare);
            }
            catch (ArgumentException exception)
            {
                throw new InvalidOperationException(RiggedParts.OneLine(exception), exception);
            }
            finally
            {
                foreach (WingRig rig in rigs)
                    rig.Release();
            }
        }

        private static WingRig Rig(InsectWings insect, Wing wing, MeshFilter filter, int index, out SurfaceMesh surface)
        {
            Mesh mesh = InsectCheck.MeshOf(wing, filter);
            var parts = new RiggedParts(
                mesh, new AutomaticSkeleton(insect.transform, filter.transform), insect.Patches);
            RiggedPart[] rigged = parts.Build(new[] { wing }, new List<int> { index }, out InsectProblem problem);
            surface = rigged == null ? null : MeshParts.Surface(mesh, rigged[0].Selection);
            return rigged != null ? rigged[0].Rig : throw new InvalidOperationException(problem.Of(insect.name).Message);
        }
    }
}
