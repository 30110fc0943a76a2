using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using Alate.Crowds;
using Alate.Flight;
using Alate.Sound;
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
            (typeof(InsectPreview), "animation", "Scrub without playing"),
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
            (typeof(InsectHum), "sound", "Insect Hum"),
        ];

        /// <summary>Headings of the columns that may have the ends of a slider.</summary>
        private static readonly string[] s_RangeColumns = ["range", "unit, range", "ends"];

        private static IEnumerable<TestCaseData> Groups =>
            s_Groups.Select(group => new TestCaseData(group.Type, group.Page, group.Heading).SetArgDisplayNames(group.Type.Name));

        [TestCaseSource(nameof(Groups))]
        public void EveryField_HasARow_WithItsRangeAndDefault(Type type, string page, string heading)
        {
            var table = new PageTable(page, heading);
            object normal = Normal(type);
            foreach (FieldInfo field in Fields(type))
            {
                Assert.That(
                    table.Cell(field.Name, ""), Is.Not.Null, $"{type.Name}.{field.Name} has no row under '{heading}' of {page}.md.");
                if (field.GetCustomAttribute<UnityEngine.RangeAttribute>() is { } bounds)
                {
                    string range = s_RangeColumns.Select(column => table.Cell(field.Name, column)).First(cell => cell != "");
                    Assert.That(PageTable.Numbers(range), Is.SupersetOf(new[] { Written(bounds.min), Written(bounds.max) }),
                        $"{field.Name}: range");
                }

                string value = table.Cell(field.Name, "default");
                if (field.FieldType == typeof(float) && value != "" && value != "none")
                    Assert.That(PageTable.Numbers(value), Has.Member(Written((float)field.GetValue(normal))), $"{field.Name}: default");
            }

            if (normal is Component component)
                UnityEngine.Object.DestroyImmediate(component.gameObject);
        }

        // Settings have their defaults in one place, groups within them there too; components and classes in their fields.
        private static object Normal(Type type)
        {
            if (typeof(Component).IsAssignableFrom(type))
            {
                var holder = new GameObject(type.Name);
                holder.SetActive(false);
                return holder.AddComponent(type);
            }

            return DefaultOf(type)
                ?? s_Groups.SelectMany(group => group.Type.GetFields(), (group, field) => (Settings: DefaultOf(group.Type), Field: field))
                .Where(place => place.Settings != null && place.Field.FieldType == type)
                .Select(place => place.Field.GetValue(place.Settings)).FirstOrDefault() ?? Activator.CreateInstance(type);
        }

        private static object DefaultOf(Type type) =>
            type.GetProperty("Default", BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic)?.GetValue(null);

        private static double Written(float value) => Math.Round(value, 6);

        // A group within a component has a table of its own.
        private static IEnumerable<FieldInfo> Fields(Type type) =>
            type.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic)
            .Where(field => field.IsPublic || field.IsDefined(typeof(SerializeField)))
            .Where(field => !field.IsDefined(typeof(HideInInspector)) && !field.IsDefined(typeof(NonSerializedAttribute))
                && s_Groups.All(group => group.Type != field.FieldType));
    }
}
