using System.Linq;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>
    /// Presets that are saved from a tuned insect: the wings beat as before, and nothing is written where it must not be.
    /// </summary>
    public sealed class TunedPresetTests : InsectFixture
    {
        [TestCase(SpringUnits.BeatRate)]
        [TestCase(SpringUnits.Printed)]
        public void SavedPreset_MovesTheWingsAsBefore(SpringUnits units)
        {
            InsectWings insect = Tuned();
            insect.Preset.Options.springUnits = units;
            LaneParameters before = Told(insect, 0);

            Save(insect, PathFor("Tuned"));

            LaneParameters after = Told(insect, 0);
            Assert.That(insect.Wings.Select(wing => wing.AmplitudeScale), Is.All.EqualTo(1f));
            Assert.That(insect.Wings.Select(wing => wing.PhaseLead), Is.All.EqualTo(0f));
            Assert.That(insect.Quality.substepsPerBeat, Is.Zero);
            AssertSame(after.amplitude[0].x, before.amplitude[0].x, "amplitude");
            AssertSame(after.amplitude[0].y, before.amplitude[0].y, "sweep");
            AssertSame(after.wingDelay[0], before.wingDelay[0], "phase");
            AssertSame(after.bendScale[0] * after.numbers.stiffnessRoot[0] * after.numbers.stiffnessRoot[0],
                before.bendScale[0] * before.numbers.stiffnessRoot[0] * before.numbers.stiffnessRoot[0], "bending stiffness");
            AssertSame(after.bendScale[0] * after.numbers.stiffnessTip[0] * after.numbers.stiffnessTip[0],
                before.bendScale[0] * before.numbers.stiffnessTip[0] * before.numbers.stiffnessTip[0], "stiffness at the trailing edge");
            AssertSame(after.springStiffness[0], before.springStiffness[0], "springs");
            AssertSame(after.anchorRate[0], before.anchorRate[0], "anchor");
            Assert.That(after.numbers.substepsPerBeat[0], Is.EqualTo(before.numbers.substepsPerBeat[0]));
        }

        [Test]
        public void SavedPreset_IsAnAssetOfItsOwn()
        {
            InsectWings insect = Tuned();
            WingPreset source = insect.Preset;
            float range = source.Beat.flapRange;
            string path = PathFor("Own");

            FixOutcome outcome = Save(insect, path);

            Assert.That(outcome.IsDone, Is.True);
            Assert.That(AssetDatabase.LoadAssetAtPath<WingPreset>(path), Is.SameAs(insect.Preset));
            Assert.That(insect.Preset, Is.Not.SameAs(source));
            Assert.That(insect.Preset.Beat.flapRange, Is.EqualTo(0.5f * range).Within(1e-4f));
            Assert.That(source.Beat.flapRange, Is.EqualTo(range), "the source was changed");
        }

        [Test]
        public void Undo_GivesTheOldPresetAndTheSlidersBack()
        {
            InsectWings insect = Tuned();
            WingPreset source = insect.Preset;
            Save(insect, PathFor("Undone"));

            Undo.PerformUndo();

            Assert.That(insect.Preset, Is.SameAs(source));
            Assert.That(insect.Wings.Select(wing => wing.AmplitudeScale), Is.All.EqualTo(0.5f));
            Assert.That(insect.Quality.substepsPerBeat, Is.EqualTo(48));
        }

        [Test]
        public void SavingOverAPreset_KeepsWhoReferToIt()
        {
            string path = PathFor("Again");
            InsectWings first = Tuned();
            Save(first, path);
            WingPreset asset = first.Preset;
            InsectWings second = Tuned();
            second.Preset.Beat.maxFrequency = 7f;

            Save(second, path);

            Assert.That(second.Preset, Is.SameAs(asset));
            Assert.That(first.Preset, Is.SameAs(asset));
            Assert.That(asset.Beat.maxFrequency, Is.EqualTo(7f));
        }

        [TestCase("")]
        [TestCase(null)]
        public void Cancelling_ChangesNothing(string path)
        {
            InsectWings insect = Tuned();
            WingPreset source = insect.Preset;

            FixOutcome outcome = Save(insect, path);

            Assert.That(outcome.IsDone, Is.False);
            Assert.That(outcome.Message, Is.Empty);
            Assert.That(insect.Preset, Is.SameAs(source));
        }

        [Test]
        public void PackageFolder_IsRefused()
        {
            InsectWings insect = Tuned();
            WingPreset source = insect.Preset;

            FixOutcome outcome = Save(insect, "Packages/com.alate.insect-wings/Mine.asset");

            Assert.That(outcome.Message, Does.Contain("read-only"));
            Assert.That(insect.Preset, Is.SameAs(source));
            Assert.That(insect.Wings[0].AmplitudeScale, Is.EqualTo(0.5f));
        }

        [Test]
        public void WingsThatDiffer_KeepTheirOwnSliders()
        {
            InsectWings insect = Tuned();
            insect.Wings[1].AmplitudeScale = 0.75f;
            float range = insect.Preset.Beat.flapRange;

            Save(insect, PathFor("Differ"));

            Assert.That(insect.Preset.Beat.flapRange, Is.EqualTo(range));
            Assert.That(insect.Wings.Select(wing => wing.AmplitudeScale), Is.EqualTo(new[] { 0.5f, 0.75f }));
        }

        [Test]
        public void AmplitudeBeyondHalfATurn_StaysOnTheWings()
        {
            InsectWings insect = Tuned();
            insect.Preset.Beat.flapRange = 120f;
            foreach (Wing wing in insect.Wings)
                wing.AmplitudeScale = 2f;

            Save(insect, PathFor("Wide"));

            Assert.That(insect.Preset.Beat.flapRange, Is.EqualTo(180f).Within(1e-3f));
            Assert.That(insect.Wings[0].AmplitudeScale, Is.EqualTo(2f * 120f / 180f).Within(1e-4f));
        }

        [Test]
        public void AmplitudeOfZero_IsSaved()
        {
            InsectWings insect = Tuned();
            foreach (Wing wing in insect.Wings)
                wing.AmplitudeScale = 0f;

            Save(insect, PathFor("Still"));

            Assert.That(insect.Preset.Beat.flapRange, Is.Zero);
            Assert.That(Told(insect, 0).amplitude[0].x, Is.Zero);
        }

        [Test]
        public void WingsWithPresetsOfTheirOwn_AreSavedApart()
        {
            InsectWings insect = Tuned();
            WingPreset hind = Keep(ScriptableObject.CreateInstance<WingPreset>());
            hind.name = "hind";
            insect.Wings[1].Preset = hind;

            Assert.That(TunedPreset.Of(insect).Select(preset => preset.Name), Is.EqualTo(new[] { "fore", "hind" }));
            WingPreset fore = insect.Preset;
            new PresetSaving((_, __, ___) => PathFor("Hind")).Save(insect, TunedPreset.Of(insect)[1]);

            Assert.That(insect.Preset, Is.SameAs(fore));
            Assert.That(insect.Wings[0].Preset == null, Is.True);
            Assert.That(insect.Wings[0].AmplitudeScale, Is.EqualTo(0.5f));
            Assert.That(insect.Wings[1].Preset, Is.Not.SameAs(hind));
            Assert.That(insect.Wings[1].AmplitudeScale, Is.EqualTo(1f));
            Assert.That(insect.Quality.substepsPerBeat, Is.EqualTo(48), "the other wing still needs them");
        }

        [Test]
        public void InsectWithoutPreset_SavesAMonarch()
        {
            InsectWings insect = Insect();

            Save(insect, PathFor("Monarch"));

            Assert.That(insect.Preset.Beat.maxFrequency, Is.EqualTo(PresetBeat.Default.maxFrequency));
        }

        // The bearable wind in metres per second goes with the reference frequency and the range of the stroke.
        [Test]
        public void ACopy_HasEachRangeScaled_AndBearsTheSameWind()
        {
            InsectWings insect = Tuned();
            WingPreset source = insect.Preset;
            (source.Beat.featherRange, source.Beat.sweepRange, source.Stiffness.strongestWind) = (30f, 20f, 3f);
            WingPreset copy = Keep(TunedPreset.Of(insect)[0].Copy());

            Assert.That(copy.name, Is.EqualTo("fore"));
            Assert.That(new[] { copy.Beat.flapRange, copy.Beat.featherRange, copy.Beat.sweepRange },
                Is.EqualTo(new[] { 0.5f * source.Beat.flapRange, 15f, 10f }).Within(1e-4f));
            Assert.That(copy.Stiffness.strongestWind * copy.ReferenceFrequency * copy.Beat.flapRange,
                Is.EqualTo(source.Stiffness.strongestWind * source.ReferenceFrequency * source.Beat.flapRange).Within(1e-3f));
            Assert.That(copy.SubstepsPerBeat, Is.EqualTo(48));
            foreach (Wing wing in insect.Wings)
                wing.AmplitudeScale = 0f;
            Assert.That(Keep(TunedPreset.Of(insect)[0].Copy()).Stiffness.strongestWind, Is.Not.NaN.And.Positive);
        }

        [TestCase(150f, 60f, -150f)]
        [TestCase(-150f, -60f, 150f)]
        [TestCase(100f, 80f, 180f)]
        [TestCase(-100f, -80f, -180f)]
        [TestCase(10f, -20f, -10f)]
        public void ALead_IsTheSumOfBoth_WithinHalfATurn(float preset, float wing, float sum)
        {
            InsectWings insect = Tuned();
            insect.Preset.Beat.phaseLead = preset;
            foreach (Wing one in insect.Wings)
                one.PhaseLead = wing;
            Assert.That(Keep(TunedPreset.Of(insect)[0].Copy()).Beat.phaseLead, Is.EqualTo(sum).Within(1e-4f));
        }

        [Test]
        public void TheWidestRange_LimitsTheShareThatGoesIntoTheCopy([Values(0, 1, 2)] int widest)
        {
            InsectWings insect = Tuned();
            float[] ranges = { 40f, 40f, 40f };
            ranges[widest] = 150f;
            insect.Preset.Beat.flapRange = ranges[0];
            insect.Preset.Beat.featherRange = ranges[1];
            insect.Preset.Beat.sweepRange = ranges[2];
            foreach (Wing wing in insect.Wings)
                wing.AmplitudeScale = 1.5f;
            WingPreset copy = Keep(TunedPreset.Of(insect)[0].Copy());
            float[] found = { copy.Beat.flapRange, copy.Beat.featherRange, copy.Beat.sweepRange };
            Assert.That(found[widest], Is.EqualTo(180f).Within(1e-3f));
            Assert.That(found[(widest + 1) % 3], Is.EqualTo(48f).Within(1e-3f));
        }

        private static void AssertSame(float actual, float expected, string what) =>
            Assert.That(actual, Is.EqualTo(expected).Within(1e-5f * Mathf.Abs(expected) + 1e-6f), what);

        private static FixOutcome Save(InsectWings insect, string path) =>
            new PresetSaving((_, __, ___) => path).Save(insect, TunedPreset.Of(insect)[0]);

        // What the model is told, as a living wing would tell it.
        private static LaneParameters Told(InsectWings insect, int wing)
        {
            var watch = new AssetWatch<WingPreset, PresetValues>(asset => new PresetValues(asset));
            WingPreset own = insect.Wings[wing].Preset;
            WingParameters parameters = watch.Of(own == null ? insect.Preset : own).parameters;
            parameters.amplitudeScale *= insect.Wings[wing].AmplitudeScale;
            parameters.phaseLead += Mathf.Deg2Rad * insect.Wings[wing].PhaseLead;
            if (insect.SubstepsPerBeat > 0)
                parameters.substepsPerBeat = insect.SubstepsPerBeat;
            var told = new LaneParameters();
            told.Set(0, parameters.Clamped());
            return told;
        }

        private InsectWings Tuned()
        {
            InsectWings insect = Insect();
            insect.Preset = Keep(ScriptableObject.CreateInstance<WingPreset>());
            insect.Preset.name = "fore";
            insect.Preset.Beat.phaseLead = 150f;
            insect.Quality.substepsPerBeat = 48;
            foreach (Wing wing in insect.Wings)
            {
                wing.AmplitudeScale = 0.5f;
                wing.PhaseLead = 60f;
            }

            return insect;
        }
    }
}
