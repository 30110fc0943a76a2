using System.Reflection;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    public sealed class WingParametersTests
    {
        [Test]
        public void AnOptionThatIsNone_IsRefused_AndTakenAsPhysicalFromAPreset()
        {
            WingParameters parameters = WingParameters.Default;
            parameters.options.coefficients = (CoefficientSet)7;
            Assert.That(parameters.FindProblem(),
                Is.EqualTo("options.coefficients is 7; it must be one of Dickinson1999, Paper, FlatPlate, Dragonfly."));
            Assert.That(parameters.Clamped().options, Is.EqualTo(WingParameters.Default.options));
            parameters = WingParameters.Default;
            parameters.options.timeScheme = (TimeScheme)(-1);
            Assert.That(parameters.FindProblem(), Does.StartWith("options.timeScheme is -1; it must be one of SecondOrder"));
            parameters.options = ModelOptions.Paper;
            Assert.That(parameters.FindProblem(), Is.Null);
            Assert.That(parameters.Clamped().options, Is.EqualTo(ModelOptions.Paper));
        }

        [Test]
        public void Defaults_AreInRange()
        {
            Assert.That(WingParameters.Default.FindProblem(), Is.Null);
        }

        [Test]
        public void EveryNumber_OutOfItsRange_IsNamed_AndClampedBack()
        {
            foreach (WingParameterRange range in WingParameterRange.All)
            {
                foreach (float bad in new[] { range.Minimum - 1f, range.Maximum * 2f + 1f, float.NaN, float.PositiveInfinity,
                    float.NegativeInfinity })
                {
                    WingParameters parameters = WingParameters.Default;
                    range.Of(ref parameters) = bad;

                    Assert.That(parameters.FindProblem(), Does.StartWith(range.Name + " is "));
                    Assert.That(parameters.Clamped().FindProblem(), Is.Null, range.Name);
                }
            }
        }

        [Test]
        public void EveryRange_ReachesAFieldOfItsOwn()
        {
            foreach (WingParameterRange range in WingParameterRange.All)
            {
                var parameters = default(WingParameters);
                range.Of(ref parameters) = 1f;

                foreach (WingParameterRange other in WingParameterRange.All)
                {
                    Assert.That(other.Of(ref parameters), Is.EqualTo(other == range ? 1f : 0f), $"{range.Name} wrote {other.Name}");
                }
            }
        }

        [Test]
        public void Clamping_KeepsWhatIsInRange()
        {
            WingParameters parameters = WingParameters.Default;
            parameters.chordDelay = 1.7f;
            parameters.phase = new float3(0.1f, -3f, 3f);

            WingParameters clamped = parameters.Clamped();

            Assert.That(clamped.chordDelay, Is.EqualTo(1.7f));
            Assert.That(math.all(clamped.phase == parameters.phase), Is.True);
            Assert.That(clamped.options, Is.EqualTo(parameters.options));
        }

        [TestCase(0, 12)]
        [TestCase(11, 12)]
        [TestCase(481, 480)]
        public void Substeps_OutOfRange_AreNamed_AndClamped(int given, int expected)
        {
            WingParameters parameters = WingParameters.Default;
            parameters.substepsPerBeat = given;

            Assert.That(parameters.FindProblem(), Is.EqualTo($"substepsPerBeat is {given}; it must be between 12 and 480."));
            Assert.That(parameters.Clamped().substepsPerBeat, Is.EqualTo(expected));
        }

        [Test]
        public void EveryNumberThatTheKernelsRead_IsThatOfItsWing()
        {
            var wings = new WingParameters[4];
            var lanes = new LaneParameters();
            for (int lane = 0; lane < wings.Length; lane++)
            {
                float number = 100f * lane;
                foreach (WingParameterRange range in WingParameterRange.All)
                    range.Of(ref wings[lane]) = number++;
                wings[lane].substepsPerBeat = 12 + lane;
                lanes.Set(lane, wings[lane]);
            }

            foreach (FieldInfo field in typeof(NumberLanes).GetFields())
            {
                FieldInfo given = typeof(WingParameters).GetField(field.Name);
                Assert.That(given, Is.Not.Null, field.Name);
                for (int lane = 0; lane < wings.Length; lane++)
                    Assert.That(((float4)field.GetValue(lanes.numbers))[lane], Is.EqualTo(given.GetValue(wings[lane])), field.Name);
            }
        }

        [Test]
        public void AProblem_SaysValueUnitAndBounds()
        {
            WingParameters parameters = WingParameters.Default;
            parameters.chordDelay = -1f;

            Assert.That(parameters.FindProblem(), Is.EqualTo("chordDelay is -1 half beats; it must be between 0 and 2."));
        }
    }
}
