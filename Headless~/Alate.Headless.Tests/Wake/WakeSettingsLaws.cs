using System;
using System.Collections.Generic;
using Alate.Wake;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Wake
{
    /// <summary>Bounds of the numbers of a wake: both ends are taken, what lies beyond is named.</summary>
    public sealed class WakeSettingsLaws
    {
        private static IEnumerable<TestCaseData> Bounds
        {
            get
            {
                yield return Of("ChordPanels", (s, v) => s.ChordPanels = (int)v, 1f, 64f, 0f, 65f);
                yield return Of("SpanPanels", (s, v) => s.SpanPanels = (int)v, 1f, 256f, 0f, 257f);
                yield return Of("StepsPerBeat", (s, v) => s.StepsPerBeat = (int)v, 4f, 1000f, 3f, 1001f);
                yield return Of("Keep", (s, v) => s.Keep = v, 1e-3f, 1000f, 0f, 1001f);
                yield return Of("NearCore", (s, v) => (s.NearCore, s.FarCore) = (v, 10f), 1e-3f, 10f, 0f, 10.1f);
                yield return Of("FarCore", (s, v) => s.FarCore = v, 0.05f, 10f, 0.04f, 10.1f);
                yield return Of("CoreRamp", (s, v) => s.CoreRamp = v, 1e-3f, 1e6f, 0f, float.PositiveInfinity);
                yield return Of("BoundCore", (s, v) => s.BoundCore = v, 1e-3f, 10f, 0f, 10.1f);
                yield return Of("TrailingShare", (s, v) => s.TrailingShare = v, 0f, 1f, -0.01f, 1.01f);
                yield return Of("TurnedSuction", (s, v) => s.TurnedSuction = v, 0f, 1f, -0.01f, 1.01f);
                yield return Of("Viscosity", (s, v) => s.Viscosity = v, 0f, 1e6f, -0.01f, float.PositiveInfinity);
                yield return Of("Stream", (s, v) => s.Stream = new float3(0f, v, 0f), -1e6f, 1e6f, float.NaN, float.PositiveInfinity);
                yield return Of("GroundHeight", (s, v) => s.GroundHeight = v, 1e-3f, float.PositiveInfinity, 0f, float.NaN);
                yield return Of("Up", (s, v) => s.Up = v * math.normalize(new float3(0f, 1f, 1f)), 0.9995f, 1.0005f, 0.99f, 1.01f);
            }
        }

        [TestCaseSource(nameof(Bounds))]
        public void ANumber_IsTakenWithinItsBounds_AndNamedBeyond(
            Action<WakeSettings, float> set, float[] taken, float[] refused, string name)
        {
            foreach (float value in taken)
                Assert.That(() => With(set, value).Validate(1), Throws.Nothing, $"{value}");
            foreach (float value in refused)
            {
                Assert.That(
                    () => With(set, value).Validate(1), Throws.ArgumentException.With.Message.StartsWith(name + " is "), $"{value}");
            }
        }

        [Test]
        public void AWakeOfNoWing_IsRefused() => Assert.That(
            () => new WakeSettings().Validate(0), Throws.ArgumentException.With.Message.EqualTo("wings is 0; allowed: 1 or more."));

        // Of few steps, so that no bound of the memory is met.
        private static WakeSettings With(Action<WakeSettings, float> set, float value)
        {
            var settings = new WakeSettings(WakeMethod.Panels) { StepsPerBeat = 4, Keep = 1f, ChordPanels = 1, SpanPanels = 2 };
            set(settings, value);
            return settings;
        }

        private static TestCaseData Of(string name, Action<WakeSettings, float> set, float least, float most, params float[] refused) =>
            new TestCaseData(set, new[] { least, most }, refused, name).SetArgDisplayNames(name);
    }
}
