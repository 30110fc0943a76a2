using System;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// A fishfly's body, 33 mm long without the antennae: a flat head, a square fore thorax like a neck, and a long soft abdomen. The
    /// antennae are combs, as those of a male Chauliodes. Dull brown with ochre. Proportions chosen by us.
    /// </summary>
    internal static class FishflyBody
    {
        private const float k_AbdomenRings = 9f;
        private const int k_Teeth = 26;

        private static readonly Color32 s_Brown = new Color32(92, 76, 60, 255);
        private static readonly Color32 s_Ochre = new Color32(186, 158, 112, 255);
        private static readonly Color32 s_Dark = new Color32(48, 40, 34, 255);
        private static readonly Color32 s_Skin = new Color32(134, 116, 92, 255);
        private static readonly Color32 s_Eye = new Color32(34, 30, 30, 255);

        private static readonly CrossSection[] s_Thorax =
        {
            new CrossSection(new Vector3(0f, 0f, 5.6f), 0f, 0f, 0f),
            new CrossSection(new Vector3(0f, 0.1f, 4.8f), 1.7f, 1.5f, 1.5f),
            new CrossSection(new Vector3(0f, 0f, 2.8f), 2.4f, 2.45f, 2.1f),
            new CrossSection(new Vector3(0f, 0f, 0.3f), 2.3f, 2.15f, 2.1f),
            new CrossSection(new Vector3(0f, 0f, -2.2f), 2.35f, 2.3f, 2.05f),
            new CrossSection(new Vector3(0f, -0.1f, -4.4f), 1.7f, 1.5f, 1.65f),
            new CrossSection(new Vector3(0f, -0.2f, -5.4f), 0f, 0f, 0f),
        };

        private static readonly CrossSection[] s_Prothorax =
        {
            new CrossSection(new Vector3(0f, 0f, 4.2f), 0f, 0f, 0f),
            new CrossSection(new Vector3(0f, 0.05f, 4.8f), 1.5f, 0.95f, 1.05f),
            new CrossSection(new Vector3(0f, 0.15f, 5.6f), 1.6f, 1f, 1.1f),
            new CrossSection(new Vector3(0f, 0.3f, 8f), 1.5f, 0.95f, 1.05f),
            new CrossSection(new Vector3(0f, 0.35f, 8.9f), 1.35f, 0.85f, 0.95f),
            new CrossSection(new Vector3(0f, 0.35f, 9.4f), 0f, 0f, 0f),
        };

        private static readonly CrossSection[] s_Head =
        {
            new CrossSection(new Vector3(0f, 0.3f, 8.4f), 0f, 0f, 0f),
            new CrossSection(new Vector3(0f, 0.3f, 9.2f), 1.45f, 0.9f, 0.95f),
            new CrossSection(new Vector3(0f, 0.25f, 10.5f), 1.95f, 1f, 1.1f),
            new CrossSection(new Vector3(0f, 0.1f, 11.8f), 1.55f, 0.8f, 0.95f),
            new CrossSection(new Vector3(0f, -0.1f, 12.7f), 0.9f, 0.45f, 0.6f),
            new CrossSection(new Vector3(0f, -0.2f, 13.1f), 0f, 0f, 0f),
        };

        private static readonly CrossSection[] s_Abdomen =
        {
            new CrossSection(new Vector3(0f, -0.1f, -3.4f), 0f, 0f, 0f),
            new CrossSection(new Vector3(0f, -0.1f, -4.6f), 1.5f, 1.25f, 1.4f),
            new CrossSection(new Vector3(0f, -0.3f, -9f), 1.7f, 1.35f, 1.5f),
            new CrossSection(new Vector3(0f, -0.9f, -14f), 1.45f, 1.2f, 1.3f),
            new CrossSection(new Vector3(0f, -1.7f, -18.2f), 1f, 0.9f, 0.95f),
            new CrossSection(new Vector3(0f, -2.2f, -20f), 0f, 0f, 0f),
        };

        private static readonly Vector3[] s_Antenna =
        {
            new Vector3(0.75f, 0.75f, 11.8f), new Vector3(1.8f, 2.2f, 15.5f), new Vector3(5f, 2.4f, 20f), new Vector3(8.6f, 1.2f, 23f),
        };

        private static readonly Vector3[][] s_Legs =
        {
            new[]
            {
                new Vector3(1f, -0.6f, 6.2f), new Vector3(3.4f, -2.2f, 8.4f), new Vector3(3.9f, -4.8f, 5.8f),
                new Vector3(3.7f, -5.5f, 3.9f), new Vector3(3.7f, -6f, 3f),
            },
            new[]
            {
                new Vector3(1f, -1.8f, 2.4f), new Vector3(3.9f, -3.4f, 3.6f), new Vector3(4.2f, -5.6f, 0.2f), new Vector3(3.8f, -6f, -2f),
                new Vector3(3.8f, -6.5f, -3f),
            },
            new[]
            {
                new Vector3(1f, -1.7f, -2.4f), new Vector3(3.9f, -3.2f, -2.2f), new Vector3(3.6f, -4.4f, -7f),
                new Vector3(3.2f, -4.6f, -9.4f), new Vector3(3.2f, -5.1f, -10.4f),
            },
        };

        public static InsectBody Create(WingDefinition fore, WingDefinition hind) =>
            new InsectBody(parts => Build(parts, fore.CreateSeat(), hind.CreateSeat()));

        private static void Build(BodyParts parts, HingeSeat fore, HingeSeat hind)
        {
            parts.Add(hind.Press(fore.Press(Trunk.Through(s_Thorax, 26, 20))), Marked);
            parts.Add(Trunk.Through(s_Prothorax, 14, 18), Marked);
            parts.Add(Trunk.Through(s_Head, 14, 18), Marked);
            parts.AddPair(
                Ellipsoid.Around(new Vector3(1.75f, 0.35f, 10.9f), new Vector3(0.62f, 0.7f, 0.8f), 8, 12), (in BodyPoint point) => s_Eye);
            parts.AddAbdomen(Trunk.Through(s_Abdomen, 50, 16, ButterflyParts.Rings(k_AbdomenRings, 0.1f)), Soft);
            parts.AddPair(Stalk.Along(s_Antenna, t => 0.13f - 0.08f * t, 26, 6), (in BodyPoint point) => s_Dark);
            parts.AddPair(Comb.Along(s_Antenna, k_Teeth, ToothLength, 0.07f, false), (in BodyPoint point) => s_Dark);
            ButterflyParts.AddLegs(parts, s_Legs, 0.24f, (in BodyPoint point) => Tint.Mix(s_Ochre, s_Brown, 2f * point.Along));
        }

        // Longest in the middle of the antenna.
        private static float ToothLength(float t) => 1.5f * (float)Math.Pow(Math.Sin(Math.PI * (0.12 + 0.82 * t)), 0.6);

        // Ochre lines along the middle of head and thorax, and dark flecks beside them.
        private static Color32 Marked(in BodyPoint point)
        {
            float line = Tint.Below(point.Place.x, 0.22f, 0.25f) * Tint.Below(point.Around, 0.5f, 0.3f);
            float fleck = 0.7f * Tint.Below(Mathf.Abs(point.Place.x - 0.9f), 0.3f, 0.3f) * Tint.Below(point.Around, 0.5f, 0.2f);
            float side = 0.6f * Tint.Below(0.6f, point.Around, 0.3f);
            return Tint.Mix(Tint.Mix(Tint.Mix(s_Brown, s_Dark, fleck), s_Skin, side), s_Ochre, line);
        }

        private static Color32 Soft(in BodyPoint point)
        {
            float plate = Tint.Below(point.Around, 0.42f, 0.2f) * Tint.Below(k_AbdomenRings * point.Along % 1f, 0.72f, 0.3f);
            return Tint.Mix(s_Skin, s_Brown, plate);
        }
    }
}
