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
        private readonly MeshedWing m_Shape;

        /// <param name="name">What the wing is called.</param>
        /// <param name="outline">The measured outline.</param>
        /// <param name="author">Sets what differs from <see cref="WingPreset"/>' own defaults, in every variant.</param>
        internal WingDefinition(string name, WingOutline outline, Action<WingPreset> author)
        {
            Name = name;
            Outline = outline;
            Contour = outline.Smoothed();
            Length = outline.Length;
            m_Changes.Add(author);
        }

        /// <summary>A wing of another insect: the numbers of a wing, and its shape in another size or another one.</summary>
        /// <param name="name">What the wing is called.</param>
        /// <param name="model">The wing whose variants and, where no other is given, whose shape it has.</param>
        /// <param name="length">Metres from hinge to tip.</param>
        /// <param name="shape">A shape of its own; null for the model's.</param>
        internal WingDefinition(string name, WingDefinition model, double length, MeshedWing shape)
        {
            Name = name;
            Length = length;
            m_Variants = new List<InsectVariant>(model.m_Variants);
            m_Changes = new List<Action<WingPreset>>(model.m_Changes);
            Hinge = model.Hinge;
            m_Shape = shape ?? model.m_Shape;
            if (m_Shape != null)
            {
                TriangleCount = m_Shape.Surface.TriangleCount;
                JointsPerChain = m_Shape.Chains[0].Length;
                return;
            }

            Outline = model.Outline.At(length);
            Contour = model.Contour.At(length);
            TriangleCount = model.TriangleCount;
            JointsPerChain = model.JointsPerChain;
            LastTipSpan = model.LastTipSpan;
            ChainPaths = model.ChainPaths;
            Pattern = model.Pattern;
            IsFilled = model.IsFilled;
            Scallops = model.Scallops;
        }

        /// <summary>Name of the wing among the species' wings: "wing", "fore wing", "hind wing", "fin".</summary>
        public string Name { get; }

        /// <summary>Metres from the base to the tip of the shape; a preset may have wings of another length.</summary>
        internal double Length { get; }

        /// <summary>
        /// The measured outline, straight between its landmarks; the skeleton follows it. Null for a wing that is a mesh of its own.
        /// </summary>
        public WingOutline Outline { get; }

        /// <summary>Outline with rounded corners, which the mesh fills; null for a wing that is a mesh of its own.</summary>
        public WingOutline Contour { get; }

        /// <summary>Triangles of one wing.</summary>
        public int TriangleCount { get; internal set; }

        /// <summary>Chains of the skeleton.</summary>
        public int Chains => m_Shape?.Chains.Length ?? ChainPaths?.Length ?? k_Chains;

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

        /// <summary>The picture of the pattern that was painted last.</summary>
        internal KeptPicture Painted { get; } = new KeptPicture();

        /// <summary>The meshed outline; wings of one model may share it.</summary>
        internal KeptSurface Meshed { get; set; } = new KeptSurface();

        /// <summary>Smooth margin of the meshed outline.</summary>
        internal MarginCut Margin
        {
            get
            {
                float scale = (float)Length * InsectDefinition.UnitsPerMetre;
                return Meshed.Get(this, scale).Margin;
            }
        }

        /// <summary>A picture for the texture coordinates of the mesh, a PNG file; null for none.</summary>
        internal byte[] Picture { get; set; }

        /// <summary>[chain] Measured stiffness and widths of veins, in place of the skeleton's; null for those.</summary>
        internal VeinMeasures[] Veins { get; set; }

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

        /// <summary>Length of the wing in a preset, metres.</summary>
        internal float PresetLength(InsectVariant variant = InsectVariant.Standard)
        {
            WingPreset preset = CreatePreset(variant: variant);
            float length = preset.WingLength;
            UnityEngine.Object.DestroyImmediate(preset);
            return length;
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
            float scale = (float)Length * unitsPerMetre;
            if (m_Shape != null)
            {
                SurfaceMesh own = m_Shape.CreateSurface(scale, Name);
                return side == WingSide.Right ? own : own.Mirrored();
            }

            MadeSurface made = Meshed.Get(this, scale);
            return side == WingSide.Right ? made.Copy() : made.Surface.Mirrored();
        }

        /// <summary>The wing's skeleton in the space of <see cref="CreateSurface"/>.</summary>
        public WingSkeleton CreateSkeleton(WingSide side, float unitsPerMetre = InsectDefinition.UnitsPerMetre)
        {
            float scale = (float)Length * unitsPerMetre;
            WingSkeleton skeleton = m_Shape != null ? m_Shape.CreateSkeleton(scale, side)
                : ChainPaths == null ? SkeletonGenerator.Generate(Outline, Chains, JointsPerChain, LastTipSpan, scale, side)
                : SkeletonGenerator.Generate(Contour, ChainPaths, JointsPerChain, scale, side);
            for (int chain = 0; Veins != null && chain < skeleton.Chains.Length; chain++)
                Veins[chain].WriteTo(ref skeleton.Chains[chain]);
            return skeleton;
        }

        /// <summary>
        /// Paints the pattern for the texture coordinates of the mesh, cut along <see cref="Margin"/>, row by row from v = 0.
        /// </summary>
        /// <param name="width">Columns, 1 or more.</param>
        /// <param name="height">Rows, 1 or more.</param>
        internal Color32[] Paint(int width, int height)
        {
            Color32[] pixels = Pattern.Paint(Contour, width, height);
            Margin.Apply(pixels, width, Contour);
            return pixels;
        }

        /// <summary>Adds a variant by the changes it makes to the standard one.</summary>
        internal WingDefinition With(InsectVariant variant, Action<WingPreset> change)
        {
            m_Variants.Add(variant);
            m_Changes.Add(change);
            return this;
        }

        /// <summary>Adds changes to the standard numbers, which hold in every variant that does not change them after that.</summary>
        /// <param name="change">The changes.</param>
        internal void Change(Action<WingPreset> change)
        {
            for (int k = 0; k < m_Changes.Count; k++)
                m_Changes[k] += change;
        }

        /// <summary>Adds changes to a variant, which the wing gets where it has none.</summary>
        internal void Change(InsectVariant variant, Action<WingPreset> change)
        {
            int k = m_Variants.IndexOf(variant);
            if (k < 0)
                With(variant, change);
            else
                m_Changes[k] += change;
        }
    }
}
