using System.Collections.Generic;
using Alate.Catalogue;
using Alate.Fitting;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>A wing of a species in level flight: with the skeleton that its author made, and with the fitted one.</summary>
    internal sealed class FittedFlight
    {
        private const float k_CruiseShare = 0.65f;

        private static readonly Dictionary<(WingDefinition, bool), FittedFlight> s_Flown =
            new Dictionary<(WingDefinition, bool), FittedFlight>();

        private readonly WingDefinition m_Wing;
        private readonly WingPreset m_Preset;
        private readonly SurfaceMesh m_Mesh;
        private readonly WingFrame m_Frame;
        private readonly bool m_ByFirstOrder;

        private FittedFlight(WingDefinition wing, bool byFirstOrder)
        {
            m_Wing = wing;
            m_Preset = wing.CreatePreset();
            m_ByFirstOrder = byFirstOrder;
            m_Mesh = wing.CreateSurface(WingSide.Right);
            WingSkeleton hand = wing.CreateSkeleton(WingSide.Right);
            WingRig rig = Bake(hand);
            m_Frame = rig.Frame;
            ByHand = Measure(rig);
            Fit = SkeletonFitter.Fit(Surface, Hints(wing));
            Fitted = Measure(Bake(Fit.Skeleton));
        }

        /// <summary>Flight of a wing, flown once for all tests.</summary>
        /// <param name="wing">Whose.</param>
        /// <param name="byFirstOrder">By <see cref="SpeciesFlight.FirstOrder"/>, whose delays do not depend on how close chains
        /// are.</param>
        public static FittedFlight Of(WingDefinition wing, bool byFirstOrder = false)
        {
            if (!s_Flown.TryGetValue((wing, byFirstOrder), out FittedFlight flight))
                s_Flown.Add((wing, byFirstOrder), flight = new FittedFlight(wing, byFirstOrder));
            return flight;
        }

        /// <summary>The automatic skeleton.</summary>
        public SkeletonFit Fit { get; }

        /// <summary>The last of eight beats of either; both seen in the frame of the author's skeleton.</summary>
        public WingDeformation ByHand { get; }
        public WingDeformation Fitted { get; }

        /// <summary>Hints of a user: the side of the body, and as many chains and joints as the author has.</summary>
        public static SkeletonFitSettings Hints(WingDefinition wing)
        {
            SkeletonFitSettings hints = SkeletonFitSettings.Default;
            hints.bodySide = Vector3.left;
            hints.chains = wing.Chains;
            hints.jointsPerChain = wing.JointsPerChain;
            return hints;
        }

        private SurfaceMesh Surface => m_Mesh;

        private WingRig Bake(WingSkeleton skeleton) => WingRig.Bake(skeleton, Surface, WingRigSettings.Default);

        private WingDeformation Measure(WingRig rig)
        {
            const float k_Gravity = 9.81f;
            float speed = k_CruiseShare * m_Preset.Beat.maxSpeed, length = m_Preset.WingLength;
            var surroundings = new WingSurroundings
            {
                wind = new float3(0f, 0f, -speed / length),
                gravity = new float3(0f, -k_Gravity * m_Preset.Size.gravityShare / length, 0f),
                speed = speed,
            };
            WingParameters parameters = m_Preset.ToParameters();
            return FlownBeat.Measure(
                m_Mesh, rig, m_ByFirstOrder ? SpeciesFlight.FirstOrder(parameters) : parameters, surroundings, m_Frame);
        }
    }
}
