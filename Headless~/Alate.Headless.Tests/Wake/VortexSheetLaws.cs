using System.Linq;
using Alate.Cli;
using Alate.Wake;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Wake
{
    /// <summary>Sheets of a wake against the rings that they are made of.</summary>
    public sealed class VortexSheetLaws
    {
        private const int k_Panels = 3;
        private const float k_Step = 0.25f;

        private static readonly float3 s_Stream = new(0.1f, 0.2f, -2f);

        private static readonly float3[] s_Points =
            [new(0.3f, 0.5f, -0.2f), new(-0.7f, 0.1f, -1.1f), new(0.2f, -0.4f, 0.4f), new(1.3f, 0.02f, -0.6f)];

        // The bound ring ends at the trailing edge, so that the sheet begins with the ring behind it.
        [Test]
        public void EachSegment_CarriesTheDifferenceOfTheRingsBesideIt()
        {
            VortexSheet sheet = Shed(4, 1e-3f, k_Panels, (row, j) => row + 1f + 0.3f * j * j);
            Assert.That(sheet.RowCount, Is.EqualTo(4));
            float3[] whole = Induce(field => sheet.Write(field));
            float3[] rings = Induce(field =>
            {
                for (int row = 0; row < 3; row++)
                {
                    for (int j = 0; j < k_Panels; j++)
                    {
                        field.Begin(sheet.Point(row, j));
                        foreach (float3 corner in new[]
                            { sheet.Point(row, j + 1), sheet.Point(row + 1, j + 1), sheet.Point(row + 1, j), sheet.Point(row, j) })
                        {
                            field.Add(corner, sheet.Circulation(row, j), 1e-6f);
                        }
                    }
                }
            });
            for (int k = 0; k < s_Points.Length; k++)
                Assert.That(math.distance(whole[k], rings[k]), Is.LessThan(1e-4f * math.length(rings[k])), $"{s_Points[k]}");
        }

        // Of the two rings beside a segment the stronger one spreads its core, on whichever side it lies.
        [Test]
        public void ACore_AgesWithItsSegment_AndSpreadsWithTheStrongerRing()
        {
            const float k_Near = 0.05f, k_Circulation = 400f;
            VortexSheet sheet = Shed(2, k_Near, 1, (_, _) => k_Circulation);
            WakeCores cores = Cores(k_Near);
            float front = sheet.Age(0), back = sheet.Age(1), side = 0.5f * (front + back);
            Assert.That((front, back), Is.EqualTo((k_Step, 2f * k_Step)));
            float3[] whole = Induce(field => sheet.Write(field));
            float3[] four = Induce(field =>
            {
                field.Begin(sheet.Point(0, 0));
                field.Add(sheet.Point(0, 1), k_Circulation, cores.Of(front, k_Circulation));
                field.Add(sheet.Point(1, 1), k_Circulation, cores.Of(side, k_Circulation));
                field.Add(sheet.Point(1, 0), k_Circulation, cores.Of(back, k_Circulation));
                field.Add(sheet.Point(0, 0), k_Circulation, cores.Of(side, k_Circulation));
            });
            for (int k = 0; k < s_Points.Length; k++)
                Assert.That(math.distance(whole[k], four[k]), Is.LessThan(1e-4f * math.length(four[k])), $"{s_Points[k]}");
            Assert.That(cores.Of(back, k_Circulation), Is.GreaterThan(1.5f * cores.Of(back, 0f)), "the spread is felt");
        }

        [Test]
        public void ASheetThatIsFull_DropsItsOldestRow_AndDriftsWithTheStream()
        {
            VortexSheet sheet = Shed(9, 1e-3f, k_Panels, (row, _) => row + 1f, rows: 5);
            Assert.That(sheet.RowCount, Is.EqualTo(5));
            for (int row = 0; row < 5; row++)
            {
                Assert.That(sheet.Age(row), Is.EqualTo((row + 1) * k_Step).Within(1e-6f));
                Assert.That(math.distance(sheet.Point(row, 1) - sheet.Point(0, 1), row * k_Step * s_Stream), Is.LessThan(1e-5f));
                if (row < 4)
                    Assert.That(sheet.Circulation(row, 0), Is.EqualTo(9f - row), "the edge's circulation as it was shed");
            }
        }

        private static WakeCores Cores(float near) =>
            new(new WakeSettings(WakeMethod.Strips) { NearCore = near, FarCore = near, Viscosity = 0f }, 1f);

        // Rows shed by a wing at rest in a stream that nothing else moves; the circulation of a shedding.
        private static VortexSheet Shed(int count, float near, int panels, System.Func<int, int, float> circulation, int rows = 8)
        {
            var settings = new WakeSettings(WakeMethod.Strips) { SpanPanels = panels, Stream = s_Stream, TrailingShare = 0f };
            var lattice = new WingLattice(new WakeWing(ThinWing.Steady(2f, 0.1)), settings);
            var sheet = new VortexSheet(panels, rows, Cores(near));
            using var still = new VortexField(1, rows * (panels + 1), new MirrorImages(false, false, default, 0f));
            for (int row = 0; row < count; row++)
            {
                lattice.Place(0.0, s_Stream, k_Step);
                for (int j = 0; j < panels; j++)
                    lattice.Before[lattice.Ring(0, j)] = circulation(row, j);
                sheet.Shed(lattice);
                still.SetPointCount(sheet.PointCount);
                sheet.WritePoints(still, 0);
                still.Induce();
                sheet.Move(still, 0, s_Stream, k_Step);
            }

            return sheet;
        }

        private static float3[] Induce(System.Action<VortexField> write)
        {
            using var field = new VortexField(1000, s_Points.Length, new MirrorImages(false, false, default, 0f));
            write(field);
            field.SetPointCount(s_Points.Length);
            for (int k = 0; k < s_Points.Length; k++)
                field.SetPoint(k, s_Points[k]);
            field.Induce();
            return [.. Enumerable.Range(0, s_Points.Length).Select(field.Velocity)];
        }
    }
}
