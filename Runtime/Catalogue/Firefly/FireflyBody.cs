using System;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// A firefly's body, 12 mm long: a flat shield with a dark spot covers the head, dark wing cases with pale rims are held open and up,
    /// ahead of the beating wings, and the last rings of the soft abdomen are the lantern. Proportions chosen by us, after the look of
    /// Photinus.
    /// </summary>
    internal static class FireflyBody
    {
        private const float k_AbdomenRings = 7f, k_LanternStart = 5f, k_CaseLength = 8.6f;

        /// <summary>Share of the rim's colour in the pale line down the middle of a wing case.</summary>
        private const float k_Stripe = 0.45f;

        private static readonly Color32 s_Brown = new Color32(58, 45, 38, 255);
        private static readonly Color32 s_Case = new Color32(52, 42, 38, 255);
        private static readonly Color32 s_CaseInside = new Color32(112, 92, 76, 255);
        private static readonly Color32 s_Rim = new Color32(214, 188, 128, 255);
        private static readonly Color32 s_Rose = new Color32(212, 112, 86, 255);
        private static readonly Color32 s_Eye = new Color32(24, 22, 24, 255);
        private static readonly Color32 s_Lantern = new Color32(236, 246, 148, 255);
        private static readonly Color32 s_LanternEdge = new Color32(206, 206, 118, 255);

        private static readonly CrossSection[] s_Thorax =
        {
            new CrossSection(new Vector3(0f, 0f, 2.6f), 0f, 0f, 0f),
            new CrossSection(new Vector3(0f, 0f, 2.1f), 1.05f, 0.7f, 0.85f),
            new CrossSection(new Vector3(0f, 0f, 0.9f), 1.4f, 1.05f, 1.2f),
            new CrossSection(new Vector3(0f, 0f, -0.8f), 1.45f, 1.05f, 1.25f),
            new CrossSection(new Vector3(0f, -0.05f, -2f), 1.2f, 0.85f, 1f),
            new CrossSection(new Vector3(0f, -0.1f, -2.7f), 0f, 0f, 0f),
        };

        private static readonly CrossSection[] s_Abdomen =
        {
            new CrossSection(new Vector3(0f, -0.1f, -1.3f), 0f, 0f, 0f),
            new CrossSection(new Vector3(0f, -0.1f, -2f), 1.25f, 0.7f, 0.8f),
            new CrossSection(new Vector3(0f, -0.15f, -4f), 1.45f, 0.7f, 0.8f),
            new CrossSection(new Vector3(0f, -0.25f, -6.2f), 1.3f, 0.65f, 0.75f),
            new CrossSection(new Vector3(0f, -0.4f, -7.8f), 0.9f, 0.5f, 0.6f),
            new CrossSection(new Vector3(0f, -0.5f, -8.6f), 0f, 0f, 0f),
        };

        private static readonly Vector3 s_CaseBase = new Vector3(0.95f, 0.95f, 1.75f);
        private static readonly Vector3 s_CaseAlong = k_CaseLength * new Vector3(0.76f, 0.6f, 0.25f);
        private static readonly Vector3 s_CaseUp = new Vector3(-0.55f, 0.75f, 0.2f);

        private static readonly Vector3[] s_Antenna =
        {
            new Vector3(0.35f, -0.35f, 4.3f), new Vector3(0.9f, 0.1f, 5.8f), new Vector3(2f, 0.5f, 7.2f), new Vector3(3.4f, 0.4f, 8f),
        };

        private static readonly Vector3[][] s_Legs =
        {
            new[]
            {
                new Vector3(0.6f, -0.7f, 2f), new Vector3(1.7f, -1.2f, 3f), new Vector3(1.9f, -2.4f, 2.1f), new Vector3(1.8f, -2.8f, 1.2f),
                new Vector3(1.8f, -3f, 0.9f),
            },
            new[]
            {
                new Vector3(0.7f, -1f, 0.6f), new Vector3(2f, -1.7f, 1f), new Vector3(2.1f, -2.9f, -0.5f), new Vector3(1.9f, -3.1f, -1.6f),
                new Vector3(1.9f, -3.3f, -2f),
            },
            new[]
            {
                new Vector3(0.7f, -1f, -1f), new Vector3(2f, -1.6f, -1.4f), new Vector3(1.9f, -2.3f, -3.4f),
                new Vector3(1.7f, -2.4f, -4.6f), new Vector3(1.7f, -2.6f, -5f),
            },
        };

        public static InsectBody Create(WingDefinition wing) => new InsectBody(parts => Build(parts, wing.CreateSeat()));

        private static void Build(BodyParts parts, HingeSeat seat)
        {
            parts.Add(seat.Press(Trunk.Through(s_Thorax, 16, 18)), (in BodyPoint point) => s_Brown);
            parts.AddAbdomen(Trunk.Through(s_Abdomen, 36, 16, ButterflyParts.Rings(k_AbdomenRings, 0.08f)), Lit);
            parts.Add(
                Ellipsoid.Around(new Vector3(0f, -0.15f, 2.6f), new Vector3(1.15f, 0.75f, 1.3f), 8, 12), (in BodyPoint point) => s_Brown);
            parts.Add(
                Ellipsoid.Around(new Vector3(0f, -0.35f, 3.7f), new Vector3(0.85f, 0.6f, 0.9f), 7, 12), (in BodyPoint point) => s_Brown);
            parts.AddPair(
                Ellipsoid.Around(new Vector3(0.62f, -0.45f, 3.9f), new Vector3(0.48f, 0.48f, 0.5f), 7, 10), (in BodyPoint point) => s_Eye);
            parts.Add(Shield(), Spotted);
            parts.AddPair(Case(), Rimmed);
            parts.AddPair(Stalk.Along(s_Antenna, Beaded, 33, 6), (in BodyPoint point) => s_Brown);
            ButterflyParts.AddLegs(parts, s_Legs, 0.2f, (in BodyPoint point) => s_Brown);
        }

        // A half disc: straight behind, round in front.
        private static BodyPart Shield() =>
            Shell.Along(
                new Vector3(0f, 0.55f, 1.85f), new Vector3(0f, -0.35f, 3.3f), new Vector3(0f, 1f, 0f),
                t => 1.95f * (float)Math.Pow(1 - Math.Pow(t, 2.2), 0.5) * Math.Min(1f, 6f * (float)Math.Sqrt(t)), 0.28f, 0.16f,
                0.2f, 19, 26);

        // Nearly as wide as long sides can be, rounded at the end.
        private static BodyPart Case() =>
            Shell.Along(
                s_CaseBase, s_CaseAlong, s_CaseUp,
                t => 1.12f * (float)Math.Pow(1 - Math.Pow(t, 4), 0.5) * (float)Math.Pow(Math.Min(1, 0.12 + 4 * t), 0.4), 0.34f,
                0.14f, 0.45f, 20, 16);

        // Eleven short pieces, thickest at their ends.
        private static float Beaded(float t)
        {
            float within = 11f * t % 1f;
            return (0.13f - 0.05f * t) * (0.82f + 0.3f * within);
        }

        private static Color32 Lit(in BodyPoint point)
        {
            float ring = k_AbdomenRings * point.Along;
            float furrow = 0.5f * Tint.Below(0.82f, ring % 1f, 0.2f);
            Color32 skin = Tint.Mix(s_Brown, s_Rim, Math.Max(furrow, 0.35f * Tint.Below(0.5f, point.Around, 0.2f)));
            Color32 lantern = Tint.Mix(s_Lantern, s_LanternEdge, furrow);
            return Tint.Mix(lantern, skin, Tint.Below(ring, k_LanternStart, 0.25f));
        }

        private static Color32 Spotted(in BodyPoint point)
        {
            float across = point.Place.x;
            float ahead = point.Place.z - 3.1f;
            float away = Mathf.Sqrt(across * across + 0.6f * ahead * ahead);
            float spot = Tint.Below(Mathf.Abs(across), 0.36f, 0.28f) * Tint.Below(point.Place.z, 3.9f, 0.6f);
            float rose = Tint.Below(away, 1.2f, 0.4f);
            return Tint.Mix(Tint.Mix(s_Rim, s_Rose, rose), s_Eye, spot);
        }

        private static Color32 Rimmed(in BodyPoint point)
        {
            float rim = Tint.Below(Mathf.Abs(point.Around - 0.5f), 0.1f, 0.1f);
            float stripe = k_Stripe * Tint.Below(point.Around, 0.05f, 0.08f);
            Color32 face = point.Around < 0.5f ? Tint.Mix(s_Case, s_Rim, stripe) : s_CaseInside;
            return Tint.Mix(face, s_Rim, Mathf.Max(rim, Tint.Below(0.965f, point.Along, 0.03f)));
        }
    }
}
