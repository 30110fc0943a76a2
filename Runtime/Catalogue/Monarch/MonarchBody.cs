using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// A monarch's body, 29 mm long: black, with white dots on head and thorax, a paler belly, and four legs, since a monarch folds its
    /// fore legs away. Proportions chosen by us.
    /// </summary>
    internal static class MonarchBody
    {
        private const float k_DotRadius = 0.42f, k_AbdomenRings = 8f;

        private static readonly Color32 s_Black = new Color32(36, 32, 32, 255);
        private static readonly Color32 s_Fur = new Color32(52, 44, 42, 255);
        private static readonly Color32 s_Belly = new Color32(108, 92, 80, 255);
        private static readonly Color32 s_Eye = new Color32(58, 34, 24, 255);
        private static readonly Color32 s_Dot = new Color32(240, 234, 222, 255);

        private static readonly CrossSection[] s_Thorax =
        {
            new CrossSection(new Vector3(0f, 0.1f, 4.5f), 0f, 0f, 0f),
            new CrossSection(new Vector3(0f, 0.15f, 3.7f), 1.25f, 1.2f, 1.35f),
            new CrossSection(new Vector3(0f, 0.15f, 2.2f), 1.85f, 1.95f, 2.1f),
            new CrossSection(new Vector3(0f, 0.1f, 0.3f), 2.1f, 2.45f, 2.55f),
            new CrossSection(new Vector3(0f, 0f, -1.8f), 1.95f, 2.25f, 2.4f),
            new CrossSection(new Vector3(0f, -0.2f, -3.4f), 1.5f, 1.6f, 1.9f),
            new CrossSection(new Vector3(0f, -0.4f, -4.6f), 0f, 0f, 0f),
        };

        private static readonly CrossSection[] s_Abdomen =
        {
            new CrossSection(new Vector3(0f, -0.2f, -2.4f), 0f, 0f, 0f),
            new CrossSection(new Vector3(0f, -0.3f, -3.6f), 1.25f, 1.3f, 1.45f),
            new CrossSection(new Vector3(0f, -0.4f, -6.5f), 1.6f, 1.65f, 1.8f),
            new CrossSection(new Vector3(0f, -0.6f, -11f), 1.65f, 1.7f, 1.85f),
            new CrossSection(new Vector3(0f, -1.1f, -16f), 1.4f, 1.4f, 1.55f),
            new CrossSection(new Vector3(0f, -1.7f, -20.2f), 1.1f, 1.05f, 1.15f),
            new CrossSection(new Vector3(0f, -2.1f, -22.4f), 0f, 0f, 0f),
        };

        private static readonly Vector3[] s_Antenna =
        {
            new Vector3(0.45f, 1.1f, 5.7f), new Vector3(1.6f, 2.9f, 9f), new Vector3(3.6f, 4.2f, 13f), new Vector3(5.6f, 4.4f, 17f),
        };

        private static readonly Vector3[][] s_Legs =
        {
            new[]
            {
                new Vector3(0.9f, -1.9f, 1.6f), new Vector3(2.3f, -4.1f, 3.2f), new Vector3(2.2f, -5.5f, -0.9f),
                new Vector3(1.9f, -5.7f, -3.4f), new Vector3(1.8f, -6.1f, -4.6f),
            },
            new[]
            {
                new Vector3(0.9f, -1.9f, -1.2f), new Vector3(2.4f, -3.9f, 0.2f), new Vector3(2.1f, -4.5f, -5f),
                new Vector3(1.8f, -4.3f, -7.8f), new Vector3(1.7f, -4.6f, -9f),
            },
        };

        private static readonly Vector3[] s_Dots =
        {
            new Vector3(1.45f, 1.25f, 2.9f), new Vector3(1.75f, -0.6f, 2.5f), new Vector3(2f, -1f, 0.6f), new Vector3(1.85f, -1.1f, -1.5f),
            new Vector3(1.5f, 1.6f, -1.7f), new Vector3(1f, -1.7f, 2.3f), new Vector3(0.75f, 1f, 4.7f), new Vector3(0.5f, 0.2f, 3.9f),
            new Vector3(0.75f, -0.7f, 5.9f), new Vector3(1.25f, 0.6f, 3.9f),
        };

        public static InsectBody Create(WingDefinition wing) => new InsectBody(parts => Build(parts, wing.CreateSeat()));

        private static void Build(BodyParts parts, HingeSeat seat)
        {
            BodyPatch thorax = parts.Add(seat.Press(Trunk.Through(s_Thorax, 22, 24)), Dotted);
            var fur = new Fur { Count = 110, Length = 0.7f, Radius = 0.09f, Seed = 11, Where = place => place.y > 1.2f || place.y < -1.4f };
            parts.AddFur(thorax, fur.GrowOn(thorax.part), (in BodyPoint point) => Tint.Mix(s_Black, s_Fur, Ink.Speckle(point.Place)));
            parts.AddAbdomen(Trunk.Through(s_Abdomen, 44, 16, ButterflyParts.Rings(k_AbdomenRings, 0.07f)), Segmented);
            ButterflyParts.AddHead(parts, new Vector3(0f, 0.15f, 5.1f), 1.35f, Dotted, (in BodyPoint point) => s_Eye);
            ButterflyParts.AddTongue(parts, new Vector3(0f, -0.85f, 6.9f), 0.62f, s_Black);
            ButterflyParts.AddAntennae(parts, s_Antenna, 0.13f, 0.36f, (in BodyPoint point) => s_Black);
            ButterflyParts.AddLegs(parts, s_Legs, 0.24f, (in BodyPoint point) => s_Black);
        }

        private static Color32 Dotted(in BodyPoint point)
        {
            float share = 0f;
            foreach (Vector3 dot in s_Dots)
                share = Mathf.Max(share, Tint.Spot(point.Place, dot, k_DotRadius, 0.3f));
            return Tint.Mix(s_Black, s_Dot, share);
        }

        private static Color32 Segmented(in BodyPoint point)
        {
            float within = k_AbdomenRings * point.Along % 1f;
            float isBelow = Tint.Below(0.62f, point.Around, 0.2f);
            float band = Tint.Below(0.75f, within, 0.2f);
            return Tint.Mix(s_Black, s_Belly, Mathf.Max(0.55f * isBelow, 0.45f * band));
        }
    }
}
