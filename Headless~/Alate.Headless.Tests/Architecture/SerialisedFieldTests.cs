using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using Alate.Samples;
using NUnit.Framework;
using UnityEngine;
using RangeAttribute = UnityEngine.RangeAttribute;

namespace Alate.Tests.Architecture
{
    /// <summary>Fields that an inspector shows: what stands above one must be of use there.</summary>
    public sealed class SerialisedFieldTests
    {
        private const BindingFlags k_All = BindingFlags.Instance | BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic
            | BindingFlags.DeclaredOnly;

        private static IEnumerable<FieldInfo> Shown => Rooms.Assemblies.Keys.Select(Assembly.Load).Append(typeof(GardenSample).Assembly)
            .SelectMany(assembly => assembly.GetTypes()).SelectMany(type => type.GetFields(k_All))
            .Where(one => new[] { typeof(SerializeField), typeof(RangeAttribute), typeof(TooltipAttribute) }
                .Any(attribute => one.IsDefined(attribute)));

        [Test]
        public void AttributesOfTheInspector_StandAtFieldsThatUnityKeeps()
        {
            Assert.That(Shown.Count(), Is.GreaterThan(100));
            Assert.That(Names(Shown.Where(one => one.IsInitOnly || one.IsStatic || one.IsLiteral
                || !(one.IsPublic || one.IsDefined(typeof(SerializeField))))), Is.Empty);
        }

        [Test]
        public void Ranges_StandAtNumbers() => Assert.That(Names(Shown.Where(one => one.IsDefined(typeof(RangeAttribute))
            && one.FieldType != typeof(float) && one.FieldType != typeof(int))), Is.Empty);

        private static IEnumerable<string> Names(IEnumerable<FieldInfo> fields) =>
            fields.Select(one => $"{one.DeclaringType.Name}.{one.Name}");
    }
}
