using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// A dragonfly's body, 75 mm long: a head of two large eyes, a high thorax, and a long thin abdomen. Dark with green flanks and pale
    /// blue spots along the abdomen. Proportions and colours chosen by us.
    /// </summary>
    internal static class DragonflyBody
    {
        private const float k_AbdomenRings = 10f;

        private static readonly Color32 s_Dark = new Color32(44, 38, 34, 255);
        private static readonly Color32 s_Green = new Color32(120, 160, 60, 255);
        private static readonly Color32 s_Blue = new Color32(90, 140, 190, 255);
        private static readonly Color32 s_Eye = new Color32(58, 104, 138, 255);
        private static readonly Color32 s_EyeBelow = new Color32(112, 132, 84, 255);

        private static readonly CrossSection[] s_Thorax =
        {
            new CrossSection(new Vector3(0f, 0f, 10.2f), 0f, 0f, 0f),
            new CrossSection(new Vector3(0f, 0f, 9.4f), 1.7f, 1.7f, 1.7f),
            new CrossSection(new Vector3(0f, -0.3f, 6.5f), 3f, 3.5f, 3.4f),
            new CrossSection(new Vector3(0f, -0.4f, 2.5f), 3.4f, 4.1f, 4.2f),
            new CrossSection(new Vector3(0f, -0.2f, -1.5f), 3.3f, 3.8f, 4f),
            new CrossSection(new Vector3(0f, 0f, -5f), 2.6f, 2.8f, 3f),
            new CrossSection(new Vector3(0f, 0.2f, -8f), 1.6f, 1.7f, 1.8f),
            new CrossSection(new Vector3(0f, 0.2f, -9f), 0f, 0f, 0f),
        };

        private static readonly CrossSection[] s_Head =
        {
            new CrossSection(new Vector3(0f, 0.2f, 9.6f), 0f, 0f, 0f),
            new CrossSection(new Vector3(0f, 0.2f, 10.4f), 2.2f, 1.5f, 1.6f),
            new CrossSection(new Vector3(0f, 0.2f, 13f), 2.8f, 2f, 2.2f),
            new CrossSection(new Vector3(0f, -0.3f, 15.6f), 1.7f, 1.3f, 1.5f),
            new CrossSection(new Vector3(0f, -0.5f, 16.6f), 0f, 0f, 0f),
        };

        private static readonly CrossSection[] s_Abdomen =
        {
            new CrossSection(new Vector3(0f, 0.1f, -6.5f), 0f, 0f, 0f),
            new CrossSection(new Vector3(0f, 0.1f, -8f), 1.7f, 1.7f, 1.8f),
            new CrossSection(new Vector3(0f, 0.2f, -13f), 1.25f, 1.25f, 1.3f),
            new CrossSection(new Vector3(0f, 0.2f, -30f), 1.5f, 1.4f, 1.5f),
            new CrossSection(new Vector3(0f, 0f, -46f), 1.35f, 1.2f, 1.3f),
            new CrossSection(new Vector3(0f, -0.2f, -54f), 0.9f, 0.8f, 0.9f),
            new CrossSection(new Vector3(0f, -0.2f, -58.4f), 0f, 0f, 0f),
        };

        private static readonly Vector3[][] s_Legs =
        {
            new[] { new Vector3(1.2f, -3f, 8f), new Vector3(3.4f, -5f, 9.6f), new Vector3(3.2f, -7.6f, 8.2f), new Vector3(3.1f, -9f, 8.6f),
                new Vector3(3.1f, -9.5f, 9.2f) },
            new[] { new Vector3(1.4f, -3.6f, 6f), new Vector3(4.2f, -5.4f, 5.4f), new Vector3(4.2f, -8f, 3.8f),
                new Vector3(4.2f, -9f, 3.8f), new Vector3(4.2f, -9.5f, 4.4f) },
            new[] { new Vector3(1.4f, -4f, 3.6f), new Vector3(4.4f, -5.6f, 1.4f), new Vector3(4.4f, -8f, -0.4f),
                new Vector3(4.6f, -9f, -0.6f), new Vector3(4.6f, -9.5f, -1.2f) },
        };

        private static readonly Vector3[] s_Clasper =
        {
            new Vector3(0.25f, 0.1f, -57.2f), new Vector3(0.5f, 0.35f, -58.8f), new Vector3(0.85f, 0.3f, -60.2f),
            new Vector3(0.6f, 0.05f, -61.6f),
        };

        public static InsectBody Create(WingDefinition fore, WingDefinition hind) =>
            new InsectBody(parts => Build(parts, fore.CreateSeat(), hind.CreateSeat()));

        private static void Build(BodyParts parts, HingeSeat fore, HingeSeat hind)
        {
            // Finer than elsewhere: the roots of the wings are a tenth of the thorax.
            parts.Add(hind.Press(fore.Press(Trunk.Through(s_Thorax, 34, 32))), Flanks);
            parts.Add(
                Trunk.Through(s_Head, 16, 18), (in BodyPoint point) => Tint.Mix(s_Green, s_Dark, Tint.Below(point.Around, 0.4f, 0.3f)));
            parts.AddPair(
                Ellipsoid.Around(new Vector3(2.1f, 0.9f, 12.6f), new Vector3(1.9f, 2f, 2.3f), 12, 16), Eye);
            parts.AddAbdomen(Trunk.Through(s_Abdomen, 60, 14, ButterflyParts.Rings(k_AbdomenRings, 0.06f)), Spotted);
            parts.AddAbdomenPair(Stalk.Along(s_Clasper, at => 0.16f + 0.34f * at * (1f - at), 5, 6), (in BodyPoint point) => s_Dark);
            ButterflyParts.AddLegs(parts, s_Legs, 0.28f, (in BodyPoint point) => s_Dark);
        }

        // Blue above, green below, dark towards the back of the head.
        private static Color32 Eye(in BodyPoint point)
        {
            Color32 colour = Tint.Mix(s_Eye, s_EyeBelow, Tint.Below(point.Place.y, 0.5f, 1.6f));
            return Tint.Mix(colour, s_Dark, Tint.Below(point.Place.z, 11.3f, 1.2f));
        }

        // Green stripes on each flank.
        private static Color32 Flanks(in BodyPoint point)
        {
            float stripe = Tint.Below(Mathf.Abs((point.Place.z + 0.6f * point.Place.y + 20f) % 5f - 2f), 0.9f, 0.5f) * Tint.Below(
                0.3f, point.Around, 0.15f);
            return Tint.Mix(s_Dark, s_Green, stripe);
        }

        // A pair of spots on each ring.
        private static Color32 Spotted(in BodyPoint point)
        {
            float ring = k_AbdomenRings * point.Along % 1f;
            float spot = Tint.Below(Mathf.Abs(ring - 0.4f), 0.22f, 0.15f) * Tint.Below(Mathf.Abs(point.Around - 0.3f), 0.16f, 0.1f);
            return Tint.Mix(s_Dark, s_Blue, spot);
        }
    }
}
