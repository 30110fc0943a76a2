using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Scripting.APIUpdating;

namespace Alate.Catalogue
{
    /// <summary>
    /// One kind of wing of a species, described for the right side: its outline, where it sits on the body, how finely it is meshed and
    /// jointed, and how it beats. A four-winged insect has two of them.
    /// </summary>
    [MovedFrom(true, "Alate", "Alate", "SpeciesWing")]
    public sealed class WingDefinition
    {
        private const int k_Chains = 5;

        private readonly List<InsectVariant> m_Variants = new List<InsectVariant> { InsectVariant.Standard };
        private readonly List<Action<WingPreset>> m_Changes = new List<Action<WingPreset>>();

        /// <param name="name">What the wing is called.</param>
        /// <param name="outline">The measured outline.</param>
        /// <param name="author">Sets what differs from <see cref="WingPreset"/>' own defaults, in every variant.</param>
        internal WingDefinition(string name, WingOutline outline, Action<WingPreset> author)
        {
            Name = name;
            Outline = outline;
            Contour = outline.Smoothed();
            m_Changes.Add(author);
        }

        /// <summary>Name of the wing among the species' wings: "wing", "fore wing", "hind wing", "fin".</summary>
        public string Name { get; }

        /// <summary>The measured outline, straight between its landmarks; the skeleton follows it.</summary>
        public WingOutline Outline { get; }

        /// <summary>Outline with rounded corners, which the mesh fills.</summary>
        public WingOutline Contour { get; }

        /// <summary>Triangles of one wing.</summary>
        public int TriangleCount { get; internal set; }

        /// <summary>Chains of the skeleton.</summary>
        public int Chains => ChainPaths?.Length ?? k_Chains;

        /// <summary>Joints of each chain, 5 unless the species says otherwise.</summary>
        public int JointsPerChain { get; internal set; } = 5;

        /// <summary>
        /// Span at which the last chain meets the trailing edge, wing lengths, where the chains' tips lie evenly; 0 where they were chosen
        /// one by one.
        /// </summary>
        public double LastTipSpan { get; internal set; }

        /// <summary>
        /// [chain] Place at which each chain runs to the margin of <see cref="Contour"/>; null for tips that lie evenly on
        /// <see cref="Outline"/> from the wing's tip to <see cref="LastTipSpan"/>.
        /// </summary>
        internal ChainPath[] ChainPaths { get; set; }

        /// <summary>
        /// The base of the right wing (the outline's origin) on the body, metres: X right, Y up, Z ahead of the middle of the thorax.
        /// </summary>
        public Vector3 Hinge { get; internal set; }

        /// <summary>The colouring; null leaves the mesh without vertex colours.</summary>
        public WingPattern Pattern { get; internal set; }

        /// <summary>
        /// True for meshes by <see cref="WingMesher.Fill(WingOutline, int, float)"/>, false for <see cref="WingMesher.Strips"/>.
        /// </summary>
        internal bool IsFilled { get; set; } = true;

        /// <summary>Hollows of the margin; null for none.</summary>
        internal RimScallops Scallops { get; set; }

        /// <summary>The variants there are, the standard one first.</summary>
        public IReadOnlyList<InsectVariant> Variants => m_Variants;

        /// <summary>A preset of this wing.</summary>
        /// <param name="reading">How the paper's equations are read; applied last, so that <see cref="ModelReading.Paper"/> sets its delays
        /// and phases in every variant.</param>
        /// <param name="variant">Which numbers of the species are taken.</param>
        /// <exception cref="ArgumentException">The wing has no such variant; the message lists those there are.</exception>
        public WingPreset CreatePreset(ModelReading reading = ModelReading.Physical, InsectVariant variant = InsectVariant.Standard)
        {
            int change = m_Variants.IndexOf(variant);
            if (change < 0)
            {
                throw new ArgumentException(
                    $"The {Name} has no variant '{variant}'. It has: {string.Join(", ", m_Variants)}.", nameof(variant));
            }
            WingPreset preset = ScriptableObject.CreateInstance<WingPreset>();
            m_Changes[0](preset);
            if (change > 0)
                m_Changes[change](preset);
            if (reading == ModelReading.Paper)
                preset.ApplyReading(reading);
            return preset;
        }

        /// <summary>Makes the flat area of the body's side on which the wing sits.</summary>
        internal HingeSeat CreateSeat()
        {
            float length = 1000f * (float)Outline.Length;
            return new HingeSeat(1000f * Hinge, length * (float)Outline.LeadingAt(0), length * (float)Outline.TrailingAt(0));
        }

        /// <summary>The base of the wing on the body, in mesh units.</summary>
        public Vector3 HingeOn(WingSide side, float unitsPerMetre = InsectDefinition.UnitsPerMetre) =>
            new Vector3(side == WingSide.Right ? Hinge.x : -Hinge.x, Hinge.y, Hinge.z) * unitsPerMetre;

        /// <summary>The wing's surface at rest around its base, <see cref="TriangleCount"/> triangles.</summary>
        public SurfaceMesh CreateSurface(WingSide side, float unitsPerMetre = InsectDefinition.UnitsPerMetre)
        {
            float scale = (float)Outline.Length * unitsPerMetre;
            SurfaceMesh surface = IsFilled
                ? WingMesher.Fill(Contour, Scallops, TriangleCount, scale)
                : WingMesher.Strips(Contour, TriangleCount, scale);
            double spacing = Math.Sqrt(2 * Contour.Area / TriangleCount);
            surface.name = Name;
            surface.colours = Pattern?.ColourVertices(surface, scale, spacing);
            return side == WingSide.Right ? surface : surface.Mirrored();
        }

        /// <summary>The wing's skeleton in the space of <see cref="CreateSurface"/>.</summary>
        public WingSkeleton CreateSkeleton(WingSide side, float unitsPerMetre = InsectDefinition.UnitsPerMetre)
        {
            float scale = (float)Outline.Length * unitsPerMetre;
            return ChainPaths == null
                ? SkeletonGenerator.Generate(Outline, Chains, JointsPerChain, LastTipSpan, scale, side)
                : SkeletonGenerator.Generate(Contour, ChainPaths, JointsPerChain, scale, side);
        }

        /// <summary>Adds a variant by the changes it makes to the standard one.</summary>
        internal WingDefinition With(InsectVariant variant, Action<WingPreset> change)
        {
            m_Variants.Add(variant);
            m_Changes.Add(change);
            return this;
        }
    }
}
