using System;
using UnityEngine;

namespace Alate
{
    /// <summary>
    /// One kind of wing of a species, described for the right side: its outline, where it sits on the body, how finely it is meshed and jointed, and how it beats.
    /// A four-winged insect has two of them.
    /// </summary>
    public sealed class SpeciesWing
    {
        internal SpeciesWing(string name, WingOutline outline, Action<WingSpecies> author)
        {
            Name = name;
            Outline = outline;
            Contour = outline.Smoothed();
            Author = author;
        }

        /// <summary>What the wing is called among the species' wings: "wing", "fore wing", "hind wing", "fin".</summary>
        public string Name { get; }

        /// <summary>The measured outline, straight between its landmarks; the skeleton follows it.</summary>
        public WingOutline Outline { get; }

        /// <summary>The same outline rounded; the mesh fills it.</summary>
        public WingOutline Contour { get; }

        /// <summary>Triangles of one wing.</summary>
        public int TriangleCount { get; internal set; }

        /// <summary>Chains of the skeleton, 5 unless the species says otherwise.</summary>
        public int Chains { get; internal set; } = 5;

        /// <summary>Joints of each chain, 5 unless the species says otherwise.</summary>
        public int JointsPerChain { get; internal set; } = 5;

        /// <summary>Span at which the last chain meets the trailing edge, wing lengths.</summary>
        public double LastTipSpan { get; internal set; }

        /// <summary>The base of the right wing (the outline's origin) on the body, metres: X right, Y up, Z ahead of the middle of the thorax.</summary>
        public Vector3 Hinge { get; internal set; }

        /// <summary>The colouring; null leaves the mesh without vertex colours.</summary>
        public WingPattern Pattern { get; internal set; }

        /// <summary>Meshed by <see cref="WingMesher.Fill(WingOutline, int, float)"/>, else by <see cref="WingMesher.Strips"/>.</summary>
        internal bool IsFilled { get; set; } = true;

        /// <summary>Hollows of the margin; null for none.</summary>
        internal RimScallops Scallops { get; set; }

        /// <summary>Sets what differs from <see cref="WingSpecies"/>' own defaults.</summary>
        internal Action<WingSpecies> Author { get; }

        /// <summary>A preset of this wing by <see cref="ModelPreset.Physical"/> or as printed.</summary>
        public WingSpecies CreateSpecies(ModelPreset preset = ModelPreset.Physical)
        {
            var species = ScriptableObject.CreateInstance<WingSpecies>();
            Author(species);
            if (preset == ModelPreset.Paper)
            {
                species.ApplyPreset(preset);
            }

            return species;
        }

        /// <summary>The base of the wing on the body, in mesh units.</summary>
        public Vector3 HingeOn(WingSide side, float unitsPerMetre = SpeciesDefinition.UnitsPerMetre)
        {
            return new Vector3(side == WingSide.Right ? Hinge.x : -Hinge.x, Hinge.y, Hinge.z) * unitsPerMetre;
        }

        /// <summary>The wing's surface at rest around its base, <see cref="TriangleCount"/> triangles.</summary>
        public SurfaceMesh CreateSurface(WingSide side, float unitsPerMetre = SpeciesDefinition.UnitsPerMetre)
        {
            var scale = (float)Outline.Length * unitsPerMetre;
            var surface = IsFilled ? WingMesher.Fill(Contour, Scallops, TriangleCount, scale) : WingMesher.Strips(Contour, TriangleCount, scale);
            var spacing = Math.Sqrt(2 * Contour.Area / TriangleCount);
            surface.colours = Pattern?.ColourVertices(surface, scale, spacing);
            return side == WingSide.Right ? surface : surface.Mirrored();
        }

        /// <summary>The wing's skeleton in the space of <see cref="CreateSurface"/>.</summary>
        public WingSkeleton CreateSkeleton(WingSide side, float unitsPerMetre = SpeciesDefinition.UnitsPerMetre)
        {
            return SkeletonGenerator.Generate(
                Outline, Chains, JointsPerChain, LastTipSpan, (float)Outline.Length * unitsPerMetre, side);
        }
    }
}
