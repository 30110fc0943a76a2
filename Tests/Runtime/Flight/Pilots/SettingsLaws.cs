using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using Alate.Flight;
using NUnit.Framework;

namespace Alate.Tests.Flight
{
    /// <summary>
    /// Settings of pilots: every number has a range, which sliders, the check of what is typed, and the default keep alike.
    /// </summary>
    public sealed class SettingsLaws
    {
        private static IEnumerable<FieldInfo> Fields => new[] { typeof(WanderSettings), typeof(FlockSettings), typeof(PerchSettings) }
            .SelectMany(type => type.GetFields()).Where(field => field.FieldType == typeof(float));

        [TestCaseSource(nameof(Fields))]
        public void ANumber_IsMovedIntoItsRange_AndNoOtherIsTouched(FieldInfo field)
        {
            UnityEngine.RangeAttribute range = field.GetCustomAttribute<UnityEngine.RangeAttribute>();
            object defaults = Default(field.DeclaringType);
            float usual = (float)field.GetValue(defaults);
            Assert.That(usual, Is.InRange(range.min, range.max));
            float inside = 0.3f * range.min + 0.7f * range.max;
            foreach ((float given, float kept) in new[] { (-1e9f, range.min), (1e9f, range.max), (float.NaN, usual), (inside, inside),
                (float.NegativeInfinity, range.min) })
            {
                object settings = Default(field.DeclaringType);
                field.SetValue(settings, given);
                object clamped = Clamped(settings);
                Assert.That(field.GetValue(clamped), Is.EqualTo(kept), $"{field.Name} {given}");
                field.SetValue(clamped, usual);
                Assert.That(clamped, Is.EqualTo(Clamped(defaults)), $"the others beside {field.Name}");
            }
        }

        [Test]
        public void Defaults_AreInTheirRanges()
        {
            foreach (Type type in new[] { typeof(WanderSettings), typeof(FlockSettings), typeof(PerchSettings) })
            {
                object defaults = Default(type);
                Assert.That(Clamped(defaults), Is.EqualTo(defaults));
            }
        }

        [TestCase(-1f, 0f)]
        [TestCase(2f, 0.1f)]
        [TestCase(50f, 1f)]
        [TestCase(float.NaN, 0.075f)]
        public void Clearance_IsInWingLengths(float lengths, float metres) =>
            Assert.That(new ObstacleSettings { clearance = lengths }.Metres(0.05f), Is.EqualTo(metres).Within(1e-6f));

        private static object Default(Type type) => type.GetProperty("Default").GetValue(null);

        private static object Clamped(object settings) =>
            settings.GetType().GetMethod("Clamped", BindingFlags.Instance | BindingFlags.NonPublic).Invoke(settings, null);
    }
}
