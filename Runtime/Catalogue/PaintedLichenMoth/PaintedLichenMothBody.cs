using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// A painted lichen moth's body, 10 mm long: short and plump, the thorax covered with long hair in the stripes of the wings (yellow,
    /// rose and slate), thread-like antennae with fine bristles. Proportions chosen by us.
    /// </summary>
    internal static class PaintedLichenMothBody
    {
        private const float k_AbdomenRings = 7f;
        private const int k_Bristles = 18;

        private static readonly Color32 s_Rose = new Color32(222, 104, 84, 255);
        private static readonly Color32 s_Yellow = new Color32(238, 190, 92, 255);
        private static readonly Color32 s_Slate = new Color32(86, 82, 88, 255);
        private static readonly Color32 s_Pale = new Color32(250, 222, 168, 255);
        private static readonly Color32 s_Eye = new Color32(26, 24, 26, 255);
        private static readonly Color32 s_Black = new Color32(58, 52, 54, 255);

        private static readonly CrossSection[] s_Thorax =
        {
            new CrossSection(new Vector3(0f, 0.1f, 2.5f), 0f, 0f, 0f),
            new CrossSection(new Vector3(0f, 0.1f, 2f), 0.75f, 0.65f, 0.75f),
            new CrossSection(new Vector3(0f, 0.05f, 0.9f), 1.15f, 1.1f, 1.2f),
            new CrossSection(new Vector3(0f, 0f, -0.5f), 1.2f, 1.15f, 1.25f),
            new CrossSection(new Vector3(0f, -0.05f, -1.6f), 0.95f, 0.85f, 1f),
            new CrossSection(new Vector3(0f, -0.1f, -2.3f), 0f, 0f, 0f),
        };

        private static readonly CrossSection[] s_Abdomen =
        {
            new CrossSection(new Vector3(0f, 0f, -1.2f), 0f, 0f, 0f),
            new CrossSection(new Vector3(0f, -0.05f, -1.9f), 0.9f, 0.8f, 0.9f),
            new CrossSection(new Vector3(0f, -0.15f, -3.3f), 1.05f, 0.95f, 1.05f),
            new CrossSection(new Vector3(0f, -0.3f, -5f), 0.85f, 0.75f, 0.85f),
            new CrossSection(new Vector3(0f, -0.45f, -6.2f), 0.5f, 0.45f, 0.5f),
            new CrossSection(new Vector3(0f, -0.5f, -6.8f), 0f, 0f, 0f),
        };

        private static readonly Vector3[] s_Antenna =
        {
            new Vector3(0.3f, 0.5f, 3f), new Vector3(1f, 1.3f, 4.2f), new Vector3(2.6f, 1.7f, 5.6f), new Vector3(4.6f, 1.1f, 6.2f),
        };

        private static readonly Vector3[][] s_Legs =
        {
            new[]
            {
                new Vector3(0.4f, -0.7f, 1.5f), new Vector3(0.9f, -1.6f, 2.6f), new Vector3(0.95f, -2.4f, 1.7f),
                new Vector3(0.9f, -2.7f, 0.8f), new Vector3(0.9f, -2.9f, 0.4f),
            },
            new[]
            {
                new Vector3(0.5f, -1f, 0.4f), new Vector3(1.3f, -2f, 1.1f), new Vector3(1.3f, -2.8f, -0.6f), new Vector3(1.2f, -3f, -1.7f),
                new Vector3(1.2f, -3.2f, -2.1f),
            },
            new[]
            {
                new Vector3(0.5f, -1f, -0.8f), new Vector3(1.3f, -1.9f, -0.4f), new Vector3(1.2f, -2.2f, -2.9f),
                new Vector3(1f, -2.2f, -4.2f), new Vector3(1f, -2.4f, -4.6f),
            },
        };

        public static InsectBody Create(WingDefinition wing) => new InsectBody(parts => Build(parts, wing.CreateSeat()));

        private static void Build(BodyParts parts, HingeSeat seat)
        {
            BodyPatch thorax = parts.Add(seat.Press(Trunk.Through(s_Thorax, 16, 18)), Striped);
            var coat = new Fur
            {
                Count = 210,
                Length = 0.8f,
                Radius = 0.09f,
                Seed = 31,
                Lay = new Vector3(0f, 0f, -1.7f),
                Where = place => !seat.Covers(place),
            };
            parts.AddFur(thorax, coat.GrowOn(thorax.part), Shaggy);
            BodyPatch abdomen = parts.AddAbdomen(Trunk.Through(s_Abdomen, 28, 16, ButterflyParts.Rings(k_AbdomenRings, 0.06f)), Ringed);
            var down = new Fur { Count = 50, Length = 0.4f, Radius = 0.05f, Seed = 47, Lay = new Vector3(0f, 0f, -2f) };
            parts.AddFur(abdomen, down.GrowOn(abdomen.part), Ringed);
            AddHead(parts);
            parts.AddPair(Stalk.Along(s_Antenna, t => 0.085f - 0.05f * t, 14, 6), (in BodyPoint point) => s_Slate);
            parts.AddPair(Comb.Along(s_Antenna, k_Bristles, t => 0.45f - 0.2f * t, 0.03f, true), (in BodyPoint point) => s_Slate);
            foreach (Vector3[] joints in s_Legs)
                ButterflyParts.AddLegs(parts, new[] { joints }, 0.13f, Banded(joints));
        }

        private static void AddHead(BodyParts parts)
        {
            BodyPatch head = parts.Add(Ellipsoid.Around(new Vector3(0f, 0.1f, 2.75f), new Vector3(0.72f, 0.66f, 0.7f), 8, 14), Striped);
            var tuft = new Fur
            {
                Count = 36,
                Length = 0.42f,
                Radius = 0.07f,
                Seed = 59,
                Lay = new Vector3(
                0f, 0.6f, 0.2f),
                Where = place => place.y > 0.2f
            };
            parts.AddFur(head, tuft.GrowOn(head.part), Shaggy);
            parts.AddPair(
                Ellipsoid.Around(new Vector3(0.5f, 0.12f, 2.95f), new Vector3(0.36f, 0.42f, 0.42f), 8, 10), (in BodyPoint point) => s_Eye);
            Vector3[] palp = new[]
            {
                new Vector3(0.18f, -0.3f, 3f), new Vector3(0.2f, -0.45f, 3.5f), new Vector3(0.2f, -0.1f, 3.75f),
                new Vector3(0.18f, 0.2f, 3.8f),
            };
            parts.AddPair(Stalk.Along(palp, t => 0.15f - 0.09f * t, 5, 6), (in BodyPoint point) => s_Slate);
            ButterflyParts.AddTongue(parts, new Vector3(0f, -0.5f, 3.4f), 0.3f, s_Yellow, 22, 4);
        }

        // The wings' stripes run on over the back: slate in the middle, then rose, yellow at the shoulders, slate below.
        private static Color32 Striped(in BodyPoint point)
        {
            Color32 back = Tint.Mix(s_Slate, s_Rose, Tint.Below(0.22f, point.Place.x, 0.15f));
            Color32 shoulder = Tint.Mix(back, s_Yellow, Tint.Below(0.62f, point.Place.x, 0.15f));
            return Tint.Mix(shoulder, s_Slate, Tint.Below(point.Place.y, -0.35f, 0.3f));
        }

        // Yellow, with dark ends of thigh and shin, and dark toes.
        private static BodyPaint Banded(Vector3[] joints)
        {
            float thigh = (joints[1] - joints[0]).magnitude, shin = (joints[2] - joints[1]).magnitude,
                all = thigh + shin + (joints[3] - joints[2]).magnitude + (joints[4] - joints[3]).magnitude;
            return (in BodyPoint point) =>
            {
                float along = all * point.Along, fromKnee = along - thigh, fromAnkle = fromKnee - shin;
                bool isDark = fromAnkle > 0.5f * (all - thigh - shin) || (fromKnee > -0.25f * thigh && fromKnee < -0.08f * thigh)
                    || (fromAnkle > -0.25f * shin && fromAnkle < -0.08f * shin);
                return isDark ? s_Black : s_Yellow;
            };
        }

        private static Color32 Shaggy(in BodyPoint point) => Tint.Mix(Striped(point), s_Pale, 0.45f * Ink.Speckle(point.Place));

        private static Color32 Ringed(in BodyPoint point)
        {
            float furrow = 0.5f * Tint.Below(0.8f, k_AbdomenRings * point.Along % 1f, 0.2f);
            Color32 rose = Tint.Mix(Tint.Mix(s_Rose, s_Yellow, 0.35f), s_Slate, furrow);
            return Tint.Mix(rose, s_Slate, Tint.Below(0.8f, point.Along, 0.15f));
        }
    }
}
