using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Laws of hair, combs and seats of wings on a body's parts, and of how parts are joined, textured and coloured.</summary>
    public sealed class BodyDetailLaws
    {
        [Test]
        public void AnEllipsoid_LiesOnItsSurface_FromPoleToPole()
        {
            Vector3 centre = new Vector3(1f, -2f, 3f), radii = new Vector3(2f, 3f, 4f);
            BodyPart part = Ellipsoid.Around(centre, radii, 8, 10);

            Assert.That(part.Positions, Has.Length.EqualTo(2 + 7 * 10));
            for (int vertex = 0; vertex < part.Positions.Length; vertex++)
            {
                Vector3 off = part.Positions[vertex] - centre;
                Assert.That(new Vector3(off.x / 2f, off.y / 3f, off.z / 4f).magnitude, Is.EqualTo(1f).Within(1e-5f));
                int ring = (vertex + 9) / 10;
                Assert.That(off.z, Is.EqualTo(4f * (float)Math.Cos(Math.PI * ring / 8)).Within(1e-5f), "from the front, by even angles");
            }
        }

        [Test]
        public void APyramid_IsClosed_AsLongAndWideAsAsked_AndSquareOnItsBase()
        {
            var pyramids = new Pyramids();
            Vector3 root = new Vector3(1f, 2f, 3f), along = new Vector3(0f, 3f, 4f);
            pyramids.Add(root, along, new Vector3(1f, 1f, 0f), 0.5f, new Vector2(0.25f, 0.75f));
            pyramids.Add(-root, 2f * along, new Vector3(1f, 1f, 0f), 0.25f, new Vector2(0.5f, 1f));
            BodyPart part = pyramids.ToPart(new Vector2(6f, 7f));

            Assert.That(part.Extent, Is.EqualTo(new Vector2(6f, 7f)));
            Assert.That(part.Positions[3], Is.EqualTo(root + along));
            for (int corner = 0; corner < 3; corner++)
            {
                Vector3 off = part.Positions[corner] - root;
                Assert.That((off.magnitude, (part.Positions[4 + corner] + root).magnitude), Is.EqualTo((0.5f, 0.25f)).Using<(float, float)>(
                    (one, other) => Math.Abs(one.Item1 - other.Item1) + Math.Abs(one.Item2 - other.Item2) < 1e-5f ? 0 : 1));
                Assert.That(Vector3.Dot(off, along), Is.Zero.Within(1e-5f));
                Vector3 next = part.Positions[(corner + 1) % 3] - root;
                Assert.That(Vector3.Dot(off, next), Is.EqualTo(-0.5f * 0.25f).Within(1e-5f), "a third of a turn");
            }

            // The volume of pyramids: a third of the base, a triangle in its circle, times the height.
            var mesh = new SurfaceMesh { positions = part.Positions, normals = part.Normals, triangles = part.Triangles };
            List<List<int>> pieces = BodyPieces.Of(mesh);
            double[] volumes = pieces.Select(piece => BodyPieces.Volume(mesh, piece)).ToArray();
            double unit = 3 * Math.Sqrt(3) / 4 / 3;
            Assert.That(volumes, Is.EqualTo(new[] { unit * 0.25 * 5, unit * 0.0625 * 10 }).Within(1e-5));
            Assert.That(part.Uvs.Take(4), Is.All.EqualTo(new Vector2(0.25f, 0.75f)));
            Assert.That(part.Uvs.Skip(4), Is.All.EqualTo(new Vector2(0.5f, 1f)));
        }

        [TestCase(false)]
        [TestCase(true)]
        public void Teeth_StandEvenlyAlongAnAntenna_OutwardsAndAhead(bool isDouble)
        {
            Vector3[] curve = { default, new Vector3(0f, 0f, 5f), new Vector3(0f, 0f, 10f), new Vector3(0f, 0f, 15f) };
            BodyPart comb = Comb.Along(curve, 6, t => 1f + t, 0.1f, isDouble);
            int rows = isDouble ? 2 : 1;

            Assert.That(comb.Positions, Has.Length.EqualTo(4 * 6 * rows));
            Assert.That(comb.Extent, Is.EqualTo(new Vector2(0.2f, 15f)));
            for (int tooth = 0; tooth < 6 * rows; tooth++)
            {
                Vector3 root = (comb.Positions[4 * tooth] + comb.Positions[4 * tooth + 1] + comb.Positions[4 * tooth + 2]) / 3f;
                Vector3 along = comb.Positions[4 * tooth + 3] - root;
                float t = root.z / 15f;
                int side = isDouble && tooth % 2 == 1 ? -1 : 1;
                Assert.That(root.z, Is.EqualTo(15f * (tooth / rows + 1.5f) / 7.5f).Within(1e-3f), "the last at the tip, none at the root");
                Assert.That((along - (1f + t) * new Vector3(0.8f * side, 0f, 0.6f)).magnitude, Is.LessThan(2e-3f));
                Assert.That((comb.Positions[4 * tooth] - root).magnitude, Is.EqualTo(0.1f).Within(1e-4f));
                Assert.That(comb.Uvs[4 * tooth], Is.EqualTo(new Vector2(0.5f, (tooth / rows + 1.5f) / 7.5f)));
            }
        }

        [Test]
        public void Fur_LeansAsItIsLaid_IsRootedInTheSkin_AndSpreadByArea()
        {
            BodyPart skin = Ellipsoid.Around(default, new Vector3(4f, 4f, 4f), 40, 40);
            BodyPart fur = new Fur { Count = 3000, Length = 0.5f, Radius = 0.02f, Seed = 5, Lay = new Vector3(0f, 0f, -2f) }.GrowOn(skin);
            double length = 0.0, back = 0.0, high = 0.0, ahead = 0.0;
            for (int hair = 0; hair < 3000; hair++)
            {
                Vector3 root = (fur.Positions[4 * hair] + fur.Positions[4 * hair + 1] + fur.Positions[4 * hair + 2]) / 3f;
                Vector3 tip = fur.Positions[4 * hair + 3], normal = root / root.magnitude;
                float depth = 4f - root.magnitude;
                Assert.That(depth, Is.InRange(0.15f * 0.67f * 0.5f - 1e-3f, 0.15f * 1.33f * 0.5f + 0.03f), "a share of its length");
                Vector3 free = tip - root - depth * normal;
                Assert.That(free.magnitude, Is.InRange(0.66f * 0.5f - 0.02f, 1.34f * 0.5f + 0.02f));
                length += free.magnitude / 3000.0;
                if (Math.Abs(normal.z) < 0.2f)
                    back += Math.Atan2(-free.z, Vector3.Dot(free, normal));
                high += Math.Abs(normal.z) < 0.2f ? 1 : 0;
                ahead += normal.z > 0.5f ? 1 : 0;
                for (int corner = 0; corner < 4; corner++)
                {
                    Assert.That(fur.Normals[4 * hair + corner].magnitude, Is.EqualTo(1f).Within(1e-4f));
                }
            }

            Assert.That(length, Is.EqualTo(0.5).Within(2).Percent);
            Assert.That(back / high, Is.EqualTo(Math.Atan(2.0)).Within(0.03), "the lay is the tangent of the lean");

            // On a ball the area between two heights is as their distance (Archimedes).
            Assert.That(high / 3000, Is.EqualTo(0.2).Within(0.03));
            Assert.That(ahead / 3000, Is.EqualTo(0.25).Within(0.03));
        }

        // The top stands over the vertex that is nearest, the rim lies below the skin, all on one disc of the texture.
        [Test]
        public void Tufts_StandOnTheSkin_Closed_AndLitAsIt()
        {
            BodyPart skin = Ellipsoid.Around(default, new Vector3(4f, 4f, 4f), 12, 16);
            Vector3[] places = { skin.Positions[40], 1.3f * skin.Positions[70] };
            BodyPart tufts = Tufts.On(skin, places, 0.5f);

            var mesh = new SurfaceMesh { positions = tufts.Positions, normals = tufts.Normals, triangles = tufts.Triangles };
            List<List<int>> pieces = BodyPieces.Of(mesh);
            // Two pyramids over a hexagon of that radius: its area, 3/2 √3 r², times a third of both heights.
            double volume = 1.5 * Math.Sqrt(3) * 0.25 * (0.24 + 0.4) * 0.5 / 3;
            Assert.That(pieces.Select(piece => BodyPieces.Volume(mesh, piece)), Is.EqualTo(new[] { volume, volume }).Within(1e-4));
            for (int k = 0; k < 2; k++)
            {
                int at = k == 0 ? 40 : 70;
                Vector3 up = skin.Normals[at];
                Assert.That((tufts.Positions[8 * k] - skin.Positions[at] - 0.12f * up).magnitude, Is.LessThan(1e-5f));
                for (int corner = 0; corner < 7; corner++)
                {
                    Assert.That(Vector3.Dot(tufts.Normals[8 * k + corner], up), Is.GreaterThan(corner == 0 ? 0.99f : 0.2f));
                    if (corner > 0)
                        Assert.That(tufts.Positions[8 * k + corner].magnitude, Is.LessThan(4f));
                }
            }

            Assert.That(tufts.Uvs, Is.All.Matches<Vector2>(uv => (uv - new Vector2(0.5f, 0.5f)).magnitude < 0.501f));
            Assert.That(tufts.Extent, Is.EqualTo(new Vector2(1f, 1f)));
        }

        [Test]
        public void NoHair_GrowsWhereThereIsNoPlace()
        {
            BodyPart skin = Ellipsoid.Around(default, new Vector3(2f, 2f, 2f), 10, 10);
            BodyPart left = Ellipsoid.Around(new Vector3(-5f, 0f, 0f), new Vector3(2f, 2f, 2f), 10, 10);
            foreach ((BodyPart part, Func<Vector3, bool> where) in new (BodyPart, Func<Vector3, bool>)[]
                { (skin, place => false), (left, null) })
            {
                var fur = new Fur { Count = 20, Length = 0.5f, Radius = 0.05f, Where = where };
                Assert.That(fur.GrowOn(part).Positions, Is.Empty);
            }
        }

        [Test]
        public void ASeat_IsFlatRoundTheRoot_AndFadesOverHalfOfIt()
        {
            // A root from z = -1 to 3 at x = 2, y = 1: 4 long, flat by 0.88 all round, faded over 2.
            var seat = new HingeSeat(new Vector3(2f, 1f, 0f), 3f, -1f);
            float Pressed(float x, float y, float z)
            {
                var part = BodyPart.Of(new[] { new Vector3(x, y, z), new Vector3(50f, 50f, 50f), new Vector3(50f, 51f, 50f),
                    new Vector3(50f, 50f, 51f) }, new Vector2[4], new[] { 0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2 }, Vector2.one);
                BodyPart pressed = seat.Press(part);
                Assert.That((pressed.Positions[0].y, pressed.Positions[0].z), Is.EqualTo((y, z)));
                return pressed.Positions[0].x;
            }

            const float target = 2f * (1f - 0.003f);
            foreach ((float y, float z) in new[] { (1f, 0f), (1.87f, 3.87f), (0.13f, -1.87f) })
            {
                Assert.That(Pressed(1.5f, y, z), Is.EqualTo(target).Within(1e-5f));
                Assert.That(Pressed(-2.5f, y, z), Is.EqualTo(-target).Within(1e-5f), "the other side lies as deep");
                Assert.That(Pressed(0.9f, y, z), Is.EqualTo(0.9f), "deep inside is no skin");
                Assert.That(seat.Covers(new Vector3(0f, y, z)));
            }

            foreach ((float y, float z) in new[] { (1f, 4.88f), (1f, -2.88f), (2.88f, 0f), (-0.88f, 0f), (2.48f, 4.68f) })
            {
                Assert.That(Pressed(1f, y, z), Is.EqualTo(0.5f + 0.5f * target).Within(1e-3f), "half way through the fade");
            }

            foreach ((float y, float z) in new[] { (1f, 5.9f), (1f, -3.9f), (3.9f, 0f), (-1.9f, 0f) })
                Assert.That((Pressed(1.5f, y, z), seat.Covers(new Vector3(0f, y, z))), Is.EqualTo((1.5f, false)));
            Assert.That((seat.Covers(new Vector3(0f, 1f, 4.85f)), seat.Covers(new Vector3(0f, 1f, 4.91f))), Is.EqualTo((true, false)));
        }

        [Test]
        public void Shelves_AreAsLargeAsTheyFit_WithGapsAround()
        {
            const float gap = 0.006f;
            Rect[] one = UvShelves.Lay(new[] { new Vector2(3f, 3f) });
            Rect[] four = UvShelves.Lay(new[] { new Vector2(2f, 2f), new Vector2(2f, 2f), new Vector2(2f, 2f), new Vector2(2f, 2f) });
            Rect[] mixed = UvShelves.Lay(new[] { new Vector2(1f, 1f), new Vector2(4f, 2f), new Vector2(1f, 5f), new Vector2(3f, 2f) });

            Assert.That((one[0].width, one[0].height), Is.EqualTo((1f - 2f * gap, 1f - 2f * gap)).Using<(float, float)>(Near));
            foreach (Rect shelf in four)
                Assert.That((shelf.width, shelf.height), Is.EqualTo((0.5f - 1.5f * gap, 0.5f - 1.5f * gap)).Using<(float, float)>(Near));
            Assert.That(four.Select(shelf => Math.Round(shelf.x, 3) + Math.Round(shelf.y, 3)).OrderBy(sum => sum).ToArray(),
                Is.EqualTo(new[] { 0.012, 0.509, 0.509, 1.006 }).Within(2e-3), "side by side, then above");
            Assert.That((mixed[2].x, mixed[2].y), Is.EqualTo((gap, gap)), "the longest first");
            for (int k = 0; k < 4; k++)
            {
                for (int other = 0; other < k; other++)
                {
                    float beside = Math.Max(mixed[k].xMin - mixed[other].xMax, mixed[other].xMin - mixed[k].xMax);
                    float above = Math.Max(mixed[k].yMin - mixed[other].yMax, mixed[other].yMin - mixed[k].yMax);
                    Assert.That(Math.Max(beside, above), Is.GreaterThan(gap - 1e-4f));
                }
            }
        }

        [Test]
        public void Parts_ShareTheirTextureWithTheirTwinsAndTheirHair_AndArePaintedAsTheirRightSide()
        {
            var seen = new List<BodyPoint>();
            Color32 Paint(in BodyPoint point)
            {
                seen.Add(point);
                return new Color32((byte)(20f * point.Place.x), (byte)(100f * point.Around), (byte)(100f * point.Along), 255);
            }

            var parts = new BodyParts();
            BodyPatch middle = parts.Add(Ellipsoid.Around(default, new Vector3(2f, 2f, 2f), 8, 8), Paint);
            parts.AddPair(Ellipsoid.Around(new Vector3(6f, 0f, 0f), new Vector3(1f, 1f, 3f), 8, 8), Paint);
            parts.AddFur(middle, new Fur { Count = 5, Length = 0.5f, Radius = 0.1f }.GrowOn(middle.part), Paint);
            SurfaceMesh body = parts.Join(out _);

            Assert.That(seen, Has.Count.EqualTo(58 + 58 + 20));
            Assert.That(seen.Take(58), Is.All.Matches<BodyPoint>(point => point.Place.x >= 0f && point.Normal.x >= -1e-6f),
                "a part of the middle is painted as its right half");
            Assert.That(body.positions, Has.Length.EqualTo(58 + 2 * 58 + 2 * 20));
            for (int k = 0; k < 58; k++)
            {
                Assert.That(body.colours[58 + k], Is.EqualTo(body.colours[116 + k]));
                Assert.That(body.uvs[58 + k], Is.EqualTo(body.uvs[116 + k]));
                Assert.That(body.positions[116 + k], Is.EqualTo(Vector3.Scale(body.positions[58 + k], new Vector3(-1f, 1f, 1f))));
                Assert.That(body.colours[k].r, Is.EqualTo((byte)(20f * Math.Abs(body.positions[k].x))));
            }

            // Each patch of the texture has the proportions of its part: half its girth by its length.
            Rect first = Around(body.uvs.Take(58)), second = Around(body.uvs.Skip(58).Take(58)), hair = Around(body.uvs.Skip(174));
            Assert.That(first.width / first.height, Is.EqualTo(Math.PI * 2 / 4).Within(1e-3));
            Assert.That(second.width / second.height, Is.EqualTo(Math.PI * 1 / 6).Within(1e-3));
            Assert.That(first.height / second.height, Is.EqualTo(4f / 6f).Within(1e-3f), "one scale for all");
            Assert.That(hair.xMin >= first.xMin && hair.xMax <= first.xMax && hair.yMin >= first.yMin && hair.yMax <= first.yMax);
        }

        [Test]
        public void ARoundHead_HasEyesAndPalpsOnBothSides_AndItsTongueRollsUpInSidePlane()
        {
            var parts = new BodyParts();
            Color32 Plain(in BodyPoint point) => new Color32(1, 2, 3, 255);
            ButterflyParts.AddTongue(parts, new Vector3(0f, -1f, 2f), 0.5f, new Color32(9, 8, 7, 255));
            SurfaceMesh tongue = parts.Join(out _);
            double turns = 0.0, before = double.NaN, nearest = double.MaxValue, farthest = 0.0;
            for (int ring = 0; ring < 43; ring++)
            {
                Vector3 middle = Enumerable.Range(1 + 6 * ring, 6).Aggregate(Vector3.zero, (sum, k) => sum + tongue.positions[k] / 6f);
                float thick = (tongue.positions[1 + 6 * ring] - middle).magnitude;
                Vector3 off = middle - new Vector3(0f, -1f, 2f);
                double angle = Math.Atan2(off.z, off.y);
                turns += double.IsNaN(before) ? 0 : (angle - before + 4 * Math.PI) % (2 * Math.PI) / (2 * Math.PI);
                before = angle;
                Assert.That(middle.x, Is.Zero.Within(1e-5f), "in the plane between both sides");
                Assert.That(thick, Is.InRange(0.5f * 0.08f - 1e-4f, 0.5f * 0.15f + 1e-4f));
                nearest = Math.Min(nearest, off.magnitude);
                farthest = Math.Max(farthest, off.magnitude);
            }

            Assert.That(turns, Is.EqualTo(2.6 * 42 / 44).Within(1e-3), "2.6 turns from end to end");
            Assert.That(farthest, Is.EqualTo(0.5 * (1 - 0.78 / 44)).Within(1e-4));
            Assert.That(nearest, Is.EqualTo(0.5 * (1 - 0.78 * 43 / 44)).Within(1e-4));
            Assert.That(tongue.colours, Is.All.EqualTo(new Color32(9, 8, 7, 255)));

            var head = new BodyParts();
            ButterflyParts.AddHead(head, new Vector3(0f, 1f, 4f), 2f, Plain, Plain);
            SurfaceMesh made = head.Join(out _);
            List<List<int>> pieces = BodyPieces.Of(made);
            Assert.That(pieces, Has.Count.EqualTo(5), "a face, two eyes, two palps");
            Bounds face = BodyPieces.BoundsOf(made, pieces[0]);
            Assert.That((face.center - new Vector3(0f, 1f, 4f)).magnitude, Is.LessThan(1e-4f));
            Assert.That((face.size - new Vector3(4f, 3.8f, 4f)).magnitude, Is.LessThan(0.1f));
            foreach (List<int> piece in pieces.Skip(1))
            {
                bool grows = piece.SelectMany(corner => new[] { corner, corner + 1, corner + 2 })
                    .Any(corner => (made.positions[made.triangles[corner]] - face.center).magnitude < 1.9f);
                Assert.That(grows, Is.True, "rooted in the head");
            }
        }

        [Test]
        public void AnAntenna_EndsInAClub_AndItsGirthIsThatOfTheShaftBefore()
        {
            var parts = new BodyParts();
            Color32 Plain(in BodyPoint point) => default;
            Vector3[] straight = { new Vector3(1f, 0f, 0f), new Vector3(1f, 0f, 10f), new Vector3(1f, 0f, 20f), new Vector3(1f, 0f, 30f) };
            ButterflyParts.AddAntennae(parts, straight, 0.1f, 0.4f, Plain);
            SurfaceMesh made = parts.Join(out _);

            Assert.That(BodyPieces.Of(made), Has.Count.EqualTo(2));
            foreach (Vector3 place in made.positions.Take(made.positions.Length / 2).Where(place => place.z > 0.01f && place.z < 29.99f))
            {
                double t = place.z / 30.0, bell = Math.Exp(-(t - 0.94) * (t - 0.94) / 0.0025);
                Assert.That(new Vector2(place.x - 1f, place.y).magnitude, Is.EqualTo(0.1 + 0.3 * bell).Within(1e-4));
            }
        }

        [Test]
        public void TheRingsOfAnAbdomen_AreDrawnInWhereTheyMeet_AndWholeBetween()
        {
            Func<float, float> rings = ButterflyParts.Rings(5f, 0.2f);
            for (int ring = 0; ring < 5; ring++)
            {
                Assert.That(rings((ring + 0.5f) / 5f), Is.EqualTo(1f).Within(1e-5f));
                Assert.That(rings((ring + 0.0001f) / 5f), Is.EqualTo(0.8f).Within(2e-3f));
                Assert.That(rings((ring + 0.25f) / 5f), Is.EqualTo(1f - 0.2f / 64f).Within(1e-4f), "a sixth power: narrow furrows");
                Assert.That(rings((ring + 0.75f) / 5f), Is.EqualTo(1f - 0.2f / 64f).Within(1e-4f));
            }
        }

        private static int Near((float, float) one, (float, float) other) =>
            Math.Abs(one.Item1 - other.Item1) + Math.Abs(one.Item2 - other.Item2) < 1e-4f ? 0 : 1;

        private static Rect Around(IEnumerable<Vector2> uvs)
        {
            Vector2[] all = uvs.ToArray();
            return Rect.MinMaxRect(all.Min(uv => uv.x), all.Min(uv => uv.y), all.Max(uv => uv.x), all.Max(uv => uv.y));
        }
    }
}
