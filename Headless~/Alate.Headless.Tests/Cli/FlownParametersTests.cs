using System.Linq;
using System.Reflection;
using Alate.Catalogue;
using Alate.Cli;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests.Cli
{
    public sealed class FlownParametersTests
    {
        private static readonly FieldInfo[] s_Sliders =
            new[] { typeof(PresetSize), typeof(PresetBeat), typeof(PresetWave), typeof(PresetStiffness) }
            .SelectMany(group => group.GetFields(BindingFlags.Public | BindingFlags.Instance)).ToArray();

        [Test]
        public void NumbersOfTheFlight_ChangeTheirOwnNumberAlone()
        {
            var plan = new FlightPlan
            {
                Species = "monarch",
                Speed = 1,
                Climb = 0.25,
                PitchDegrees = 5,
                Wind = [0.1, 0.2,
                0.3],
                Elasticity = 1.5,
                Substeps = 16
            };
            FlightPlan In(string name, double value) => FlownParameters.Find(name).In(plan, value);

            Assert.That(In("wind", 3).Wind, Is.EqualTo(new[] { 0.0, 0.0, -3.0 }), "from ahead");
            Assert.That((In("speed", 2).Speed, In("climb", -1).Climb, In("pitch", 20).PitchDegrees,
                In("elasticity", 4).Elasticity, In("substeps-per-beat", 24).Substeps), Is.EqualTo((2.0, -1.0, 20.0, 4.0, (int?)24)));
            Assert.That((In("speed", 2).Climb, In("speed", 2).PitchDegrees,
                In("pitch", 20).Speed, In("climb", -1).Speed, In("elasticity", 4).Speed), Is.EqualTo((0.25, 5.0, 1.0, 1.0, 1.0)));
        }

        [Test]
        public void EverySlider_HasItsName_InTheInspectorsOrder()
        {
            Assert.That(FlownParameters.OfSpecies.Select(parameter => parameter.Name),
                Is.EqualTo(s_Sliders.Select(field => Hyphenated(field.Name))));
        }

        [Test]
        public void EverySlider_KeepsItsRange()
        {
            foreach (FieldInfo field in s_Sliders)
            {
                UnityEngine.RangeAttribute range = field.GetCustomAttribute<UnityEngine.RangeAttribute>();
                FlownParameter parameter = FlownParameters.OfSpecies.Single(known => known.Name == Hyphenated(field.Name));
                if (range != null)
                    Assert.That(((float)parameter.Min, (float)parameter.Max), Is.EqualTo((range.min, range.max)), field.Name);
            }
        }

        // What a message calls the least and the most is taken: 0.1 in single precision is a little more than 0.1.
        [Test]
        public void EverySlider_TakesTheBoundsThatAreTold()
        {
            foreach (FieldInfo field in s_Sliders.Where(field => field.GetCustomAttribute<UnityEngine.RangeAttribute>() != null))
            {
                UnityEngine.RangeAttribute range = field.GetCustomAttribute<UnityEngine.RangeAttribute>();
                FlownParameter parameter = FlownParameters.OfSpecies.Single(known => known.Name == Hyphenated(field.Name));
                foreach (float bound in new[] { range.min, range.max })
                {
                    double typed = double.Parse(bound.ToString(System.Globalization.CultureInfo.InvariantCulture),
                        System.Globalization.CultureInfo.InvariantCulture);
                    Assert.That(typed, Is.InRange(parameter.Min, parameter.Max), field.Name);
                }
            }
        }

        [Test]
        public void EverySlider_IsAFieldOfItsOwn()
        {
            WingPreset preset = ScriptableObject.CreateInstance<WingPreset>();
            foreach (FlownParameter parameter in FlownParameters.OfSpecies)
                parameter.Of(preset) = 0f;
            for (int k = 0; k < FlownParameters.OfSpecies.Count; k++)
            {
                FlownParameters.OfSpecies[k].Of(preset) = 1f;
                Assert.That(FlownParameters.OfSpecies.Count(parameter => parameter.Of(preset) == 1f), Is.EqualTo(k + 1));
            }

            Object.DestroyImmediate(preset);
        }

        [TestCase("Chord Delay")]
        [TestCase("chord_delay")]
        [TestCase("chordDelay")]
        public void ANumber_IsFound_HoweverItsNameIsWritten(string name)
        {
            Assert.That(FlownParameters.Find(name).Name, Is.EqualTo("chord-delay"));
        }

        [Test]
        public void AnUnknownNumber_IsRefused_WithAllThereAre()
        {
            UserException problem = Assert.Throws<UserException>(() => FlownParameters.Find("charm"));

            Assert.That(problem.Message, Does.Contain("charm"));
            foreach (FlownParameter parameter in FlownParameters.All)
                Assert.That(problem.Message, Does.Contain(parameter.Name));
        }

        [Test]
        public void TheOtherWing_IsMovedAlong_ByTheSameFactorOrDifference()
        {
            var wings = InsectCatalogue.Find("swallowtail").Wings.Select(wing => wing.CreatePreset()).ToList();
            float range = wings[1].Beat.flapRange / wings[0].Beat.flapRange, mean = wings[1].Beat.meanFlap - wings[0].Beat.meanFlap;

            FlownParameters.Find("flap-range").Set(wings, 60f);
            FlownParameters.Find("mean-flap").Set(wings, -20f);

            Assert.That(wings[0].Beat.flapRange, Is.EqualTo(60f));
            Assert.That(wings[1].Beat.flapRange, Is.EqualTo(60f * range).Within(1e-3f));
            Assert.That(wings[0].Beat.meanFlap, Is.EqualTo(-20f));
            Assert.That(wings[1].Beat.meanFlap, Is.EqualTo(-20f + mean).Within(1e-3f));
            wings.ForEach(Object.DestroyImmediate);
        }

        private static string Hyphenated(string name) =>
            string.Concat(name.Select(letter => char.IsUpper(letter) ? "-" + char.ToLowerInvariant(letter) : letter.ToString()));
    }
}
