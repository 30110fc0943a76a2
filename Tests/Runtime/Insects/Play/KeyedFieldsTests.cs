using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using Alate.Catalogue;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play
{
    /// <summary>
    /// Serialised numbers that an Animation window or Timeline keys: it writes the fields, and each must act from the next step on. Insects
    /// in one place, alike but for one number, come out alike to the bit unless the number acts.
    /// </summary>
    public sealed class KeyedFieldsTests : PlayFixture
    {
        // What is not the beat, and why a key has no effect on it.
        private static readonly Dictionary<string, string> s_Exceptions = new Dictionary<string, string>
        {
            ["m_UpdateMode"] = "who steps, not how",
            ["m_StartPhase"] = "where a beat starts, when it starts",
            ["m_Submesh"] = "which part of the mesh the wing is",
            ["m_Point"] = "a place on the wing, where one part of the mesh holds several",
            ["m_Part"] = "how the part of the mesh is named",
            ["m_Side"] = "checked when the insect starts to live, and on a change of the list",
            ["m_Pair"] = "which wing leads, where there are four",
            ["m_IsFilledIn"] = "of the editor",
            ["m_Motion.source"] = "where the velocity comes from; all are 0 here",
            ["m_Motion.onTeleport"] = "jumps alone",
            ["m_Motion.teleportDistance"] = "jumps alone",
            ["m_Motion.teleportAngle"] = "jumps alone",
            ["m_Quality.levelOfDetail"] = "by the height on the screen: no camera here",
            ["m_Quality.screenHeights.fewerSubstepsBelow"] = "by the height on the screen",
            ["m_Quality.screenHeights.coarsePatchesBelow"] = "by the height on the screen",
            ["m_Quality.screenHeights.wavesOnlyBelow"] = "by the height on the screen",
            ["m_Quality.screenHeights.restBelow"] = "by the height on the screen",
            ["m_Quality.culling"] = "whether cameras see it",
            ["m_Quality.keepForces"] = "where cameras do not see it",
            ["m_Quality.motionVectors"] = "what shaders read besides the wings",
            ["m_Air.windZones"] = "no wind zone here",
            ["m_Seed"] = "the track as a whole, when it starts",
            ["m_FromStart"] = "where the volume is, when the track starts",
            ["m_Aid"] = "after a tumble alone",
            ["m_Volume.m_Shape"] = "which the insect does not reach here",
        };

        [UnityTest]
        public IEnumerator EveryNumberOfAnInsect_ActsFromTheNextStep()
        {
            var paths = Numbers(typeof(InsectWings), "").Concat(Numbers(typeof(Wing), "")).ToList();
            yield return Compare(paths, MovingInsect, (insect, path) => Write(Holder(insect, path), path), 2);
        }

        [UnityTest]
        public IEnumerator EveryNumberOfAFlight_ActsFromTheNextStep()
        {
            var paths = Numbers(typeof(InsectFlight), "").ToList();
            yield return Compare(paths, () => Flying(null), (insect, path) => Write(insect.GetComponent<InsectFlight>(), path), 60);
        }

        [UnityTest]
        public IEnumerator EveryNumberOfAWander_ActsWhileItFlies()
        {
            var paths = Numbers(typeof(WanderPilot), "").Where(path => !path.StartsWith("m_Obstacles")).ToList();
            yield return Compare(
                paths, () => Flying(typeof(WanderPilot)), (insect, path) => Write(insect.GetComponent<WanderPilot>(), path), 180);
        }

        private IEnumerator Compare(List<string> paths, Func<InsectWings> make, Action<InsectWings, string> write, int frames)
        {
            Assert.That(paths, Has.Count.GreaterThan(2));
            var insects = paths.Select(_ => make()).ToList();
            InsectWings same = make();
            yield return Frames(20);
            Assert.That(insects.Select(StateOf).Distinct().Count(), Is.EqualTo(1), "alike before");
            for (int k = 0; k < paths.Count; k++)
                write(insects[k], paths[k]);
            yield return Frames(frames);

            string plain = StateOf(same);
            string[] idle = paths.Where((path, k) => StateOf(insects[k]) == plain).ToArray();
            Assert.That(idle.Where(path => !s_Exceptions.ContainsKey(path)), Is.Empty, "numbers without effect");
        }

        private InsectWings MovingInsect()
        {
            InsectWings insect = Insect();
            insect.Motion.source = VelocitySource.Script;
            insect.Velocity = new Vector3(1f, 2f, 9f);
            return insect;
        }

        private InsectWings Flying(Type pilot)
        {
            InsectDefinition species = InsectCatalogue.Find("monarch");
            InsectWings wings = Keep(InsectFactory.Create(species, InsectVariant.Flight).gameObject).GetComponent<InsectWings>();
            wings.Quality.culling = WingCulling.AlwaysSimulate;
            InsectFlight flight = CatalogueFlight.AddTo(wings, species);
            flight.Heading = 0.4f;
            if (pilot == null)
                return wings;
            Component added = wings.gameObject.AddComponent(pilot);
            Field(pilot, "m_Seed").SetValue(added, 7);
            return wings;
        }

        private static string StateOf(InsectWings insect)
        {
            var words = new List<string> { Bits(insect.transform.position), Bits(insect.AirForce), insect.Phase.ToString("R") };
            for (int wing = 0; wing < insect.Wings.Count; wing++)
            {
                WingReading reading = insect.Read(wing);
                for (int chain = 0; chain < reading.ChainCount; chain++)
                    words.Add(Bits(reading.JointPosition(chain, reading.JointsPerChain - 1)));
            }

            return string.Join(" ", words);
        }

        private static string Bits(float3 place) => $"{math.asint(place.x):x} {math.asint(place.y):x} {math.asint(place.z):x}";

        // Numbers of a type and of the groups in it, as the engine serialises them.
        private static IEnumerable<string> Numbers(Type type, string before)
        {
            foreach (FieldInfo field in type.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic))
            {
                if (field.IsInitOnly || (!field.IsPublic && field.GetCustomAttribute<SerializeField>() == null))
                    continue;
                Type kind = field.FieldType;
                if (kind == typeof(float) || kind == typeof(int) || kind == typeof(bool) || kind == typeof(Vector3) || kind.IsEnum)
                {
                    yield return before + field.Name;
                }
                else if (kind.GetCustomAttribute<SerializableAttribute>() != null && !kind.IsGenericType && !kind.IsArray)
                {
                    foreach (string number in Numbers(kind, before + field.Name + "."))
                        yield return number;
                }
            }
        }

        private static object Holder(InsectWings insect, string path) =>
            Field(typeof(InsectWings), path.Split('.')[0]) != null ? (object)insect : insect.Wings[0];

        private static void Write(object holder, string path)
        {
            string[] names = path.Split('.');
            FieldInfo field = Field(holder.GetType(), names[0]);
            if (names.Length == 1)
            {
                field.SetValue(holder, Other(field, field.GetValue(holder)));
                return;
            }

            object group = field.GetValue(holder);
            Write(group, string.Join(".", names.Skip(1)));
            field.SetValue(holder, group);
        }

        private static FieldInfo Field(Type type, string name)
        {
            for (; type != null; type = type.BaseType)
            {
                FieldInfo field = type.GetField(name, BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic);
                if (field != null)
                    return field;
            }

            return null;
        }

        // Another value within the range.
        private static object Other(FieldInfo field, object value)
        {
            UnityEngine.RangeAttribute range = field.GetCustomAttribute<UnityEngine.RangeAttribute>();
            switch (value)
            {
                case bool flag: return !flag;
                case Vector3 vector: return vector + new Vector3(0.4f, 0.3f, 0.5f);
                case int number when range == null: return number + 41;
                case int number: return (int)math.lerp(range.min, range.max, number > 0.5f * (range.min + range.max) ? 0.25f : 0.75f);
                case float number when range == null: return 1.5f * number + 0.2f;
                case float number:
                    bool isHigh = number > 0.5f * (range.min + range.max);
                    return isHigh ? math.lerp(range.min, number, 0.5f) : math.lerp(number, range.max, 0.3f);
                default: return Enum.GetValues(field.FieldType).Cast<object>().First(other => !other.Equals(value));
            }
        }
    }
}
