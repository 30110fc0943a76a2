using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// A swallowtail's body, 27 mm long: yellow, with a broad dark stripe along the back and a thin one along the side, short antennae and
    /// six legs. Proportions chosen by us.
    /// </summary>
    internal static class SwallowtailBody
    {
        private const float k_AbdomenRings = 8f;

        private static readonly Color32 s_Dark = new Color32(38, 33, 30, 255);
        private static readonly Color32 s_Yellow = new Color32(226, 196, 112, 255);
        private static readonly Color32 s_PaleHair = new Color32(238, 218, 150, 255);
        private static readonly Color32 s_Eye = new Color32(48, 38, 32, 255);

        private static readonly CrossSection[] s_Thorax =
        {
            new CrossSection(new Vector3(0f, 0.2f, 4.9f), 0f, 0f, 0f),
            new CrossSection(new Vector3(0f, 0.2f, 4.1f), 1.3f, 1.2f, 1.4f),
            new CrossSection(new Vector3(0f, 0.2f, 2.6f), 2f, 2.05f, 2.2f),
            new CrossSection(new Vector3(0f, 0.1f, 0.3f), 2.25f, 2.6f, 2.7f),
            new CrossSection(new Vector3(0f, 0f, -2f), 2.15f, 2.35f, 2.5f),
            new CrossSection(new Vector3(0f, -0.2f, -3.6f), 1.6f, 1.7f, 2f),
            new CrossSection(new Vector3(0f, -0.4f, -4.8f), 0f, 0f, 0f),
        };

        private static readonly CrossSection[] s_Abdomen =
        {
            new CrossSection(new Vector3(0f, -0.2f, -2.6f), 0f, 0f, 0f),
            new CrossSection(new Vector3(0f, -0.3f, -3.8f), 1.55f, 1.5f, 1.6f),
            new CrossSection(new Vector3(0f, -0.4f, -7f), 1.75f, 1.8f, 1.9f),
            new CrossSection(new Vector3(0f, -0.6f, -11f), 1.75f, 1.75f, 1.85f),
            new CrossSection(new Vector3(0f, -1f, -15f), 1.45f, 1.4f, 1.5f),
            new CrossSection(new Vector3(0f, -1.4f, -18f), 1.05f, 1f, 1.1f),
            new CrossSection(new Vector3(0f, -1.7f, -19.8f), 0f, 0f, 0f),
        };

        private static readonly Vector3[] s_Antenna =
        {
            new Vector3(0.45f, 1.1f, 6.1f), new Vector3(1.5f, 2.9f, 8.8f), new Vector3(2.9f, 4.3f, 12f), new Vector3(4.6f, 4.7f, 15.4f),
        };

        private static readonly Vector3[][] s_Legs =
        {
            new[]
            {
                new Vector3(0.8f, -1.6f, 3.2f), new Vector3(1.9f, -3.2f, 5.4f), new Vector3(1.9f, -5f, 3.4f),
                new Vector3(1.7f, -5.6f, 1.4f), new Vector3(1.6f, -6f, 0.4f),
            },
            new[]
            {
                new Vector3(0.9f, -2.1f, 1.2f), new Vector3(2.6f, -4.3f, 2.8f), new Vector3(2.5f, -5.9f, -1.4f),
                new Vector3(2.2f, -6.1f, -4f), new Vector3(2.1f, -6.5f, -5.2f),
            },
            new[]
            {
                new Vector3(0.9f, -2f, -1.4f), new Vector3(2.6f, -4.1f, 0f), new Vector3(2.3f, -4.8f, -5.4f), new Vector3(2f, -4.6f, -8.4f),
                new Vector3(1.9f, -4.9f, -9.6f),
            },
        };

        public static InsectBody Create(WingDefinition fore, WingDefinition hind) =>
            new InsectBody(parts => Build(parts, fore.CreateSeat(), hind.CreateSeat()));

        private static void Build(BodyParts parts, HingeSeat fore, HingeSeat hind)
        {
            BodyPatch thorax = parts.Add(hind.Press(fore.Press(Trunk.Through(s_Thorax, 22, 22))), Striped);
            var fur = new Fur { Count = 110, Length = 0.9f, Radius = 0.1f, Seed = 23, Where = place => place.y > 1.3f || place.y < -1.2f };
            parts.AddFur(thorax, fur.GrowOn(thorax.part), Haired);
            parts.AddAbdomen(Trunk.Through(s_Abdomen, 40, 16, ButterflyParts.Rings(k_AbdomenRings, 0.06f)), StripedAbdomen);
            ButterflyParts.AddHead(parts, new Vector3(0f, 0.2f, 5.5f), 1.4f, Striped, (in BodyPoint point) => s_Eye);
            ButterflyParts.AddTongue(parts, new Vector3(0f, -0.85f, 7.4f), 0.62f, s_Dark);
            ButterflyParts.AddAntennae(parts, s_Antenna, 0.13f, 0.4f, (in BodyPoint point) => s_Dark);
            ButterflyParts.AddLegs(parts, s_Legs, 0.22f, (in BodyPoint point) => s_Dark);
        }

        private static Color32 Striped(in BodyPoint point)
        {
            float back = Tint.Below(point.Place.x, 0.75f, 0.5f) * Tint.Below(-point.Place.y, -0.2f, 0.6f);
            return Tint.Mix(s_Yellow, s_Dark, back);
        }

        private static Color32 Haired(in BodyPoint point)
        {
            bool isBack = point.Place.y > 0f && point.Place.x < 0.8f;
            return Tint.Mix(isBack ? s_Dark : s_Yellow, s_PaleHair, (isBack ? 0.3f : 1f) * Ink.Speckle(point.Place));
        }

        private static Color32 StripedAbdomen(in BodyPoint point)
        {
            float back = Tint.Below(point.Around, 0.3f, 0.12f);
            float side = Tint.Below(Mathf.Abs(point.Around - 0.66f), 0.045f, 0.08f);
            float furrow = 0.35f * Tint.Below(0.84f, k_AbdomenRings * point.Along % 1f, 0.16f);
            return Tint.Mix(s_Yellow, s_Dark, Mathf.Max(furrow, Mathf.Max(back, side)));
        }
    }
}
