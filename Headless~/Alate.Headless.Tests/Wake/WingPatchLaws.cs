using System;
using System.Linq;
using Alate.Cli;
using Alate.Wake;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Wake
{
    /// <summary>Laws of the patches by which strips meet the air: area, frame, motion, slanted and turning plates.</summary>
    public sealed class WingPatchLaws
    {
        private const float k_Chord = 0.5f, k_Span = 2f;

        /// <summary>Plate along x whose outer end lies behind its root by a distance, nose up by a pitch.</summary>
        private static FourierMotion Slanted(float behind, double pitch = 0.0)
        {
            float3 back = new(0f, (float)-Math.Sin(pitch), (float)-Math.Cos(pitch)), tip = new float3(k_Span, 0f, 0f) + behind * back;
            float3[] corners = [default, tip, k_Chord * back, tip + k_Chord * back];
            return FourierMotion.Through([corners, corners, corners], 2, 2);
        }

        private static WingPatches Placed(IWingMotion motion, int strips, double beats = 0.0)
        {
            var patches = new WingPatches(motion, strips);
            patches.Place(beats);
            return patches;
        }

        [Test]
        public void Patches_CoverTheWing_TheRoundTipToo()
        {
            Assert.That(Placed(Slanted(0.7f), 3).All.Sum(patch => patch.area), Is.EqualTo(k_Chord * k_Span).Within(1e-5));
            float ellipse = Placed(ThinWing.Ellipse(4f), 10).All.Sum(patch => patch.area);
            Assert.That(ellipse, Is.EqualTo(Math.PI).Within(1.5).Percent, "polygons inside it: a strip of one patch leaves out 4 %");
        }

        [Test]
        public void TheSpan_LiesAcrossTheChord_HoweverTheWingIsSlanted([Values(-1f, 0f, 2f)] float behind, [Values(0.0, 0.4)] double pitch)
        {
            foreach (WingPatch patch in Placed(Slanted(behind, pitch), 4).All)
            {
                Assert.That(math.distance(patch.span, new float3(1f, 0f, 0f)), Is.LessThan(1e-5f));
                Assert.That(
                    math.distance(patch.normal, -new float3(0f, (float)Math.Cos(pitch), (float)-Math.Sin(pitch))), Is.LessThan(1e-5f));
            }
        }

        [Test]
        public void PatchesOfAStrip_LieBetweenItsStations_AndMoveAsTheWingDoes()
        {
            const int k_Strips = 4;
            var turning = new ThinWing
            {
                Span = k_Span,
                Pivot = 0.5,
                Move = t => (0.2 * t, 0.2, 0.3 * t, 0.3),
            };
            WingPatches patches = Placed(turning, k_Strips, 0.5);
            Assert.That(patches.All, Has.Length.EqualTo(k_Strips * WingPatches.PerStrip));
            for (int k = 0; k < patches.All.Length; k++)
            {
                WingPatch patch = patches.All[k];
                int strip = k / WingPatches.PerStrip;
                Assert.That(patch.place.x, Is.InRange(k_Span * strip / k_Strips, k_Span * (strip + 1) / k_Strips));
                // A turn about the pivot, which rises: points ahead of it go up.
                float3 turned = new float3(0f, 0.2f, 0f) + 0.3f * new float3(0f, patch.place.z, -(patch.place.y - 0.1f));
                Assert.That(math.distance(patch.motion, turned), Is.LessThan(1e-4f), $"{patch.place}");
            }
        }

        // Sections along the stream, each of the same lift but for the bound vortices of the others. Against the line of the middles of its
        // chords, a plate slanted by 45 degrees would meet half of the stream's square.
        [Test]
        public void ASlantedPlate_MeetsTheAirAsAStraightOneDoes()
        {
            float Lift(float behind)
            {
                using var wake = new FreeWake(
                    new WakeSettings { Stream = new float3(0f, 0f, -4f) },
                    [new WakeWing(Slanted(behind, 0.3)) { Downwash = MeasuredDownwash.None }]);
                wake.Step();
                return wake.Loads(0).Force.y;
            }

            Assert.That(Lift(k_Span), Is.EqualTo(Lift(0f)).Within(10).Percent);
            Assert.That(Lift(-k_Span), Is.EqualTo(Lift(0f)).Within(10).Percent);
        }

        // Thin airfoil theory: what turns about its middle has the lift of a plate whose angle is larger by the turn of a quarter chord
        // over the stream.
        [TestCase(0.8, 0.05)]
        [TestCase(-1.5, 0.1)]
        public void APlateThatPitches_MeetsTheAirOfItsThreeQuarterChord_WhereItsRotationIsAttached(double rate, double angle)
        {
            const double stream = 4;
            float Lift(double at, double turning, bool attached)
            {
                var plate = new ThinWing { Span = k_Span, Pivot = 0.5, Move = _ => (0.0, 0.0, at, turning) };
                using var wake = new FreeWake(
                    new WakeSettings { Stream = new float3(0f, 0f, (float)-stream) },
                    [new WakeWing(plate) { Coefficients = null, Downwash = MeasuredDownwash.None, AttachedRotation = attached }]);
                wake.Step();
                return wake.Loads(0).Force.y;
            }

            double steady = Lift(angle, 0, true), more = Lift(angle + 0.25 * rate / stream, 0, true) - steady;
            Assert.That(steady, Is.EqualTo(Lift(angle, 0, false)).Within(1e-4).Percent, "what does not turn has none");
            Assert.That(Lift(angle, rate, true) - steady, Is.EqualTo(more).Within(5).Percent);
            Assert.That(Math.Abs(Lift(angle, rate, false) - steady), Is.LessThan(0.05 * Math.Abs(more)));
        }

        // In air at rest both halves meet it broadside: drag alone, ½ C_D |ω x|² on each part, whose power is C_D ω³ c⁴ b / 64.
        [Test]
        public void APlateThatTurnsAboutItsMiddle_IsBraked_ByBothHalves()
        {
            const double k_Rate = 3.0;
            var turning = new ThinWing { Span = k_Span, Pivot = 0.5, Move = t => (0.0, 0.0, k_Rate * t, k_Rate) };
            using var wake = new FreeWake(
                new WakeSettings { SpanPanels = 3 }, [new WakeWing(turning) { Downwash = MeasuredDownwash.None }]);
            wake.Step();
            WakeLoads loads = wake.Loads(0);
            double power = RevolvingWing.MeasuredDrag(90) * Math.Pow(k_Rate, 3) * k_Span / 64.0;
            Assert.That(loads.Power, Is.EqualTo(power).Within(15).Percent, "four patches across have 12 % less than their integral");
            Assert.That(loads.Power, Is.EqualTo(-k_Rate * -loads.Moment.x).Within(1e-3 * power), "a rate of pitch is a turn about -x");
            Assert.That(math.length(loads.Force), Is.LessThan(0.05 * power / k_Rate));
        }
    }
}
