using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// A monarch's body, 29 mm long: black, with white dots on head and thorax, a paler belly, and four legs, since a monarch folds its
    /// fore legs away. Proportions chosen by us.
    /// </summary>
    internal static class MonarchBody
    {
        private const float k_DotRadius = 0.4f, k_AbdomenRings = 8f;
        private const int k_DottedRings = 7;

        private static readonly Color32 s_Black = new Color32(36, 32, 32, 255);
        private static readonly Color32 s_Fur = new Color32(84, 74, 66, 255);
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

        private static readonly Vector3[] s_HeadDots =
        {
            new Vector3(0.55f, 1.25f, 4.7f), new Vector3(1f, 0.75f, 4.5f), new Vector3(0.35f, 1.1f, 5.8f), new Vector3(0.9f, -0.85f, 5.5f),
            new Vector3(0.4f, -0.3f, 6.4f), new Vector3(0.8f, -0.6f, 4.4f),
        };

        // In rows down the side, below the wing's root, and a pair on the collar.
        private static readonly Vector3[] s_ThoraxDots =
        {
            new Vector3(0.85f, 1.5f, 2.9f), new Vector3(1.6f, 0.9f, 2.7f), new Vector3(1.5f, 0.1f, 3.2f), new Vector3(1.3f, -0.8f, 3f),
            new Vector3(1.9f, -0.2f, 2f), new Vector3(1.6f, -1.1f, 2f), new Vector3(1.95f, -0.9f, 1f), new Vector3(1.2f, -1.9f, 1.1f),
            new Vector3(2f, -0.5f, 0.1f), new Vector3(1.6f, -1.7f, -0.1f), new Vector3(2f, -0.7f, -1f), new Vector3(1.3f, -1.9f, -1.3f),
            new Vector3(1.85f, -0.1f, -2f), new Vector3(1.6f, -1.1f, -2.1f), new Vector3(1.5f, 0.5f, -2.9f),
            new Vector3(1.3f, -1.1f, -3.1f),
        };

        public static InsectBody Create(WingDefinition wing) => new InsectBody(parts => Build(parts, wing.CreateSeat()));

        private static void Build(BodyParts parts, HingeSeat seat)
        {
            BodyPatch thorax = parts.Add(seat.Press(Trunk.Through(s_Thorax, 20, 22)), (in BodyPoint point) => s_Black);
            var fur = new Fur { Count = 64, Length = 0.7f, Radius = 0.09f, Seed = 11, Where = place => place.y > 1.2f || place.y < -1.4f };
            parts.AddFur(thorax, fur.GrowOn(thorax.part), (in BodyPoint point) => Tint.Mix(s_Black, s_Fur, Ink.Speckle(point.Place)));
            BodyPatch abdomen = parts.AddAbdomen(
                Trunk.Through(s_Abdomen, 36, 16, ButterflyParts.Rings(k_AbdomenRings, 0.07f)), Segmented);
            parts.AddAbdomenPair(Tufts.On(abdomen.part, AbdomenDots(), 0.45f * k_DotRadius), (in BodyPoint point) => s_Dot);
            BodyPatch head = ButterflyParts.AddHead(
                parts, new Vector3(0f, 0.15f, 5.1f), 1.35f, (in BodyPoint point) => s_Black, (in BodyPoint point) => s_Eye);
            parts.AddPair(Tufts.On(thorax.part, s_ThoraxDots, k_DotRadius), (in BodyPoint point) => s_Dot);
            parts.AddPair(Tufts.On(head.part, s_HeadDots, 0.6f * k_DotRadius), (in BodyPoint point) => s_Dot);
            ButterflyParts.AddTongue(parts, new Vector3(0f, -0.85f, 6.9f), 0.62f, s_Black);
            ButterflyParts.AddAntennae(parts, s_Antenna, 0.11f, 0.27f, (in BodyPoint point) => s_Black);
            ButterflyParts.AddLegs(parts, s_Legs, 0.24f, (in BodyPoint point) => s_Black);
        }

        // Two rows down each side, a dot on every ring.
        private static Vector3[] AbdomenDots()
        {
            var dots = new Vector3[2 * k_DottedRings];
            for (int ring = 0; ring < k_DottedRings; ring++)
            {
                float along = (float)ring / (k_DottedRings - 1), middle = -0.4f - 1.3f * along * along, z = -5.2f - 14.4f * along;
                dots[2 * ring] = new Vector3(1.5f - 0.4f * along, middle + 0.5f, z);
                dots[2 * ring + 1] = new Vector3(1.3f - 0.4f * along, middle - 0.9f + 0.2f * along, z);
            }

            return dots;
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
