using System;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// A snailfish, 98 mm long: shaped as a tadpole, soft and rose, with a broad blunt head, small eyes, a short gill slit above the fins'
    /// base, a sucking disc under the throat, and back and belly fins that run into the tail. Proportions chosen by us, after the look of
    /// Liparis.
    /// </summary>
    internal static class SnailfishBody
    {
        private const int k_Rays = 16;
        private const float k_PoreRadius = 0.42f;

        private static readonly Color32 s_Rose = new Color32(226, 168, 158, 255);
        private static readonly Color32 s_Pale = new Color32(244, 214, 204, 255);
        private static readonly Color32 s_Back = new Color32(198, 132, 130, 255);
        private static readonly Color32 s_Line = new Color32(140, 82, 84, 255);
        private static readonly Color32 s_Fin = new Color32(236, 184, 176, 150);
        private static readonly Color32 s_Ray = new Color32(206, 138, 134, 200);
        private static readonly Color32 s_Iris = new Color32(196, 176, 132, 255);
        private static readonly Color32 s_Pupil = new Color32(24, 22, 28, 255);

        private static readonly CrossSection[] s_Trunk =
        {
            new CrossSection(new Vector3(0f, -1.6f, 25f), 0f, 0f, 0f),
            new CrossSection(new Vector3(0f, -1.2f, 23.4f), 5f, 3.4f, 3f),
            new CrossSection(new Vector3(0f, -0.6f, 18.5f), 9f, 7f, 6f),
            new CrossSection(new Vector3(0f, 0f, 11.5f), 10.1f, 9.2f, 8.6f),
            new CrossSection(new Vector3(0f, 0.2f, 3f), 9.3f, 9.5f, 9f),
            new CrossSection(new Vector3(0f, 0.3f, -5f), 9f, 8.9f, 8.8f),
            new CrossSection(new Vector3(0f, 0.5f, -14f), 6.2f, 7.2f, 7.2f),
            new CrossSection(new Vector3(0f, 0.6f, -27f), 3.1f, 5f, 5.2f),
            new CrossSection(new Vector3(0f, 0.6f, -45f), 1.6f, 2.9f, 3f),
            new CrossSection(new Vector3(0f, 0.6f, -62f), 0.7f, 1.4f, 1.4f),
            new CrossSection(new Vector3(0f, 0.6f, -67f), 0f, 0f, 0f),
        };

        // Above the mouth from the snout to the cheek, then along the jaw.
        private static readonly Vector3[] s_Pores =
        {
            new Vector3(2.3f, 0.2f, 24f), new Vector3(4.8f, 0.3f, 22f), new Vector3(7f, 0.5f, 20f), new Vector3(8.6f, 1f, 17.6f),
            new Vector3(9.4f, 1.7f, 15f), new Vector3(3.2f, -3.6f, 22.6f), new Vector3(6f, -4.2f, 19.4f), new Vector3(7.6f, -4.6f, 16f),
        };

        private static readonly Vector3 s_Eye = new Vector3(6.9f, 4.3f, 16.8f);

        public static InsectBody Create(WingDefinition fin) => new InsectBody(parts => Build(parts, fin.CreateSeat()));

        private static void Build(BodyParts parts, HingeSeat seat)
        {
            BodyPatch trunk = parts.Add(seat.Press(Trunk.Through(s_Trunk, 46, 26)), Skin);
            parts.AddPair(Tufts.On(trunk.part, s_Pores, k_PoreRadius), (in BodyPoint point) => s_Line);
            parts.Add(Fin(-4f, -68f, 0.4f, 7f, 1f), Rayed);
            parts.Add(Fin(-14f, -68f, 0.4f, 7f, -1f), Rayed);
            parts.Add(TailFin(), Rayed);
            parts.AddPair(Ellipsoid.Around(s_Eye, new Vector3(1.5f, 1.7f, 1.9f), 10, 14), Eye);
            parts.Add(
                Disc(), (in BodyPoint point) => Tint.Mix(s_Pale, s_Line, 0.6f * Tint.Below(Mathf.Abs(point.Around - 0.8f), 0.06f, 0.1f)));
            parts.AddPair(Nostril(), (in BodyPoint point) => s_Back);
        }

        // A blade over or under the body's middle line, as high as the body there and a rim of its own.
        private static BodyPart Fin(float front, float rear, float thickness, float height, float side)
        {
            CrossSection[] keys = new[]
            {
                new CrossSection(new Vector3(0f, 0.5f, front), 0f, 0f, 0f),
                Blade(Mathf.Lerp(front, rear, 0.1f), thickness, 7.4f + 0.4f * height, side),
                Blade(Mathf.Lerp(front, rear, 0.35f), thickness, 4.6f + height, side),
                Blade(Mathf.Lerp(front, rear, 0.7f), 0.8f * thickness, 2.2f + 0.8f * height, side),
                Blade(Mathf.Lerp(front, rear, 0.93f), 0.6f * thickness, 1.2f + 0.5f * height, side),
                new CrossSection(new Vector3(0f, 0.6f, rear), 0f, 0f, 0f),
            };
            return Trunk.Through(keys, 64, 8);
        }

        private static CrossSection Blade(float z, float thickness, float height, float side)
        {
            const float inside = 0.5f;
            return new CrossSection(new Vector3(0f, 0.6f, z), thickness, side > 0f ? height : inside, side > 0f ? inside : height);
        }

        private static BodyPart TailFin()
        {
            CrossSection[] keys = new[]
            {
                new CrossSection(new Vector3(0f, 0.6f, -60f), 0f, 0f, 0f),
                new CrossSection(new Vector3(0f, 0.6f, -64f), 0.35f, 2.2f, 2.2f),
                new CrossSection(new Vector3(0f, 0.6f, -69f), 0.3f, 3.4f, 3.4f),
                new CrossSection(new Vector3(0f, 0.6f, -72f), 0.22f, 2.8f, 2.8f),
                new CrossSection(new Vector3(0f, 0.6f, -73.4f), 0f, 0f, 0f),
            };
            return Trunk.Through(keys, 14, 8);
        }

        private static BodyPart Disc() => Ellipsoid.Around(new Vector3(0f, -7.9f, 11f), new Vector3(4f, 1.2f, 4.2f), 10, 18);

        private static BodyPart Nostril()
        {
            var place = new Vector3(3.1f, 2.4f, 21.4f);
            Vector3[] curve = new[] { place, place + new Vector3(0.1f, 0.4f, 0.3f), place + new Vector3(0.2f, 0.8f, 0.6f),
                place + new Vector3(0.3f, 1.1f, 0.9f) };
            return Stalk.Along(curve, t => 0.55f - 0.15f * t, 3, 8);
        }

        private static Color32 Skin(in BodyPoint point)
        {
            Vector3 place = point.Place;
            Color32 skin = Tint.Mix(s_Back, s_Rose, Tint.Below(0.16f, point.Around, 0.3f));
            skin = Tint.Mix(skin, s_Pale, Tint.Below(0.55f, point.Around, 0.35f));
            skin = Tint.Mix(skin, s_Back, 0.12f * Ink.Speckle(point.Place));

            // The mouth runs round the snout; the gill slit is an arc before the fin.
            float mouth = Tint.Below(Mathf.Abs(place.y + 1.9f + 0.06f * (25f - place.z)), 0.35f, 0.5f) * Tint.Below(17.5f, place.z, 1f);
            float behind = place.z - 5.2f + 0.12f * (place.y - 5f) * (place.y - 5f);
            float gill = Tint.Below(Mathf.Abs(behind), 0.6f, 0.9f) * Tint.Below(Mathf.Abs(place.y - 5f), 2.6f, 0.8f);
            return Tint.Mix(skin, s_Line, 0.85f * Math.Max(mouth, gill));
        }

        private static Color32 Rayed(in BodyPoint point)
        {
            float ray = Math.Abs(k_Rays * point.Along % 1f - 0.5f);
            return Tint.Mix(s_Fin, s_Ray, 0.8f * Tint.Below(ray, 0.2f, 0.3f));
        }

        private static Color32 Eye(in BodyPoint point)
        {
            Vector3 outward = point.Place - s_Eye;
            float away = Mathf.Sqrt((outward.y - 0.3f) * (outward.y - 0.3f) + (outward.z - 0.3f) * (outward.z - 0.3f));
            return Tint.Mix(s_Iris, s_Pupil, Tint.Below(away, 1f, 0.3f));
        }
    }
}
