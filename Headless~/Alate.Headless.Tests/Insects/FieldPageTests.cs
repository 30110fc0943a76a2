using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using Alate.Crowds;
using Alate.Flight;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Fields that the inspector shows, against the rows of the pages that promise them.</summary>
    public sealed class FieldPageTests
    {
        private static readonly (Type Type, string Page, string Heading)[] s_Groups =
        [
            (typeof(InsectWings), "insect-wings", "Insect"),
            (typeof(Wing), "insect-wings", "Each wing"),
            (typeof(InsectSteering), "insect-wings", "Steering"),
            (typeof(InsectMotion), "insect-wings", "Motion"),
            (typeof(InsectAir), "insect-wings", "Air"),
            (typeof(InsectQuality), "insect-wings", "Quality"),
            (typeof(ScreenHeights), "insect-wings", "Quality"),
            (typeof(PresetKinematics), "wing-preset", "Kinematics"),
            (typeof(PresetRest), "wing-preset", "Rest"),
            (typeof(WanderSettings), "pilots", "Wander"),
            (typeof(PerchSettings), "pilots", "Perch"),
            (typeof(FollowPilot), "pilots", "Follow Pilot"),
            (typeof(FlockSettings), "pilots", "Flock Pilot"),
            (typeof(ObstacleSettings), "pilots", "Obstacles"),
            (typeof(InsectCrowd), "crowds", "Crowds"),
            (typeof(CrowdSpawner), "crowds", "Crowds"),
            (typeof(FlockCrowd), "crowds", "Crowds"),
        ];

        private static IEnumerable<TestCaseData> Groups => s_Groups.Select(group => new TestCaseData(group.Type, group.Page, group.Heading).SetArgDisplayNames(group.Type.Name));

        [TestCaseSource(nameof(Groups))]
        public void EveryField_HasARow_WithItsRangeAndDefault(Type type, string page, string heading)
        {
            var table = new PageTable(page, heading);
            object normal = type.GetProperty("Default", BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic)?.GetValue(null);
            foreach (FieldInfo field in Fields(type))
            {
                Assert.That(table.Cell(field.Name, ""), Is.Not.Null, $"{type.Name}.{field.Name} has no row under '{heading}' of {page}.md.");
                string range = table.Cell(field.Name, "range"), value = table.Cell(field.Name, "default");
                if (field.GetCustomAttribute<UnityEngine.RangeAttribute>() is { } bounds && range != "")
                    Assert.That(PageTable.Range(range), Is.EqualTo(new double?[] { bounds.min, bounds.max }).Within(1e-4).Percent, field.Name);
                if (normal != null && field.FieldType == typeof(float) && value != "")
                    Assert.That(PageTable.Number(value), Is.EqualTo((float)field.GetValue(normal)).Within(1e-4).Percent, field.Name);
            }
        }

        // A group within a component has a table of its own.
        private static IEnumerable<FieldInfo> Fields(Type type) => type.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic)
            .Where(field => field.IsPublic || field.IsDefined(typeof(SerializeField)))
            .Where(field => !field.IsDefined(typeof(HideInInspector)) && !field.IsDefined(typeof(NonSerializedAttribute)) && s_Groups.All(group => group.Type != field.FieldType));
    }
}
