using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests.Play
{
    /// <summary>
    /// Ranges of the numbers of all components: what a property keeps of a value beyond them is their end, and a field that was written
    /// without it, as by an Animation window or an older scene, reads the same.
    /// </summary>
    public sealed class PropertyRangeLaws : PlayFixture
    {
        private const float k_Beyond = 1e9f;

        private static IEnumerable<Type> Components =>
            SerialisedNumbers.Components(_ => true).Where(type => Numbers(type).Any());

        [Test]
        public void AValueBeyondItsRange_IsTheEndOfTheRange([ValueSource(nameof(Components))] Type type)
        {
            GameObject asleep = Keep(new GameObject("asleep"));
            asleep.SetActive(false);
            Component component = asleep.AddComponent(type);
            int tried = 0;
            foreach ((PropertyInfo property, FieldInfo field) in Numbers(type))
            {
                if (!TrySet(property, component, -k_Beyond, out float low) || !TrySet(property, component, k_Beyond, out float high))
                    continue;
                tried++;
                foreach ((float value, float kept) in new[]
                    { (low - 1f - Mathf.Abs(low), low), (high + 1f + Mathf.Abs(high), high), (low, low), (high, high) })
                {
                    if (Mathf.Abs(value) > k_Beyond)
                        continue;
                    Assert.That(TrySet(property, component, value, out float read), Is.True);
                    Assert.That(read, Is.EqualTo(kept), $"{property.Name} set to {value}");
                    Assert.That(Convert.ToSingle(field.GetValue(component)), Is.EqualTo(kept), $"what is saved of {property.Name}");
                    field.SetValue(component, Convert.ChangeType(value, field.FieldType));
                    Assert.That(Read(property, component), Is.EqualTo(kept), $"{field.Name} written as {value}");
                }

                float middle = 0.5f * (low + high);
                if (property.PropertyType != typeof(float))
                    middle = Mathf.Round(middle);
                field.SetValue(component, Convert.ChangeType(middle, field.FieldType));
                Assert.That(Read(property, component), Is.EqualTo(middle), $"{field.Name} within its range");
                if (property.PropertyType != typeof(float))
                    continue;

                // Set or written, what is no number reads the same.
                bool isTaken = TrySet(property, component, float.NaN, out float none);
                Assert.That(!isTaken || float.IsNaN(none) || none >= low && none <= high, property.Name);
                field.SetValue(component, float.NaN);
                Assert.That(Read(property, component), isTaken ? Is.EqualTo(none) : Is.InRange(low, high), $"{field.Name} is no number");
                field.SetValue(component, middle);
            }

            Assert.That(tried, Is.Positive);
        }

        private static IEnumerable<(PropertyInfo, FieldInfo)> Numbers(Type type)
        {
            foreach (PropertyInfo property in type.GetProperties(BindingFlags.Instance | BindingFlags.Public | BindingFlags.DeclaredOnly))
            {
                FieldInfo field = type.GetField("m_" + property.Name, BindingFlags.Instance | BindingFlags.NonPublic);
                bool isNumber = property.PropertyType == typeof(float) || property.PropertyType == typeof(int);
                if (isNumber && property.CanWrite && property.GetSetMethod() != null && field?.FieldType == property.PropertyType)
                    yield return (property, field);
            }
        }

        // False where the property refuses the value.
        private static bool TrySet(PropertyInfo property, Component component, float value, out float read)
        {
            read = float.NaN;
            try
            {
                property.SetValue(component, Convert.ChangeType(value, property.PropertyType));
            }
            catch (TargetInvocationException refused) when (refused.InnerException is ArgumentException)
            {
                return false;
            }

            read = Read(property, component);
            return true;
        }

        private static float Read(PropertyInfo property, Component component) => Convert.ToSingle(property.GetValue(component));
    }
}
